// What the wide loops of this folder have in common: for whom they are compiled, and what the compiler may
// assume.
#pragma once

#ifndef NUTSHELL_WIDE  // a test compiles the loops again with its own choice
#if defined(__x86_64__) && defined(__gnu_linux__) && \
    !defined(__clang__)  // clang 14 names its clones in its own way
#define NUTSHELL_WIDE __attribute__((target_clones("default", "avx2")))
#else
#define NUTSHELL_WIDE
#endif
#endif

#ifdef __clang__
#define INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#else
#define INDEPENDENT _Pragma("GCC ivdep")
#endif
