#pragma once
/// Compiles a function a second time for wider registers and lets the machine choose at the start of the program. The
/// operations and their order are the same in both, and products are not fused with sums, so the bits are the same too.

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define NILAS_WIDE_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define NILAS_WIDE_CLONES
#endif

/// Before a loop whose turns do not depend on each other, whatever its pointers.
#if defined(__GNUC__) && !defined(__clang__)
#define NILAS_INDEPENDENT _Pragma("GCC ivdep")
#else
#define NILAS_INDEPENDENT
#endif
