#include <gtest/gtest.h>

#include <cmath>

#include "contact/measure/measure.h"
#include "contact/solvers/bodies/interior_on_bodies.h"
#include "contact/solvers/linear/padded_block.h"
#include "contact/solvers/linear/wide_clones.h"
#include "tests/contact/solvers/bodies/island_with_vessel.h"
#include "tests/contact/solvers/bodies/kernels/kernels_here.h"
#include "tests/contact/solvers/bodies/kernels/run_kernels.h"

std::vector<double> nilas::test::kernel_results(const contact::ContactProblem& problem) {
  return nilas::solvers::run_kernels(problem);
}

namespace kernels_test {

using namespace nilas;

bool has_avx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

/// Eight numbers at a time, four, or one: the operations on each number are the same, in the same order, and products
/// are not fused with sums. So a run has the same bits on processors with AVX-512, with AVX2 and with neither.
TEST(Kernels, RegistersOfAnyWidthGiveTheSameBits) {
  contact::ContactProblem yielding = test::largest_island(test::raft(9, 0.25, 1, 3));
  for (std::size_t c = 0; c < yielding.pairs.size(); c += 3) yielding.force_limit[c] = 0.1;
  for (const auto& problem : {test::largest_island(test::heap_with_vessel(4, 40, 120, 0.3)), yielding}) {
    const std::vector<double> here = test::kernel_results(problem), plain = test::plain_kernel_results(problem);
    ASSERT_EQ(here.size(), plain.size());
    EXPECT_EQ(std::memcmp(here.data(), plain.data(), here.size() * sizeof(double)), 0)
        << (has_widest_registers() ? "AVX-512" : "the registers of this machine");
    if (!has_avx2()) continue;
    const std::vector<double> four = test::avx2_kernel_results(problem);
    ASSERT_EQ(four.size(), plain.size());
    EXPECT_EQ(std::memcmp(four.data(), plain.data(), four.size() * sizeof(double)), 0) << "AVX2";
  }
}

}  // namespace kernels_test
