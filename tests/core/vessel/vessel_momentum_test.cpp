/// Newton and Euler hold from row to row in every mode, whatever the loads, impulses and motions are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/core/vessel/example_vessel.h"

namespace nilas::vessel {
namespace vessel_momentum_test {

constexpr double k_h = 0.01;

struct Mode {
  std::string name;
  BalanceKind balance;
  std::array<bool, 6> free;
  double stiffness;
};

const std::array<bool, 6> k_none{}, k_heave{false, false, true, false, false, false},
    k_heave_roll_pitch{false, false, true, true, true, false}, k_surge_yaw{true, false, false, false, false, true},
    k_all{true, true, true, true, true, true};

using Integrator = std::optional<double>;  ///< theta; none: semi-implicit Euler

class VesselMomentum : public testing::TestWithParam<std::tuple<Mode, Integrator>> {};

/// m (v+ - v-) = h (carriage + free) + contact and the same for L = R I R^T w, on a turning and accelerating carriage.
TEST_P(VesselMomentum, BalancesInEveryStep) {
  const example::TemporaryFile track(
      "t_s,x_m,y_m,yaw_deg\n0,0,0,0\n1,0.3,0.05,10\n2,1.1,0.5,40\n3.05,1.3,0.6,20\n4,1.3,0.7,0\n");
  const auto& [mode, theta] = GetParam();
  VesselModel model = example::vessel();
  model.theta = theta;
  const Vec3 joint_V(1.5, 0.1, 0.5);
  CarriageModel carriage = example::carriage(model, joint_V);
  carriage.motion = CarriageMotion::path(model.pose_V.p + model.pose_V.q * joint_V, 0.3, track.path());
  carriage.balance = mode.balance;
  carriage.free = mode.free;
  carriage.stiffness = mode.stiffness;
  carriage.damping = 1e-3 * mode.stiffness;
  model.carriage = carriage;
  VesselSystem system(model, 0);
  RandomStream random(3, "momentum");
  const double m = model.mass.mass;
  for (int i = 0; i < 500; ++i) {
    const Wrench load = example::random_wrench(random, 200), impulse = example::random_wrench(random, 3);
    const VesselState before = system.state();
    example::step(system, load, k_h, impulse);
    const VesselState& after = system.state();
    const CarriageLoads& read = system.carriage_loads();
    const Vec3 gained = m * (after.v - before.v);
    const Vec3 lacking = gained - k_h * (read.about_com.force + load.force) - impulse.force;
    ASSERT_LT(lacking.norm(), 1e-12 * m * std::max(after.v.norm(), 1.0)) << i;
    const Vec3 L_before = example::angular_momentum(model, before), L_after = example::angular_momentum(model, after);
    const Vec3 turning = L_after - L_before - k_h * (read.about_com.torque + load.torque) - impulse.torque;
    ASSERT_LT(turning.norm(), 1e-12 * std::max(L_after.norm(), 1.0)) << i;
    if (!theta) {
      const Vec3 arm = after.pose.p - carriage.motion.at(system.time()).p;
      ASSERT_LT((read.about_joint.torque - read.about_com.torque - arm.cross(read.about_com.force)).norm(), 1e-9);
    }
    ASSERT_EQ(read.about_joint.force, read.about_com.force);
    ASSERT_TRUE(after.pose.p.allFinite());
  }
}

std::string name_of(const testing::TestParamInfo<std::tuple<Mode, Integrator>>& info) {
  const auto& [mode, theta] = info.param;
  return mode.name + (theta ? "_theta_" + std::to_string(std::lround(100 * *theta)) : "");
}

INSTANTIATE_TEST_SUITE_P(
    Modes, VesselMomentum,
    testing::Combine(testing::Values(Mode{"rigid", BalanceKind::rigid, k_none, 1e7},
                                     Mode{"rigid_heave", BalanceKind::rigid, k_heave, 1e7},
                                     Mode{"rigid_heave_roll_pitch", BalanceKind::rigid, k_heave_roll_pitch, 1e7},
                                     Mode{"rigid_surge_yaw", BalanceKind::rigid, k_surge_yaw, 1e7},
                                     Mode{"rigid_all", BalanceKind::rigid, k_all, 1e7},
                                     Mode{"prismatic", BalanceKind::prismatic, k_none, 1e7},
                                     Mode{"cells", BalanceKind::six_cells, k_none, 1e7},
                                     Mode{"cells_soft", BalanceKind::six_cells, k_none, 1e4},
                                     Mode{"cells_hard", BalanceKind::six_cells, k_none, 1e10},
                                     Mode{"cells_heave_roll_pitch", BalanceKind::six_cells, k_heave_roll_pitch, 1e7},
                                     Mode{"cells_all_free", BalanceKind::six_cells, k_all, 1e7}),
                     testing::Values(Integrator(), Integrator(0.5), Integrator(1.0), Integrator(0.7), Integrator(0.0))),
    name_of);

/// A carriage that leaves everything free moves the vessel as if it were not there.
TEST(VesselMomentumFree, CarriageThatHoldsNothingIsNone) {
  VesselModel free = example::vessel();
  VesselModel carried = example::carried(BalanceKind::rigid, k_all);
  VesselSystem a(free, 0), b(carried, 0);
  const Wrench load{{30, -20, 10}, {5, 8, -6}};
  for (int i = 0; i < 100; ++i) {
    example::step(a, load, k_h, {{0.1, 0, 0}, {0, 0.2, 0.1}});
    example::step(b, load, k_h, {{0.1, 0, 0}, {0, 0.2, 0.1}});
    ASSERT_LT(b.carriage_loads().about_com.force.norm() + b.carriage_loads().about_com.torque.norm(), 1e-9);
  }
  EXPECT_LT((a.state().pose.p - b.state().pose.p).norm(), 1e-12);
  EXPECT_LT((a.state().v - b.state().v).norm(), 1e-12);
  EXPECT_LT((a.state().w - b.state().w).norm(), 1e-4);  // attitudes by different first-order rules
}

}  // namespace vessel_momentum_test
}  // namespace nilas::vessel
