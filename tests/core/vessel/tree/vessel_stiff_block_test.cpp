#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/vessel/tree/exponential_mode.h"
#include "core/vessel/tree/stiff_block.h"

namespace nilas::vessel {
namespace vessel_stiff_block_test {

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

/// Surge, heave and pitch of a vessel that is its own mirror image, and sway, roll and yaw: coupled among themselves
/// only.
struct MirroredVessel {
  std::vector<int> along{0, 2, 4}, across{1, 3, 5};
  MatX mass = MatX::Zero(6, 6), stiffness = MatX::Zero(6, 6);

  explicit MirroredVessel(RandomStream& random, double k) {
    for (const auto& set : {along, across}) {
      mass(set, set) = random_spd(random, 3);
      stiffness(set, set) = k * random_spd(random, 3);
    }
  }
  /// Entries between the two sets, each of them the given share of the root of its diagonal ones.
  MatX coupled(const MatX& a, double share) const {
    MatX b = a;
    for (const int i : along)
      for (const int j : across) b(i, j) = b(j, i) = share * std::sqrt(a(i, i) * a(j, j));
    return b;
  }
};

TEST(VesselStiffBlock, FindsWhatIsCoupled) {
  RandomStream random(3, "block");
  const MirroredVessel vessel(random, 1e6);
  const std::vector<std::vector<int>> apart{vessel.along, vessel.across}, one{{0, 1, 2, 3, 4, 5}};
  EXPECT_EQ(coupled_sets(vessel.mass, vessel.stiffness), apart);
  EXPECT_EQ(coupled_sets(vessel.coupled(vessel.mass, 1e-15), vessel.coupled(vessel.stiffness, -1e-15)), apart);
  EXPECT_EQ(coupled_sets(vessel.coupled(vessel.mass, 1e-13), vessel.stiffness), one);
  EXPECT_EQ(coupled_sets(vessel.mass, vessel.coupled(vessel.stiffness, -1e-13)), one);
  // 0 and 2 through 1 alone
  MatX chain = MatX::Identity(4, 4);
  chain(0, 1) = chain(1, 0) = chain(1, 2) = chain(2, 1) = 0.5;
  EXPECT_EQ(coupled_sets(chain, MatX::Zero(4, 4)), (std::vector<std::vector<int>>{{0, 1, 2}, {3}}));
}

TEST(VesselStiffBlock, KeepsUncoupledCoordinatesExactlyUncoupled) {
  RandomStream random(4, "block");
  for (const std::vector<int>& free : {std::vector<int>{}, std::vector<int>{2, 5}}) {
    MirroredVessel vessel(random, 5e6);
    for (const int i : free) {
      vessel.stiffness.row(i).setZero();
      vessel.stiffness.col(i).setZero();
    }
    const MatX rounded = vessel.coupled(vessel.mass, 1e-15);
    const StiffBlock block = stiff_block(rounded, vessel.stiffness, 1e-3, free, 0.01);
    for (const MatX& a : {block.mass, block.response, block.kept}) {
      EXPECT_EQ(MatX(a(vessel.along, vessel.across)), MatX::Zero(3, 3));
      EXPECT_EQ(MatX(a(vessel.across, vessel.along)), MatX::Zero(3, 3));
    }
    // the same as in one piece, which a coupling just above rounding asks for
    const StiffBlock whole = stiff_block(vessel.coupled(vessel.mass, 1e-13), vessel.stiffness, 1e-3, free, 0.01);
    EXPECT_NE(whole.mass(0, 1), 0);
    EXPECT_LT((block.mass - whole.mass).norm(), 1e-9 * whole.mass.norm());
    EXPECT_LT((block.response - whole.response).norm(), 1e-9 * whole.response.norm());
    EXPECT_LT((block.kept - whole.kept).norm(), 1e-9);
  }
}

TEST(VesselStiffBlock, RefusesIndefiniteInput) {
  EXPECT_THROW(stiff_block(MatX::Constant(1, 1, -1), MatX::Zero(1, 1), 0, {0}, 0.01), SimulationError);
  EXPECT_THROW(stiff_block(MatX::Identity(2, 2), MatX::Zero(2, 2), 0, {0}, 0.01), SimulationError);
}

}  // namespace vessel_stiff_block_test
}  // namespace nilas::vessel
