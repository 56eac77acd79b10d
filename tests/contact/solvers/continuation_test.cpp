#include "contact/solvers/continuation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/problems/problem_factory.h"

namespace nilas::solvers {
namespace continuation_test {

TEST(Continuation, ReachesFullFriction) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const contact::LocalProblem problem = contact::reduce(test::random_heap(seed, 8, 16, 0.6));
    const contact::ContactSolution solution =
        solve_islands(problem, {}, [](const contact::LocalProblem& island, const VecX&) {
          const contact::SolverSettings shared{.tolerance = 1e-10};
          return continue_in_friction(island, {.shared = shared}, Budget(shared));
        });
    EXPECT_EQ(solution.status, contact::SolveStatus::converged) << seed;
    EXPECT_LE(contact::measure(problem, solution.r).natural_map_m_s, 1e-10) << seed;
  }
}

/// Largest share of mu r_N that friction uses. It is the s of the problem that the impulses solve, if any contact
/// slips.
double friction_share(const contact::LocalProblem& problem, const VecX& r) {
  double share = 0;
  for (int c = 0; c < problem.num_contacts(); ++c)
    if (r[3 * c] > 1e-9) share = std::max(share, r.segment<2>(3 * c + 1).norm() / (problem.mu[c] * r[3 * c]));
  return share;
}

class ContinuationLimits : public testing::Test {
 protected:
  static constexpr double k_tolerance = 1e-12;

  contact::ContactSolution solve(int most, double seconds = 0) const {
    const contact::SolverSettings shared{.tolerance = k_tolerance, .max_iterations = most, .max_seconds = seconds};
    return continue_in_friction(problem_, {.shared = shared}, Budget(shared));
  }

  const contact::LocalProblem problem_ = contact::reduce(test::raft(8, 0.6, 1, 2));
};

TEST_F(ContinuationLimits, EndsWithinTheFirstSweeps) {
  const contact::ContactSolution solution = solve(30);
  EXPECT_EQ(solution.status, contact::SolveStatus::iteration_limit);
  EXPECT_EQ(solution.iterations, 30);
  EXPECT_NEAR(friction_share(problem_, solution.r), 0.2, 1e-12);
}

TEST_F(ContinuationLimits, EndsOnThePathWithItsLastSolution) {
  const contact::ContactSolution whole = solve(100000);
  ASSERT_EQ(whole.status, contact::SolveStatus::converged);
  EXPECT_LE(contact::measure(problem_, whole.r).natural_map_m_s, k_tolerance);

  const contact::ContactSolution enough = solve(whole.iterations);
  EXPECT_EQ(enough.status, contact::SolveStatus::converged);
  EXPECT_EQ(enough.r, whole.r);

  const contact::ContactSolution short_of_one = solve(whole.iterations - 1);
  EXPECT_EQ(short_of_one.status, contact::SolveStatus::iteration_limit);
  EXPECT_LT(short_of_one.iterations, whole.iterations);
  const double share = friction_share(problem_, short_of_one.r);
  EXPECT_GT(share, 0.3);
  EXPECT_LT(share, 0.99);
  contact::LocalProblem there = problem_;
  for (double& mu : there.mu) mu *= share;
  // The share is known only up to rounding.
  EXPECT_LE(contact::measure(there, short_of_one.r).natural_map_m_s, 10 * k_tolerance);
  EXPECT_GT(contact::measure(problem_, short_of_one.r).natural_map_m_s, 1e-3);
}

TEST_F(ContinuationLimits, SaysSoWhereverTheyEndIt) {
  for (const int iterations : {201, 205, 210})
    EXPECT_EQ(solve(iterations).status, contact::SolveStatus::iteration_limit);
}

TEST_F(ContinuationLimits, EndsWithItsTime) {
  const contact::ContactSolution solution = solve(100000, 1e-9);
  EXPECT_EQ(solution.status, contact::SolveStatus::iteration_limit);
  EXPECT_LE(solution.iterations, 1);
}

}  // namespace continuation_test
}  // namespace nilas::solvers
