// What the wide loops of kernels/ have in common: for whom they are compiled, and what the
// compiler may assume. (clang 14 names its clones in its own way, so it compiles one for every
// machine. A test sets both for itself.)
#pragma once

#ifndef NUTSHELL_WIDE
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__)
#define NUTSHELL_WIDE __attribute__((target_clones("default", "avx2")))
#else
#define NUTSHELL_WIDE
#endif
#endif

#ifndef INDEPENDENT
#ifdef __clang__
#define INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#else
#define INDEPENDENT _Pragma("GCC ivdep")
#endif
#endif
