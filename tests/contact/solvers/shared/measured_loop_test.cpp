#include "contact/solvers/shared/measured_loop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace nilas::solvers {
namespace measured_loop_test {

/// Iterations and status of a loop whose residual after n iterations is given.
contact::ContactSolution run(const std::function<double(int)>& residual, int horizon) {
  const contact::SolverSettings settings{.tolerance = 1e-3, .max_iterations = 2000};
  MeasuredLoop loop(settings, Budget(settings), 500, horizon);
  const auto measure = [&] { return residual(loop.iterations()); };
  const auto impulses = [] { return VecX(VecX::Ones(3)); };
  while (loop.goes_on(std::numeric_limits<double>::infinity(), measure, impulses)) {
  }
  return loop.solution(measure, impulses);
}

TEST(MeasuredLoop, EndsEarlyWhereTheToleranceLiesBeyondTheHorizon) {
  const auto slow = [](int n) { return 0.5 / std::max(n, 1); };  // 500 iterations
  EXPECT_EQ(run(slow, 250).status, contact::SolveStatus::stalled);
  EXPECT_LE(run(slow, 250).iterations, 20);
  EXPECT_LE(run(slow, 600).iterations, 10) << "the first forecast is 1000 iterations";
  EXPECT_EQ(run(slow, 1000).status, contact::SolveStatus::converged);
  EXPECT_EQ(run(slow, 0).status, contact::SolveStatus::converged);
}

TEST(MeasuredLoop, GoesOnWhereItPromisesToSuffice) {
  const auto quick = [](int n) { return 1.2 / std::pow(std::max(n, 1), 2); };  // 35 iterations
  const contact::ContactSolution found = run(quick, 250);
  EXPECT_EQ(found.status, contact::SolveStatus::converged);
  EXPECT_GE(found.iterations, 35);
  EXPECT_EQ(run(quick, 30).status, contact::SolveStatus::stalled);
}

TEST(MeasuredLoop, AResidualThatRisesIsBeyondEveryHorizon) {
  EXPECT_LE(run([](int n) { return 1.0 + n; }, 1000).iterations, 20);
}

}  // namespace measured_loop_test
}  // namespace nilas::solvers
