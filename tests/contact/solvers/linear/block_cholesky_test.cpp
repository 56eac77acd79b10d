#include "contact/solvers/linear/block_cholesky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/random.h"

namespace nilas::solvers {
namespace block_cholesky_test {

Mat3 random_block(RandomStream& random) {
  Mat3 block;
  for (int k = 0; k < 9; ++k) block.data()[k] = random.normal();
  return block;
}

/// Contacts of `bodies` bodies: W = H^T H, singular when contacts outnumber bodies.
Eigen::SparseMatrix<double> random_delassus(int contacts, int bodies, RandomStream& random) {
  MatX h = MatX::Zero(3 * bodies, 3 * contacts);
  for (int c = 0; c < contacts; ++c)
    for (const double where : {random.uniform(), random.uniform()})
      h.block<3, 3>(3 * static_cast<int>(where * bodies), 3 * c) = random_block(random);
  const MatX w = h.transpose() * h;
  std::vector<Eigen::Triplet<double>> entries;
  for (int a = 0; a < contacts; ++a)
    for (int b = 0; b < contacts; ++b) {
      if (a != b && w.block<3, 3>(3 * a, 3 * b).isZero(0)) continue;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) entries.emplace_back(3 * a + i, 3 * b + j, w(3 * a + i, 3 * b + j));
    }
  Eigen::SparseMatrix<double> sparse(3 * contacts, 3 * contacts);
  sparse.setFromTriplets(entries.begin(), entries.end());
  return sparse;
}

std::vector<Mat3> random_definite(int count, double spread, RandomStream& random) {
  std::vector<Mat3> blocks;
  for (int k = 0; k < count; ++k) {
    const Mat3 root = random_block(random);
    const double size = std::pow(10.0, random.uniform(-spread, spread));
    blocks.push_back(size * (root * root.transpose() + Mat3::Identity()));
  }
  return blocks;
}

MatX block_diagonal(const std::vector<Mat3>& blocks) {
  const auto n = static_cast<Eigen::Index>(blocks.size());
  MatX all = MatX::Zero(3 * n, 3 * n);
  for (Eigen::Index k = 0; k < n; ++k) all.block<3, 3>(3 * k, 3 * k) = blocks[k];
  return all;
}

TEST(BlockCholesky, SolvesWhatADenseFactorisationSolves) {
  RandomStream random(1, "cholesky");
  for (const auto& [contacts, bodies] : {std::pair{1, 1}, {5, 2}, {12, 60}, {60, 20}, {150, 100}, {150, 600}}) {
    const auto a = random_delassus(contacts, bodies, random);
    BlockCholesky factors(a);
    for (const double spread : {0.0, 3.0}) {  // The second one reuses the plan.
      const auto inverse = random_definite(contacts, spread, random);
      const std::vector<Mat3> added(static_cast<std::size_t>(contacts), Mat3::Identity());
      ASSERT_TRUE(factors.factor(inverse, added)) << contacts;
      const MatX p = block_diagonal(inverse);
      const MatX matrix = p * MatX(a) * p + MatX::Identity(3 * contacts, 3 * contacts);
      const VecX b = VecX::LinSpaced(3 * contacts, -1, 2);
      const VecX truth = matrix.llt().solve(b);
      EXPECT_LT((factors.solve(b) - truth).norm(), 1e-6 * truth.norm()) << contacts << " " << spread;
      EXPECT_LT((matrix * factors.solve(b) - b).norm(), 1e-6 * b.norm()) << contacts << " " << spread;
      if (spread == 0) {
        EXPECT_LT((factors.solve_unrefined(b) - truth).norm(), 1e-10 * truth.norm()) << contacts;
      }
    }
  }
}

TEST(BlockCholesky, SaysWhenTheMatrixIsNotPositiveDefiniteAndGoesOn) {
  RandomStream random(2, "cholesky");
  for (const auto& [contacts, bodies] : {std::pair{3, 6}, {40, 80}, {60, 20}}) {
    const auto a = random_delassus(contacts, bodies, random);
    BlockCholesky factors(a);
    const std::vector<Mat3> unit(static_cast<std::size_t>(contacts), Mat3::Identity());
    for (std::size_t where = 0; where < unit.size(); ++where)
      for (const double bad : {-1e3, std::numeric_limits<double>::quiet_NaN()}) {
        auto added = unit;
        added[where](1, 1) = bad;
        EXPECT_FALSE(factors.factor(unit, added)) << contacts << " " << where;
      }
    ASSERT_TRUE(factors.factor(unit, unit));
    const VecX b = VecX::Ones(3 * contacts);
    const VecX x = factors.solve(b);
    EXPECT_LT((a * x + x - b).norm(), 1e-10 * b.norm());
  }
}

}  // namespace block_cholesky_test
}  // namespace nilas::solvers
