#include "contact/solvers/continuation.h"

#include <gtest/gtest.h>

#include "tests/support/problem_factory.h"

namespace nilas {
namespace {

TEST(Continuation, ReachesFullFriction) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const LocalProblem problem = reduce(test::random_heap(seed, 8, 16, 0.6));
    const ContactSolution solution = solve_islands(problem, {}, [](const LocalProblem& island, const VecX&) {
      return continue_in_friction(island, {.shared = {.tolerance = 1e-10}});
    });
    EXPECT_EQ(solution.status, SolveStatus::converged) << seed;
    EXPECT_LE(measure(problem, solution.r).natural_map_m_s, 1e-10) << seed;
  }
}

TEST(Continuation, StopsAtItsLimits) {
  const LocalProblem problem = reduce(test::raft(8, 0.6, 1, 2));
  const ContactSolution solution =
      continue_in_friction(problem, {.shared = {.tolerance = 1e-12, .max_iterations = 30}});
  EXPECT_NE(solution.status, SolveStatus::converged);
  EXPECT_LE(solution.iterations, 30);
}

}  // namespace
}  // namespace nilas
