#include "core/numerics/nonlinear_solve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace nonlinear_solve_test {

using namespace nilas;
using namespace nilas::numerics;

TEST(NonlinearSolve, CircleAndParabola) {
  const auto equations = [](const VecX& x, VecX& f) { f << x[0] * x[0] + x[1] * x[1] - 2, x[1] - x[0] * x[0]; };
  const auto solution = solve_nonlinear(equations, VecX{{3.0, 0.5}});
  ASSERT_TRUE(solution.converged) << solution.message;
  EXPECT_NEAR(solution.x[0], 1, 1e-12);
  EXPECT_NEAR(solution.x[1], 1, 1e-12);
}

/// Newton's own step from here overshoots ever farther; the line search holds it.
TEST(NonlinearSolve, LineSearchTamesTheArctangent) {
  const auto equations = [](const VecX& x, VecX& f) { f[0] = std::atan(x[0]); };
  const auto solution = solve_nonlinear(equations, VecX{{3.0}}, {.longest_step = 100});
  ASSERT_TRUE(solution.converged) << solution.message;
  EXPECT_NEAR(solution.x[0], 0, 1e-12);
}

TEST(NonlinearSolve, SaysWhereThereIsNoSolution) {
  const auto equations = [](const VecX& x, VecX& f) { f[0] = 1 + x[0] * x[0]; };
  const auto solution = solve_nonlinear(equations, VecX{{0.7}});
  EXPECT_FALSE(solution.converged);
  EXPECT_FALSE(solution.message.empty());
  EXPECT_GE(solution.residual, 1);
}

TEST(NonlinearSolve, AThrowFromTheEquationsComesThrough) {
  const auto equations = [](const VecX&, VecX&) { throw InputError("no"); };
  EXPECT_THROW(solve_nonlinear(equations, VecX{{0.7}}), InputError);
}

}  // namespace nonlinear_solve_test
