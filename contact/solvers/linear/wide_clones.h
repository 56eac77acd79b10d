#pragma once
/// Compiles a function a second time for wider registers and lets the machine choose at the start of the program. The
/// operations and their order are the same in both, and products are not fused with sums, so the bits are the same too.

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define NILAS_WIDE_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define NILAS_WIDE_CLONES
#endif

/// Compiles a function for registers of eight numbers, to be called where the machine has them. Clones cannot do this:
/// their code would hold eight numbers in one variable on all machines, at a cost where there are no such registers.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define NILAS_WIDEST __attribute__((target("arch=x86-64-v4")))
inline bool has_widest_registers() {
  static const bool has = __builtin_cpu_supports("x86-64-v4");
  return has;
}
#else
#define NILAS_WIDEST
inline bool has_widest_registers() { return false; }
#endif

/// For the body of a function that is compiled both ways: it must be part of them to be compiled for their registers.
#define NILAS_PART_OF_CLONES [[gnu::always_inline]] inline

/// Before a loop whose turns do not depend on each other, whatever its pointers.
#if defined(__GNUC__) && !defined(__clang__)
#define NILAS_INDEPENDENT _Pragma("GCC ivdep")
#else
#define NILAS_INDEPENDENT
#endif
