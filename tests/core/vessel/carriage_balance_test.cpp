/// Tests of the readings of the force balance: pure loads, dynamic peaks, ramps, drag.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/vessel/model/cells.h"
#include "tests/core/vessel/example_vessel.h"

namespace nilas::vessel {
namespace carriage_balance_test {

constexpr double k_h = 0.01;
constexpr int k_settling_steps = 3000;

/// The six readings put together again, in G.
Wrench reassembled(const CarriageModel& carriage, const CarriageLoads& loads, double yaw) {
  const Vec6 wrench = cell_wrenches(carriage.cells) * Eigen::Map<const Vec6>(loads.cells.data());
  const Quat R(Eigen::AngleAxisd(yaw, Vec3::UnitZ()));
  return {R * wrench.tail<3>(), R * wrench.head<3>()};
}

class CarriagePureLoad : public testing::TestWithParam<std::tuple<BalanceKind, int>> {};

TEST_P(CarriagePureLoad, IsReadToRounding) {
  const auto [balance, axis] = GetParam();
  const VesselModel model = example::carried(balance);
  VesselSystem system(model, 0);
  Vec6 given = Vec6::Zero();
  given[axis] = axis < 3 ? 120 : 45;
  const Quat R(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));  // along the carriage's axes
  const Wrench load{R * given.head<3>(), R * given.tail<3>()};
  example::run(system, load, k_h, balance == BalanceKind::rigid ? 1 : k_settling_steps);
  const CarriageLoads& read = system.carriage_loads();
  const double tolerance = 1e-9 * given.norm();
  for (const Wrench& wrench : {read.about_com, read.about_joint}) {
    EXPECT_LT((wrench.force + load.force).norm(), tolerance);
    EXPECT_LT((wrench.torque + load.torque).norm(), tolerance);
  }
  if (balance != BalanceKind::six_cells) return;
  const Wrench sum = reassembled(*model.carriage, read, 0.3);
  EXPECT_LT((sum.force + load.force).norm(), tolerance);
  EXPECT_LT((sum.torque + load.torque).norm(), tolerance);
  // The cells' axes point from vessel to carriage: a load along +axis presses them.
  if (axis == 0) {
    EXPECT_NEAR(read.cells[0], -120, tolerance);
  }
  if (axis == 1) {
    EXPECT_NEAR(read.cells[1], -60, tolerance);
  }
  if (axis == 2) {
    EXPECT_NEAR(read.cells[3] + read.cells[4] + read.cells[5], -120, tolerance);
  }
  if (axis == 5) {
    EXPECT_NEAR(read.cells[1] - read.cells[2], -45 / example::k_arm, tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(AllAxes, CarriagePureLoad,
                         testing::Combine(testing::Values(BalanceKind::rigid, BalanceKind::six_cells),
                                          testing::Range(0, 6)));

struct StepLoadCase {
  double h_omega;
  int settling_steps;  ///< Steps until 1e-5 of the transient is left; one second is enough for stiff cells.
};

class CarriageStepLoad : public testing::TestWithParam<StepLoadCase> {
 protected:
  /// Surge alone is one cell: omega = sqrt(k / m).
  static VesselModel model(double h_omega, double zeta) {
    VesselModel model = example::carried(BalanceKind::six_cells);
    const double omega = h_omega / k_h;
    model.carriage->stiffness = example::k_mass * omega * omega;
    model.carriage->damping = 2 * zeta * omega * example::k_mass;
    return model;
  }
  static Wrench load() { return {Vec3(Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ())) * Vec3(120, 0, 0)), Vec3::Zero()}; }
};

/// m = 500 kg, zeta = 0.05, 120 N from t = 0: the mean is 120 N, the true peak of the cell 223 N.
TEST_P(CarriageStepLoad, PeakMeanAndRinging) {
  const StepLoadCase& wanted = GetParam();
  VesselSystem system(model(wanted.h_omega, 0.05), 0);
  double peak = 0, mean = 0, ringing = 0;
  for (int i = 0; i < wanted.settling_steps; ++i) {
    example::step(system, load(), k_h);
    peak = std::max(peak, -system.carriage_loads().cells[0]);
  }
  constexpr int k_steps = 1000;
  for (int i = 0; i < k_steps; ++i) {
    example::step(system, load(), k_h);
    const double reading = -system.carriage_loads().cells[0];
    ringing = std::max(ringing, std::abs(reading - 120));
    mean += reading / k_steps;
  }
  EXPECT_NEAR(mean, 120, 1e-3 * 120);
  EXPECT_LT(ringing, 1e-4 * 120);
  EXPECT_LT(peak, 1.05 * 222.3);
  if (wanted.h_omega < 1) {
    EXPECT_GT(peak, 0.95 * 222.3);
  } else {
    EXPECT_LT(ringing, 1e-11 * 120);
    EXPECT_LT(system.state().v.norm(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(HOmega, CarriageStepLoad,
                         testing::Values(StepLoadCase{0.045, 5200}, StepLoadCase{0.45, 520}, StepLoadCase{4.5, 100},
                                         StepLoadCase{45, 100}, StepLoadCase{450, 100}));

TEST_P(CarriageStepLoad, WithoutDampingNothingBlowsUp) {
  VesselSystem system(model(GetParam().h_omega, 0), 0);
  for (int i = 0; i < 5000; ++i) {
    example::step(system, load(), k_h);
    ASSERT_LT(std::abs(system.carriage_loads().cells[0]), 2.15 * 120);
  }
}

/// Any stiffness up to 1e10 N/m, with and without damping and free axes, under random loads and blows.
TEST(CarriageBalance, IsStableAtAnyStiffness) {
  for (const bool heave_free : {false, true})
    for (double k = 1e3; k <= 1e10; k *= 10)
      for (const double damping_time : {0.0, 1e-5, 1e-3, 1e-1}) {
        VesselModel model = example::carried(BalanceKind::six_cells, {false, false, heave_free, false, false, false});
        model.carriage->stiffness = k;
        model.carriage->damping = damping_time * k;
        VesselSystem system(model, 0);
        RandomStream random(5, "stability");
        for (int i = 0; i < 1000; ++i) {
          example::step(system, example::random_wrench(random, 100), k_h, example::random_wrench(random, 1));
          ASSERT_LT(system.state().v.norm() + system.state().w.norm(), 5) << k << " " << damping_time;
        }
      }
}

/// Cells, reaction and m a agree: in every step with the vessel's own acceleration, after settling with the ramp's.
TEST(CarriageBalance, RampLoadIsMassTimesAcceleration) {
  for (const BalanceKind balance : {BalanceKind::rigid, BalanceKind::six_cells}) {
    VesselModel model = example::carried(balance);
    const double heading = 0.3, speed = 0.6, ramp = 6;
    const Vec3 start = model.pose_V.p + model.pose_V.q * model.carriage->joint_V;
    model.carriage->motion = CarriageMotion::straight(start, 0.3, speed, heading, ramp, 0);
    VesselSystem system(model, 0);
    const Vec3 along(std::cos(heading), std::sin(heading), 0);
    const double wanted = example::k_mass * speed / ramp;
    for (int i = 0; i < 550; ++i) {
      const Vec3 before = system.state().v;
      example::step(system, Wrench{}, k_h);
      const CarriageLoads& read = system.carriage_loads();
      const Vec3 own = example::k_mass * (system.state().v - before) / k_h;
      ASSERT_LT((read.about_com.force - own).norm(), 1e-9 * wanted);
      if (balance == BalanceKind::six_cells) {
        ASSERT_NEAR(read.cells[0], read.about_joint.force.dot(along), 1e-9 * wanted);
        if (i < 400) continue;
        ASSERT_NEAR(read.cells[0], wanted, 1e-6 * wanted);
      }
      ASSERT_LT((read.about_com.force - wanted * along).norm(), 1e-6 * wanted) << i;
    }
    // through the kink into constant speed
    example::run(system, {}, k_h, 1500);
    EXPECT_LT(system.carriage_loads().about_com.force.norm(), 1e-6 * wanted);
    EXPECT_LT((system.state().v - speed * along).norm(), 1e-9);
  }
}

/// The mean tow force at constant speed is that of the drag law.
TEST(CarriageBalance, TowForceIsTheDrag) {
  for (const BalanceKind balance : {BalanceKind::rigid, BalanceKind::six_cells, BalanceKind::prismatic}) {
    VesselModel model = example::carried(balance);
    const Vec3 start = model.pose_V.p + model.pose_V.q * model.carriage->joint_V;
    model.carriage->motion = CarriageMotion::straight(start, 0.3, 0.7, 0.3, 2, 0);
    VesselSystem system(model, 0);
    const double drag = 37;  // [N s^2/m^2]
    for (int i = 0; i < 2000; ++i) {
      const Vec3 v = system.state().v;
      example::step(system, {-drag * v.norm() * v, Vec3::Zero()}, k_h);
    }
    EXPECT_NEAR(system.carriage_loads().about_com.force.norm(), drag * 0.49, 1e-9 * drag);
    if (balance == BalanceKind::six_cells) {
      EXPECT_NEAR(system.carriage_loads().cells[0], drag * 0.49, 1e-9 * drag);
    }
  }
}

/// The reaction in the linear regime is the cells' own law: -K q at rest, for any direction of load and layout.
TEST(CarriageBalance, ReactionIsTheCellsLaw) {
  VesselModel model = example::carried(BalanceKind::six_cells);
  CarriageModel& carriage = *model.carriage;
  carriage = example::carriage(model, {1.5, 0.1, 0.5});
  carriage.balance = BalanceKind::six_cells;
  carriage.cells[0].point = {0.1, 0.2, 0.3};
  carriage.cells[4].axis = Vec3(0.1, 0.2, 1).normalized();
  VesselSystem system(model, 0);
  const Wrench load{{2e-4, -1e-4, 3e-4}, {1e-4, 2e-4, -2e-4}};
  example::run(system, load, k_h, k_settling_steps);
  const Mat6 A = cell_wrenches(carriage.cells);
  const Vec6 tensions = -carriage.stiffness * A.transpose() * system.coordinates().head<6>();
  const Vec6 read = Eigen::Map<const Vec6>(system.carriage_loads().cells.data());
  EXPECT_LT((tensions - read).norm(), 1e-8 * read.norm());
  EXPECT_NEAR(system.spring_energy(), tensions.squaredNorm() / (2 * carriage.stiffness), 1e-8 * system.spring_energy());
}

/// While it swings, the reading is the cells' law averaged over two steps with the weights of a triangle: for free
/// motion x = X cos(omega t) that is -k x sin^2(a/2) / (a/2)^2, a = omega h.
TEST(CarriageBalance, SwingingReactionIsTheAveragedLaw) {
  VesselModel model = example::carried(BalanceKind::six_cells);
  model.carriage->stiffness = example::k_mass * 45 * 45;
  model.carriage->damping = 0;
  VesselSystem system(model, 0);
  const double a = 45 * k_h, average = std::pow(std::sin(0.5 * a) / (0.5 * a), 2);
  example::step(system, Wrench{}, k_h, {Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ())) * Vec3(2, 0, 0), Vec3::Zero()});
  constexpr int k_surge = 3;
  for (int i = 0; i < 300; ++i) {
    const double x = system.coordinates()[k_surge];
    example::step(system, Wrench{}, k_h);
    ASSERT_NEAR(system.carriage_loads().cells[0], -model.carriage->stiffness * average * x, 1e-7);
  }
}

TEST(CarriageBalance, RefusesWhatCannotHold) {
  VesselModel model = example::carried(BalanceKind::six_cells);
  model.carriage->stiffness = 0;
  EXPECT_THROW(VesselSystem(model, 0), InputError);
  model = example::carried(BalanceKind::six_cells);
  model.carriage->cells[2] = model.carriage->cells[1];
  EXPECT_THROW(VesselSystem(model, 0), InputError);
  model = example::carried(BalanceKind::six_cells);
  model.carriage->damping = -1;
  EXPECT_THROW(VesselSystem(model, 0), InputError);
}

}  // namespace carriage_balance_test
}  // namespace nilas::vessel
