#include "contact/solvers/newton/rounded_solve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/random.h"

namespace nilas::solvers {
namespace rounded_solve_test {

struct Rows {
  std::vector<int> row_start{0}, column;
  std::vector<Mat3> block;
  BlockRows view() const { return {row_start, column, block}; }
};

/// A chain with some far couplings; `weight` on the diagonal of an otherwise rank-deficient matrix sets the condition.
Rows coupled(int n, double weight) {
  RandomStream random(static_cast<std::uint64_t>(n), "coupled");
  std::vector<Eigen::Matrix<double, 3, 6>> factor;
  for (int i = 0; i < n; ++i) {
    factor.emplace_back();
    for (int k = 0; k < 18; ++k) factor.back().data()[k] = random.normal();
  }
  Rows out;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      out.column.push_back(j);
      out.block.emplace_back(factor[i] * factor[j].transpose());
      if (i == j) out.block.back() += weight * Mat3::Identity();
    }
    out.row_start.push_back(static_cast<int>(out.column.size()));
  }
  return out;
}

/// The permuted matrix: row k is row order[k] of `rows`, every second row of blocks with the signs of a mirror.
Rows permuted(const Rows& rows, const std::vector<int>& order) {
  const int n = static_cast<int>(order.size());
  Rows out;
  const Vec3 signs(1, -1, 1);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto from = static_cast<std::size_t>(order[i] * n + order[j]);
      out.column.push_back(j);
      out.block.emplace_back(signs.asDiagonal() * rows.block[from] * signs.asDiagonal());
    }
    out.row_start.push_back(static_cast<int>(out.column.size()));
  }
  return out;
}

VecX solved(const Rows& rows, VecX b, bool& good) {
  BlockLu factors;
  factors.analyse(rows.row_start, rows.column);
  good = factors.factorise(rows.block) && solve_rounded(rows.view(), factors, b);
  return b;
}

/// The matrix is rank-deficient without the weight, as for hyperstatic contact: plain factors differ in the eighth
/// digit there.
TEST(RoundedSolve, ForgetsTheOrderOfEliminationAndTheMirror) {
  for (const double weight : {1.0, 1e-3, 1e-6, 1e-8}) {
    const int n = 12;
    const Rows rows = coupled(n, weight);
    RandomStream random(5, "right side");
    VecX b(3 * n);
    for (double& x : b) x = random.normal();
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    bool good = false;
    const VecX one = solved(rows, b, good);
    ASSERT_TRUE(good) << weight;
    for (int k = 0; k < 20; ++k) {
      std::rotate(order.begin(), order.begin() + 1 + k % 3, order.end());
      std::swap(order[0], order[1 + k % (n - 1)]);
      VecX c(3 * n);
      const Vec3 signs(1, -1, 1);
      for (int i = 0; i < n; ++i) c.segment<3>(3 * i) = signs.cwiseProduct(b.segment<3>(3 * order[i]));
      const VecX two = solved(permuted(rows, order), c, good);
      ASSERT_TRUE(good) << weight;
      for (int i = 0; i < n; ++i)
        EXPECT_EQ(Vec3(signs.cwiseProduct(two.segment<3>(3 * i))), Vec3(one.segment<3>(3 * order[i]))) << weight;
    }
  }
}

TEST(RoundedSolve, IsTheSolutionToElevenDigits) {
  const int n = 8;
  const Rows rows = coupled(n, 0.1);
  MatX dense(3 * n, 3 * n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) dense.block<3, 3>(3 * i, 3 * j) = rows.block[i * n + j];
  const VecX b = VecX::LinSpaced(3 * n, -1, 2);
  bool good = false;
  const VecX x = solved(rows, b, good);
  ASSERT_TRUE(good);
  EXPECT_LT((x - dense.fullPivLu().solve(b)).norm(), 1e-10 * x.norm());
}

TEST(RoundedSolve, RefusesWhatIsSingular) {
  bool good = true;
  VecX b = VecX::Zero(36);
  b[3] = 1;
  solved(coupled(12, 0), b, good);
  EXPECT_FALSE(good);
}

TEST(RoundedSolve, OfNothingIsNothing) {
  bool good = false;
  const VecX x = solved(coupled(3, 1), VecX::Zero(9), good);
  EXPECT_TRUE(good);
  EXPECT_TRUE(x.isZero(0));
}

}  // namespace rounded_solve_test
}  // namespace nilas::solvers
