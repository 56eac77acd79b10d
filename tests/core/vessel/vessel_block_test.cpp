/// The vessel's block of the contact problem.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/core/vessel/example_vessel.h"

namespace nilas::vessel {
namespace vessel_block_test {

constexpr double k_h = 0.01;
const std::array<bool, 6> k_heave_pitch{false, false, true, false, true, false};

TEST(VesselBlock, IsSymmetricPositiveDefiniteAtAnyStiffness) {
  for (double k = 1e3; k <= 1e10; k *= 10) {
    VesselModel model = example::carried(BalanceKind::six_cells, k_heave_pitch);
    model.carriage->stiffness = k;
    model.carriage->damping = 0;
    VesselSystem system(model, 0);
    const VesselBlock block = system.begin({}, k_h);
    ASSERT_EQ(block.mass.rows(), 6);
    EXPECT_EQ(block.mass, block.mass.transpose());
    EXPECT_EQ(block.mass.llt().info(), Eigen::Success);
    const VecX values = Eigen::SelfAdjointEigenSolver<MatX>(block.mass).eigenvalues();
    EXPECT_GT(values[0], 1) << k;
    EXPECT_LT(values[5] / values[0], 1e9) << k;
    // harder cells yield less to a contact
    EXPECT_GE(Vec6(block.hull.jacobian * block.mass.llt().solve(block.hull.jacobian.transpose() * Vec6::UnitZ()))[2],
              0);
  }
}

/// The solver's velocities from the block are the displacement of finish(): displacement / h = mass^-1 (f + J^T r).
TEST(VesselBlock, MeanSpeedsAreTheDisplacement) {
  for (const BalanceKind balance : {BalanceKind::rigid, BalanceKind::six_cells, BalanceKind::prismatic})
    for (const double k : {1e5, 1e7, 1e10}) {
      VesselModel model = example::vessel();
      model.carriage = example::carriage(model, {1.5, 0.1, 0.5});
      model.carriage->balance = balance;
      model.carriage->free = k_heave_pitch;
      model.carriage->stiffness = k;
      model.carriage->damping = 1e-3 * k;
      const Vec3 start = model.pose_V.p + model.pose_V.q * model.carriage->joint_V;
      model.carriage->motion = CarriageMotion::straight(start, 0.3, 0.7, 0.8, 1, 0);
      VesselSystem system(model, 0);
      RandomStream random(7, "block");
      for (int i = 0; i < 100; ++i) {
        const Wrench impulse = example::random_wrench(random, 0.5);
        Vec6 r;
        r << impulse.force, impulse.torque;
        const VecX before = system.coordinates();
        const Pose pose = system.state().pose;
        const VesselBlock block = system.begin(example::random_wrench(random, 30), k_h);
        const VecX speeds = block.mass.llt().solve(block.f + block.hull.jacobian.transpose() * r);
        system.finish(impulse);
        const auto n = speeds.size();
        const VecX moved = (system.coordinates() - before).head(n) / k_h;
        ASSERT_LT((moved - speeds).norm(), 1e-9 * (1 + speeds.norm())) << k << " " << i;
        const Vec6 twist = block.hull.jacobian * speeds + block.hull.prescribed;
        const Vec3 way = (system.state().pose.p - pose.p) / k_h;
        ASSERT_LT((way - twist.head<3>()).norm(), k_h * (twist.norm() * twist.tail<3>().norm() + 1e-7)) << k;
        const Eigen::AngleAxisd turn(system.state().pose.q * pose.q.conjugate());
        ASSERT_LT((turn.angle() / k_h * turn.axis() - twist.tail<3>()).norm(),
                  2 * k_h * twist.tail<3>().squaredNorm() + 1e-9);
      }
    }
}

/// A vessel that the carriage holds altogether has no coordinate, only the mean twist over the step.
TEST(VesselBlock, RigidVesselIsPrescribed) {
  const example::TemporaryFile track("t_s,x_m,y_m,yaw_deg\n0,0,0,0\n1,0.5,0.1,30\n2,1.5,1.2,-20\n");
  VesselModel model = example::vessel();
  model.carriage = example::carriage(model, {1.5, 0.1, 0.5});
  const Vec3 start = model.pose_V.p + model.pose_V.q * model.carriage->joint_V;
  model.carriage->motion = CarriageMotion::path(start, 0.3, track.path());
  VesselSystem system(model, 0);
  for (int i = 0; i < 150; ++i) {
    const Pose before = system.state().pose;
    const VesselBlock block = example::step(system, Wrench{}, k_h, {{1, 2, 3}, {4, 5, 6}});
    EXPECT_EQ(block.mass.size() + block.f.size() + block.hull.jacobian.size(), 0);
    ASSERT_LT(((system.state().pose.p - before.p) / k_h - block.hull.prescribed.head<3>()).norm(), 1e-12);
    const Eigen::AngleAxisd turn(system.state().pose.q * before.q.conjugate());
    ASSERT_LT((turn.angle() / k_h * turn.axis() - block.hull.prescribed.tail<3>()).norm(), 1e-10);
  }
}

/// The block for soft cells is the vessel's own mass: a contact sees a free body.
TEST(VesselBlock, SoftCellsAreNone) {
  VesselModel model = example::carried(BalanceKind::six_cells);
  model.carriage->stiffness = 1e-6;
  model.carriage->damping = 0;
  VesselSystem soft(model, 0), free(example::vessel(), 0);
  const VesselBlock a = soft.begin({}, k_h), b = free.begin({}, k_h);
  const Mat6 W_soft = a.hull.jacobian * a.mass.llt().solve(a.hull.jacobian.transpose());
  const Mat6 W_free = b.hull.jacobian * b.mass.llt().solve(b.hull.jacobian.transpose());
  EXPECT_LT((W_soft - W_free).norm(), 1e-12 * W_free.norm());
}

TEST(VesselBlock, ImpossibleBodiesAreInputErrors) {
  VesselModel model = example::vessel();
  model.mass.mass = 0;
  EXPECT_THROW(VesselSystem(model, 0), InputError);
  model = example::vessel();
  model.mass.inertia = Vec3(1, 1, 3).asDiagonal();
  EXPECT_THROW(VesselSystem(model, 0), InputError);
}

}  // namespace vessel_block_test
}  // namespace nilas::vessel
