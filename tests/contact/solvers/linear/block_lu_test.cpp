#include "contact/solvers/linear/block_lu.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace nilas::solvers {
namespace block_lu_test {

/// A random matrix of 3 x 3 blocks with full diagonal, asymmetric in values and in pattern.
struct Sparse {
  std::vector<int> row_start{0}, column;
  std::vector<Mat3> block;
  MatX dense;
};

Sparse random_matrix(int n, double share, std::uint64_t seed) {
  RandomStream random(seed, "blocks");
  Sparse out;
  out.dense = MatX::Zero(3 * n, 3 * n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (i != j && random.uniform() > share) continue;
      Mat3 block;
      for (int k = 0; k < 9; ++k) block.data()[k] = random.normal();
      if (i == j) block.diagonal().array() += 6;
      out.column.push_back(j);
      out.block.push_back(block);
      out.dense.block<3, 3>(3 * i, 3 * j) = block;
    }
    out.row_start.push_back(static_cast<int>(out.column.size()));
  }
  return out;
}

TEST(BlockLu, SolvesWhatADenseFactorisationSolves) {
  for (const auto& [n, share] : {std::pair{1, 0.0}, {2, 1.0}, {7, 0.3}, {30, 0.1}, {60, 0.03}, {40, 1.0}, {50, 0.0}}) {
    const Sparse matrix = random_matrix(n, share, static_cast<std::uint64_t>(n));
    BlockLu factors;
    factors.analyse(matrix.row_start, matrix.column);
    ASSERT_TRUE(factors.factorise(matrix.block));
    const VecX b = VecX::LinSpaced(3 * n, -1, 2);
    VecX x = b;
    factors.solve(x);
    EXPECT_LT((matrix.dense * x - b).norm(), 1e-9 * b.norm()) << n;
  }
}

TEST(BlockLu, TakesNewValuesAndNewPatterns) {
  BlockLu factors;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const int n = seed < 2 ? 12 : 25;
    Sparse matrix = random_matrix(n, seed < 2 ? 1.0 : 0.15, seed);
    factors.analyse(matrix.row_start, matrix.column);
    ASSERT_TRUE(factors.factorise(matrix.block));
    const VecX b = VecX::Ones(3 * n);
    VecX x = b;
    factors.solve(x);
    EXPECT_LT((matrix.dense * x - b).norm(), 1e-9);
  }
}

TEST(BlockLu, ReportsSingularBlocksAndRecovers) {
  Sparse matrix = random_matrix(3, 0.0, 1);
  BlockLu factors;
  factors.analyse(matrix.row_start, matrix.column);
  const Mat3 kept = matrix.block[1];
  matrix.block[1].setZero();
  EXPECT_FALSE(factors.factorise(matrix.block));
  matrix.block[1] = kept;
  ASSERT_TRUE(factors.factorise(matrix.block));
  VecX x = VecX::Ones(9);
  factors.solve(x);
  EXPECT_LT((matrix.dense * x - VecX::Ones(9)).norm(), 1e-12);
}

TEST(BlockLu, EmptyMatrix) {
  BlockLu factors;
  factors.analyse({0}, {});
  EXPECT_TRUE(factors.factorise({}));
  VecX x;
  factors.solve(x);
  EXPECT_EQ(x.size(), 0);
}

}  // namespace block_lu_test
}  // namespace nilas::solvers
