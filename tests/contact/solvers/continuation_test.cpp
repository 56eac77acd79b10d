#include "contact/solvers/continuation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/problem_factory.h"

namespace nilas {
namespace {

TEST(Continuation, ReachesFullFriction) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const LocalProblem problem = reduce(test::random_heap(seed, 8, 16, 0.6));
    const ContactSolution solution = solve_islands(problem, {}, [](const LocalProblem& island, const VecX&) {
      const SolverSettings shared{.tolerance = 1e-10};
      return continue_in_friction(island, {.shared = shared}, Budget(shared));
    });
    EXPECT_EQ(solution.status, SolveStatus::converged) << seed;
    EXPECT_LE(measure(problem, solution.r).natural_map_m_s, 1e-10) << seed;
  }
}

/// Largest share of mu r_N that friction uses. It is the s of the problem that the impulses solve, if any contact
/// slips.
double friction_share(const LocalProblem& problem, const VecX& r) {
  double share = 0;
  for (int c = 0; c < problem.num_contacts(); ++c)
    if (r[3 * c] > 1e-9) share = std::max(share, r.segment<2>(3 * c + 1).norm() / (problem.mu[c] * r[3 * c]));
  return share;
}

class ContinuationLimits : public testing::Test {
 protected:
  static constexpr double k_tolerance = 1e-12;

  ContactSolution solve(int most, double seconds = 0) const {
    const SolverSettings shared{.tolerance = k_tolerance, .max_iterations = most, .max_seconds = seconds};
    return continue_in_friction(problem_, {.shared = shared}, Budget(shared));
  }

  const LocalProblem problem_ = reduce(test::raft(8, 0.6, 1, 2));
};

TEST_F(ContinuationLimits, EndsWithinTheFirstSweeps) {
  const ContactSolution solution = solve(30);
  EXPECT_EQ(solution.status, SolveStatus::iteration_limit);
  EXPECT_EQ(solution.iterations, 30);
  EXPECT_NEAR(friction_share(problem_, solution.r), 0.2, 1e-12);
}

TEST_F(ContinuationLimits, EndsOnThePathWithItsLastSolution) {
  const ContactSolution whole = solve(100000);
  ASSERT_EQ(whole.status, SolveStatus::converged);
  EXPECT_LE(measure(problem_, whole.r).natural_map_m_s, k_tolerance);

  const ContactSolution enough = solve(whole.iterations);
  EXPECT_EQ(enough.status, SolveStatus::converged);
  EXPECT_EQ(enough.r, whole.r);

  const ContactSolution short_of_one = solve(whole.iterations - 1);
  EXPECT_EQ(short_of_one.status, SolveStatus::iteration_limit);
  EXPECT_LT(short_of_one.iterations, whole.iterations);
  const double share = friction_share(problem_, short_of_one.r);
  EXPECT_GT(share, 0.3);
  EXPECT_LT(share, 0.99);
  LocalProblem there = problem_;
  for (double& mu : there.mu) mu *= share;
  // The share is known only up to rounding.
  EXPECT_LE(measure(there, short_of_one.r).natural_map_m_s, 10 * k_tolerance);
  EXPECT_GT(measure(problem_, short_of_one.r).natural_map_m_s, 1e-3);
}

TEST_F(ContinuationLimits, SaysSoWhereverTheyEndIt) {
  for (const int iterations : {201, 205, 210}) EXPECT_EQ(solve(iterations).status, SolveStatus::iteration_limit);
}

TEST_F(ContinuationLimits, EndsWithItsTime) {
  const ContactSolution solution = solve(100000, 1e-9);
  EXPECT_EQ(solution.status, SolveStatus::iteration_limit);
  EXPECT_LE(solution.iterations, 1);
}

}  // namespace
}  // namespace nilas
