#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/vessel/exponential_mode.h"
#include "core/vessel/stiff_block.h"

namespace nilas {
namespace {

MatX random_spd(RandomStream& random, int n) {
  MatX a(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) a(i, j) = random.normal();
  return a * a.transpose() + MatX::Identity(n, n);
}

TEST(VesselStiffBlock, WithoutSpringIsTheMassMatrix) {
  RandomStream random(1, "block");
  const MatX M = random_spd(random, 4);
  const StiffBlock block = stiff_block(M, MatX::Zero(4, 4), 0, {0, 1, 2, 3}, 0.01);
  EXPECT_LT((block.mass - M).norm(), 1e-14 * M.norm());
  EXPECT_LT((block.response * M - MatX::Identity(4, 4)).norm(), 1e-13);
  EXPECT_LT((block.kept - MatX::Identity(4, 4)).norm(), 1e-13);
}

TEST(VesselStiffBlock, OneCoordinateIsOneMode) {
  const double m = 500, k = 1e6, time = 1e-3, h = 0.01;
  const StiffBlock block = stiff_block(MatX::Constant(1, 1, m), MatX::Constant(1, 1, k), time, {}, h);
  const ExponentialMode mode = exponential_mode(std::sqrt(k / m), time, h);
  EXPECT_NEAR(block.mass(0, 0), m / mode.response, 1e-12 * m);
  EXPECT_NEAR(block.response(0, 0), mode.response / m, 1e-15 / m);
  EXPECT_NEAR(block.kept(0, 0), mode.decay + mode.response * h * time * k / m, 1e-15);
  EXPECT_NEAR(stiff_block(MatX::Constant(1, 1, m), MatX::Constant(1, 1, k), 0, {}, h).kept(0, 0),
              exponential_mode(std::sqrt(k / m), 0, h).decay, 1e-15);
}

TEST(VesselStiffBlock, NoCoordinatesNoBlock) {
  EXPECT_EQ(stiff_block(MatX(0, 0), MatX(0, 0), 0, {}, 0.01).mass.size(), 0);
}

/// The mass of the block is the inverse of its response, symmetric and positive definite at any stiffness; the
/// coordinates without spring feel impulses as if the held ones were free to follow.
TEST(VesselStiffBlock, IsPositiveDefiniteAtAnyStiffness) {
  RandomStream random(2, "block");
  const std::vector<int> free{1, 4}, held{0, 2, 3, 5};
  for (double k = 1; k <= 1e13; k *= 100) {
    const MatX M = random_spd(random, 6);
    MatX K = MatX::Zero(6, 6);
    K(held, held) = k * random_spd(random, 4);
    const StiffBlock block = stiff_block(M, K, 1e-3, free, 0.01);
    EXPECT_EQ(block.mass, block.mass.transpose());
    EXPECT_EQ(block.response, block.response.transpose());
    const VecX values = Eigen::SelfAdjointEigenSolver<MatX>(block.mass).eigenvalues();
    EXPECT_GT(values[0], 0) << k;
    EXPECT_LT((block.mass * block.response - MatX::Identity(6, 6)).norm(), 1e-15 * values[5] / values[0] * 100) << k;
    // a deflection of the springs alone decays, free coordinates keep their momentum
    VecX u = VecX::Zero(6);
    for (int i = 0; i < 6; ++i) u[i] = random.normal();
    const VecX lost = M * (u - block.kept * u);
    EXPECT_LT(VecX(lost(free)).norm(), 1e-12 * (M * u).norm()) << k;
  }
}

TEST(VesselStiffBlock, RefusesIndefiniteInput) {
  EXPECT_THROW(stiff_block(MatX::Constant(1, 1, -1), MatX::Zero(1, 1), 0, {0}, 0.01), SimulationError);
  EXPECT_THROW(stiff_block(MatX::Identity(2, 2), MatX::Zero(2, 2), 0, {0}, 0.01), SimulationError);
}

}  // namespace
}  // namespace nilas
