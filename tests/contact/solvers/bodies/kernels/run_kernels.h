#pragma once
/// Results of the loops on the bodies and of products of blocks, which contact/solvers compiles for several kinds of
/// registers (linear/wide_clones.h).
#include <cstddef>
#include <cstring>
#include <vector>

#include "contact/problem/problem.h"

namespace nilas::test {

/// As the program runs them on this machine.
std::vector<double> kernel_results(const contact::ContactProblem& problem);
/// Compiled anew without wide registers.
std::vector<double> plain_kernel_results(const contact::ContactProblem& problem);
/// Compiled anew for AVX2, and run with four numbers at a time on any machine. Only where the machine has AVX2.
std::vector<double> avx2_kernel_results(const contact::ContactProblem& problem);

}  // namespace nilas::test
