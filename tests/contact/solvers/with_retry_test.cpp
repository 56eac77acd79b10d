#include "contact/solvers/with_retry.h"

#include <gtest/gtest.h>

#include "contact/registry.h"
#include "tests/support/problems/cone_problems.h"

namespace nilas::solvers {
namespace with_retry_test {

constexpr double k_tolerance = 1e-9;

WithRetry few_sweeps_then(const char* second, int iterations) {
  return {contact::find_solver("nsgs").make({.tolerance = k_tolerance, .max_iterations = 5}),
          contact::find_solver(second).make({.tolerance = k_tolerance, .max_iterations = iterations})};
}

TEST(WithRetry, TheSecondGoesOnWhereTheFirstFails) {
  const contact::ContactProblem problem = test::box_stack(test::growing_masses(10, 1e3), 0.5);
  const contact::ContactSolution solution = few_sweeps_then("auto", 1000).solve(problem, {});
  EXPECT_EQ(solution.status, contact::SolveStatus::converged);
  EXPECT_LE(contact::measure(problem, solution.r).law_map_m_s, k_tolerance);
  EXPECT_GT(solution.iterations, 5);
  EXPECT_NE(solution.message.find("retried with auto"), std::string::npos);
}

TEST(WithRetry, TheSecondIsNotAskedWhereTheFirstConverges) {
  const contact::ContactProblem problem = test::particle(Law::coulomb, 2, 0.5, {-1, 3, 0});
  const contact::ContactSolution solution = few_sweeps_then("auto", 1000).solve(problem, {});
  EXPECT_EQ(solution.status, contact::SolveStatus::converged);
  EXPECT_EQ(solution.message, "");
}

TEST(WithRetry, TheBetterOfTwoFailuresStays) {
  const contact::ContactProblem problem = test::box_stack(test::growing_masses(10, 1e3), 0.5);
  const contact::LocalProblem local = contact::reduce(problem);
  const auto sweeps = contact::find_solver("nsgs").make({.tolerance = k_tolerance, .max_iterations = 5});
  const double first = contact::measure(problem, sweeps->solve(local, {}).r).law_map_m_s;
  for (const char* second : {"eg", "apgd", "ipm", "admm"}) {
    const contact::ContactSolution solution = few_sweeps_then(second, 1).solve(local, {});
    EXPECT_LE(contact::measure(problem, solution.r).law_map_m_s, first * (1 + 1e-9)) << second;
  }
}

}  // namespace with_retry_test
}  // namespace nilas::solvers
