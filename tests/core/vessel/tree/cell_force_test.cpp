/// Compares the load cells as force elements of Simbody with the matrices of the step.
#include <gtest/gtest.h>

#include "core/vessel/model/cells.h"
#include "core/vessel/tree/carried_vessel.h"
#include "tests/core/vessel/example_vessel.h"

namespace nilas::vessel {
namespace cell_force_test {

/// Cells anywhere, with axes of any direction, that tell the loads apart well.
std::array<LoadCell, 6> random_cells(RandomStream& random) {
  std::array<LoadCell, 6> cells;
  do {
    for (LoadCell& cell : cells) {
      for (int i = 0; i < 3; ++i) {
        cell.point[i] = random.normal();
        cell.axis[i] = random.normal();
      }
      cell.axis.normalize();
    }
  } while (layout_condition(cells) > 100);
  return cells;
}

VecX random_vector(RandomStream& random, int n, double scale) {
  VecX x(n);
  for (int i = 0; i < n; ++i) x[i] = scale * random.normal();
  return x;
}

/// K6 - K6 S (S^T K6 S)^-1 S^T K6, as docs/theory/vessel.md has it.
MatX condensed(const MatX& K6, const std::vector<int>& free) {
  if (free.empty()) return K6;
  const MatX unit = MatX::Identity(6, 6);
  const MatX S = unit(Eigen::all, free);
  return K6 - K6 * S * (S.transpose() * K6 * S).inverse() * S.transpose() * K6;
}

TEST(CellForce, IsTheMatrixAtAnyState) {
  RandomStream random(11, "cells");
  for (int trial = 0; trial < 64; ++trial) {
    VesselModel model = example::carried(BalanceKind::six_cells);
    CarriageModel& carriage = *model.carriage;
    carriage.cells = random_cells(random);
    for (std::size_t k = 0; k < 6; ++k) carriage.free[k] = (trial >> k) % 2 == 1;
    VesselTree tree(model.mass, carriage_joint(model), carriage_cells(carriage));
    const VecX q = random_vector(random, 6, 0.2), u = random_vector(random, 6, 0.5);
    CarriageMotion::State moving;
    moving.p = {1, 2, 3};
    moving.yaw = 0.7;
    moving.v = {0.3, -0.2, 0};
    moving.yaw_rate = 0.4;
    tree.set_carriage(moving);
    tree.set_coordinates(q);
    tree.set_speeds(u);
    const Mat6 A = cell_wrenches(carriage.cells);
    const std::vector<int> free = free_coordinates(carriage);
    const MatX K = condensed_stiffness(A, carriage.stiffness, free);
    const double time = carriage.damping / carriage.stiffness;
    const double scale = carriage.stiffness * A.squaredNorm() * (q + time * u).norm();
    EXPECT_LT((tree.cell_force() + K * (q + time * u)).norm(), 1e-12 * scale) << trial;
    EXPECT_NEAR(tree.cell_energy(), 0.5 * q.dot(K * q), 1e-12 * scale * q.norm()) << trial;
    EXPECT_LT((K - condensed(carriage.stiffness * A * A.transpose(), free)).norm(), 1e-11 * K.norm() + 1e-4) << trial;
    EXPECT_EQ(K, K.transpose());
    for (const int i : free) EXPECT_TRUE(K.col(i).isZero(0)) << "a free axis transmits nothing: " << trial;
  }
}

/// One cell alone: a move of its point along its axis shortens it, and it presses the vessel back.
TEST(CellForce, PressesBackWhereTheVesselMovesAlongTheAxis) {
  VesselModel model = example::carried(BalanceKind::six_cells);
  VesselTree tree(model.mass, carriage_joint(model), carriage_cells(*model.carriage));
  VecX q = VecX::Zero(6);
  constexpr int k_surge = 3;
  q[k_surge] = 1e-3;
  tree.set_coordinates(q);
  const VecX force = tree.cell_force();
  EXPECT_DOUBLE_EQ(force[k_surge], -1e-3 * model.carriage->stiffness);
  EXPECT_NEAR(tree.cell_energy(), 0.5e-6 * model.carriage->stiffness, 1e-12);
  EXPECT_EQ(VesselTree(model.mass, carriage_joint(model), {}).cell_force(), VecX::Zero(6));
}

}  // namespace cell_force_test
}  // namespace nilas::vessel
