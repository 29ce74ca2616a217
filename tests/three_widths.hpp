// A kernel's source twice more beside the library's own: without_avx2::nutshell::wide is compiled for every
// machine, with_avx2::nutshell::wide must use AVX2. What the kernel includes comes before, outside the
// namespaces; then
//   #define KERNEL "../chapters/NN_name/kernels/NAME.cpp"
//   #define SHARED using ::nutshell::wide::Axes, …      its types, common to the three
//   #include "three_widths.hpp"
#define INDEPENDENT
#define NUTSHELL_WIDE
namespace without_avx2::nutshell::wide {
SHARED;
}
namespace without_avx2 {
#include KERNEL
}
#undef NUTSHELL_WIDE
#if defined(__x86_64__) || defined(__i386__)
#define NUTSHELL_WIDE __attribute__((target("avx2")))
namespace with_avx2::nutshell::wide {
SHARED;
}
namespace with_avx2 {
#include KERNEL
}
#endif
