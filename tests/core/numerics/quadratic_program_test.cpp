#include "core/numerics/quadratic_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "core/base/error.h"
#include "core/base/random.h"

namespace quadratic_program_test {

using namespace nilas;
using numerics::QuadraticProgram;
using numerics::solve_quadratic_program;

/// A random positive definite program whose bounds are `reach` wide on both sides.
QuadraticProgram random_program(int n, RandomStream& stream, double reach) {
  MatX a(n, n);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) a(i, k) = stream.normal();
  QuadraticProgram p;
  p.H = a.transpose() * a + MatX::Identity(n, n);
  p.g = VecX(n);
  for (int i = 0; i < n; ++i) p.g[i] = stream.normal();
  p.lower = VecX::Constant(n, -reach);
  p.upper = VecX::Constant(n, reach);
  p.rows = MatX(0, n);
  return p;
}

// Without an active bound the minimum is that of the linear system H x = -g.
TEST(QuadraticProgram, IsTheLinearSystemWhereNoBoundIsActive) {
  RandomStream stream(1, "programs");
  for (int n = 1; n <= 12; ++n) {
    const QuadraticProgram p = random_program(n, stream, 1e3);
    const auto solution = solve_quadratic_program(p);
    ASSERT_TRUE(solution.converged) << solution.message;
    const VecX known = p.H.ldlt().solve(-p.g);
    EXPECT_LT((solution.x - known).norm(), 1e-9 * (1 + known.norm())) << n;
  }
}

/// The minimum over all choices of unknowns at their lower or upper bound: the free ones solve their linear system.
double least_by_enumeration(const QuadraticProgram& p) {
  const int n = static_cast<int>(p.g.size());
  double least = std::numeric_limits<double>::infinity();
  int choices = 1;
  for (int k = 0; k < n; ++k) choices *= 3;
  for (int c = 0; c < choices; ++c) {
    VecX x = VecX::Zero(n);
    std::vector<int> free;
    for (int k = 0, rest = c; k < n; ++k, rest /= 3) {
      if (rest % 3 == 0) free.push_back(k);
      if (rest % 3 == 1) x[k] = p.lower[k];
      if (rest % 3 == 2) x[k] = p.upper[k];
    }
    if (!free.empty()) {
      const VecX right = -(p.g + p.H * x);
      const MatX block = p.H(free, free);
      const VecX part = right(free);
      const VecX found = block.ldlt().solve(part);
      x(free) = found;
    }
    if ((x.array() >= p.lower.array() - 1e-12).all() && (x.array() <= p.upper.array() + 1e-12).all())
      least = std::min(least, objective(p, x));
  }
  return least;
}

TEST(QuadraticProgram, AgreesWithEnumerationOfActiveBounds) {
  RandomStream stream(2, "programs");
  for (int trial = 0; trial < 40; ++trial) {
    const QuadraticProgram p = random_program(5, stream, 0.05);
    const auto solution = solve_quadratic_program(p);
    ASSERT_TRUE(solution.converged) << solution.message;
    EXPECT_NEAR(objective(p, solution.x), least_by_enumeration(p), 1e-12);
  }
}

// min (x - 1)^2 + (y - 1)^2 with x + y <= 1: the foot of the perpendicular, (1/2, 1/2).
TEST(QuadraticProgram, HoldsARowOfInequalities) {
  QuadraticProgram p;
  p.H = 2 * MatX::Identity(2, 2);
  p.g = VecX::Constant(2, -2);
  p.lower = VecX::Constant(2, -5);
  p.upper = VecX::Constant(2, 5);
  p.rows = MatX::Ones(1, 2);
  p.least = VecX::Constant(1, -std::numeric_limits<double>::infinity());
  p.most = VecX::Ones(1);
  const auto solution = solve_quadratic_program(p);
  ASSERT_TRUE(solution.converged) << solution.message;
  EXPECT_LT((solution.x - VecX::Constant(2, 0.5)).norm(), 1e-7) << "the tolerance of the interior point method";
}

TEST(QuadraticProgram, GivesTheSameBitsAgain) {
  RandomStream stream(3, "programs");
  QuadraticProgram p = random_program(8, stream, 0.1);
  p.rows = MatX::Ones(1, 8);
  p.least = VecX::Constant(1, -0.1);
  p.most = VecX::Constant(1, 0.1);
  EXPECT_EQ(solve_quadratic_program(p).x, solve_quadratic_program(p).x);
}

TEST(QuadraticProgram, RefusesBoundsThatCross) {
  RandomStream stream(4, "programs");
  QuadraticProgram p = random_program(2, stream, 1);
  p.lower[0] = 2;
  EXPECT_THROW(solve_quadratic_program(p), ContractError);
}

}  // namespace quadratic_program_test
