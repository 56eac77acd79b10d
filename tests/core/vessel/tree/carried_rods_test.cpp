/// Rods on vessels that a carriage or fixed hull holds, and rods that cannot be.
#include <cmath>

#include "core/base/error.h"
#include "tests/core/vessel/tree/rod_example.h"
#include "tests/support/mentions.h"
#include "tests/support/refusal.h"

namespace nilas::vessel {
namespace carried_rods_test {

const std::vector<std::optional<double>> k_schemes{std::nullopt, 0.5};

/// Towed along X at constant speed and free in sway, on a rod at its centre of mass that stands across at the start.
VesselModel swaying(std::optional<double> theta, double length, double speed) {
  VesselModel model = example::vessel();
  model.theta = theta;
  model.pose_V.q.setIdentity();
  model.carriage = example::carriage(model, model.mass.com);
  model.carriage->balance = BalanceKind::rigid;
  model.carriage->free = {false, true, false, false, false, false};
  const Vec3 start = model.pose_V.p + model.pose_V.q * model.mass.com;
  model.carriage->motion = CarriageMotion::straight(start, 0, speed, 0, 0, 0);
  model.rods.push_back({"tie", -1, model.mass.com, start + Vec3(0, length, 0), std::nullopt});
  return model;
}

TEST(CarriedRods, MakeATowedVesselSwayOnTheirCircle) {
  for (const auto theta : k_schemes) {
    const double length = 4, speed = 0.5, h = 0.01;
    const VesselModel model = swaying(theta, length, speed);
    VesselSystem system(model, 0);
    for (int k = 0; k < 400; ++k) {
      example::step(system, std::vector<Wrench>(1), h);
      ASSERT_NEAR(example::rod_length(model, system), length, 1e-14 * length) << k;
    }
    // sway y below the top of the circle: y = L - sqrt(L^2 - x^2), x = V t
    const double x = speed * 4, root = std::sqrt(length * length - x * x);
    EXPECT_NEAR(system.state().v.y(), speed * x / root, 1e-8);
    const double middle = speed * (4 - h / 2), across = std::sqrt(length * length - middle * middle);
    const double acceleration = speed * speed * length * length / std::pow(across, 3);
    const double tension = model.mass.mass * acceleration * length / across;
    EXPECT_NEAR(system.joint_account().rods[0], tension, 1e-4 * tension);
    // The carriage balances the rod's pull astern.
    EXPECT_NEAR(system.carriage_loads().about_com.force.x(), tension * middle / length, 1e-4 * tension);
    EXPECT_NEAR(system.carriage_loads().about_com.force.y(), 0, 1e-9 * tension);
    const Wrench& apart = system.carriage_loads().disagreement.value();
    EXPECT_LT(apart.force.norm() + apart.torque.norm(), 1e-6 * tension);
  }
}

TEST(CarriedRods, TakeUpTheSpeedOfTheCarriageAtOnceAndOverARamp) {
  for (const auto theta : k_schemes)
    for (const double ramp : {0.0, 0.5}) {
      VesselModel model = swaying(theta, 4, 0.5);
      const Vec3 start = model.pose_V.p + model.pose_V.q * model.mass.com;
      model.rods[0].to_G = start + Vec3(2, 3, 0);
      model.carriage->motion = CarriageMotion::straight(start, 0, 0.5, 0, ramp, 0);
      VesselSystem system(model, 0);
      const double length = example::rod_length(model, system);
      EXPECT_NEAR(system.state().v.y(), ramp > 0 ? 0 : -0.5 * 2 / 3, 1e-14);
      double worst = 0;
      for (int k = 0; k < 100; ++k) {
        const Vec6 before = example::totals(model, system).momentum;
        example::step(system, std::vector<Wrench>(1), 0.01);
        ASSERT_NEAR(example::rod_length(model, system), length, 1e-14 * length) << k;
        const Vec3 from = model.rods[0].to_G - system.state().pose.p, v = system.state().v;
        ASSERT_NEAR(from.dot(v), 0, 1e-13);
        // Carriage and rod together are the rate of change of momentum, here along and across the course.
        const Vec3 force = (example::totals(model, system).momentum - before).head<3>() / 0.01;
        const double tension = system.joint_account().rods[0];
        const Vec3 lack = force - system.carriage_loads().about_com.force - tension * from.normalized();
        worst = std::max(worst, lack.norm() / (1 + std::abs(tension)));
        const Wrench& apart = system.carriage_loads().disagreement.value();
        ASSERT_LT(apart.force.norm() + apart.torque.norm(), 1e-6 * (1 + std::abs(tension)));
      }
      EXPECT_NEAR(system.state().v.x(), 0.5, 1e-13);
      EXPECT_LT(worst, 0.01);  // the rod turns within a step
    }
}

TEST(CarriedRods, StopTheRunAtADeadPointAndSayWhichRod) {
  // The carriage moves on where the rod lies along its course.
  const VesselModel model = swaying(0.5, 1, 1);
  VesselSystem system(model, 0);
  const auto pass = [&] {
    for (int k = 0; k < 200; ++k) example::step(system, std::vector<Wrench>(1), 0.01);
  };
  test::expect_refusal<SimulationError>(pass, {"rod 'tie'"});
}

TEST(CarriedRods, RelieveTheCellsOfWhatTheyBear) {
  // as stiff as rigid, along the longitudinal cell: of a force on it the cells see nothing
  for (const auto theta : k_schemes) {
    VesselModel model = example::carried(BalanceKind::six_cells);
    model.theta = theta;
    const Vec3 joint = model.pose_V.p + model.pose_V.q * model.mass.com, ahead = model.pose_V.q * Vec3::UnitX();
    model.rods.push_back({"tie", -1, model.mass.com, joint - 3 * ahead, std::nullopt});
    VesselSystem system(model, 0);
    const Vec3 across = model.pose_V.q * Vec3::UnitY();
    for (int k = 0; k < 400; ++k)
      example::step(system, std::vector<Wrench>{{500 * ahead + 70 * across, Vec3::Zero()}}, 0.01);
    EXPECT_NEAR(system.joint_account().rods[0], 500, 0.01);
    const auto& cells = system.carriage_loads().cells;
    EXPECT_NEAR(cells[0], 0, 0.01);
    EXPECT_NEAR(cells[1] + cells[2], -70, 0.01);
    EXPECT_NEAR(example::rod_length(model, system), 3, 1e-13);
    const Wrench& apart = system.carriage_loads().disagreement.value();
    EXPECT_LT(apart.force.norm() + apart.torque.norm(), 1e-6 * 500);
  }
}

TEST(CarriedRods, HoldAPartOfAFixedHull) {
  // a hinged arm that a rod holds level bears half its weight at its middle
  VesselModel model;
  model.fixed = true;
  PartModel arm;
  arm.mass = 12;
  arm.inertia_B = Vec3(0.1, 4, 4).asDiagonal();
  arm.in_V.p = {1, 0, 0};
  arm.axis_V = Vec3::UnitY();
  model.parts.push_back(arm);
  model.rods.push_back({"stay", 0, Vec3(2, 0, 0), Vec3(2, 0, 3), 3});
  for (const auto theta : k_schemes) {
    model.theta = theta;
    VesselSystem system(model, 0);
    VesselBlock block;
    for (int k = 0; k < 20; ++k) block = example::step(system, example::weights(model), 0.01);
    EXPECT_EQ(block.mass.rows(), 0);
    EXPECT_NEAR(system.joint_account().rods[0], 0.5 * 12 * example::k_gravity, 1e-9);
    EXPECT_NEAR(system.parts()[0].joint.force.z(), 0.5 * 12 * example::k_gravity, 1e-9);
    EXPECT_EQ(system.parts()[0].coordinates[0], 0);
  }
}

/// The message of the rods' fault, or an empty text.
std::string said(const VesselModel& model) {
  const auto fault = rod_fault(model, 0);
  if (!fault) return {};
  EXPECT_THROW(VesselSystem(model, 0), InputError);
  return model.rods[fault->rod].name + ": " + fault->message;
}

TEST(CarriedRods, ThatCannotBeAreRefusedByName) {
  const VesselModel good = example::on_a_rod(0.5);
  EXPECT_EQ(said(good), "");
  VesselModel model = good;
  model.rods[0].to_G = model.pose_V.p + model.pose_V.q * model.rods[0].at_V;
  EXPECT_TRUE(test::mentions(said(model), "tie: both its ends are at one point")) << said(model);

  model = good;
  VesselSystem placed(model, 0);
  const double length = example::rod_length(model, placed);
  model.rods[0].length = length + 0.006;
  EXPECT_TRUE(test::mentions(said(model), "tie: its length is")) << said(model);
  model.rods[0].length = length + 0.004;
  EXPECT_EQ(said(model), "");
  EXPECT_NEAR(example::rod_length(model, VesselSystem(model, 0)), length + 0.004, 1e-14);

  model = good;
  model.rods.push_back({"twin", -1, good.rods[0].at_V, good.rods[0].to_G, std::nullopt});
  EXPECT_TRUE(test::mentions(said(model), "twin: it holds nothing")) << said(model);

  model = good;
  model.fixed = true;
  EXPECT_TRUE(test::mentions(said(model), "tie: it holds nothing")) << said(model);
  model = example::carried(BalanceKind::rigid);
  model.rods = good.rods;
  EXPECT_TRUE(test::mentions(said(model), "tie: it holds nothing")) << said(model);

  // four upright rods: one more than heave, roll and pitch
  model = good;
  model.rods.clear();
  for (const auto& [name, x, y] : {std::tuple("a", 0.0, 0.0), {"b", 1.0, 0.0}, {"c", 0.0, 1.0}, {"d", 1.0, 1.0}}) {
    const Vec3 at(x, y, 1);
    const Vec3 foot = model.pose_V.p + model.pose_V.q * at - Vec3(0, 0, 4);
    model.rods.push_back({name, -1, at, foot, std::nullopt});
  }
  EXPECT_TRUE(test::mentions(said(model), "d: it holds nothing")) << said(model);
  model.rods.pop_back();
  EXPECT_EQ(said(model), "");

  model = good;
  model.v = {1, 0, 0};
  EXPECT_TRUE(test::mentions(said(model), "tie: at the start the vessel would")) << said(model);
}

TEST(CarriedRods, SixHoldAVesselFast) {
  VesselModel model = example::vessel();
  int k = 0;
  for (const Vec3& along : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
    for (const double side : {-1.0, 1.0}) {
      const Vec3 at = model.mass.com + side * Vec3(along.y(), along.z(), along.x());
      const Vec3 end = model.pose_V.p + model.pose_V.q * at;
      model.rods.push_back({std::to_string(++k), -1, at, end + model.pose_V.q * along, std::nullopt});
    }
  VesselSystem system(model, 0);
  const Vec3 force = model.pose_V.q * Vec3(120, -80, 60);
  VesselBlock block;
  for (int n = 0; n < 10; ++n) block = example::step(system, std::vector<Wrench>{{force, Vec3::Zero()}}, 0.01);
  EXPECT_EQ(block.mass.rows(), 0);
  const VecX& tensions = system.joint_account().rods;
  for (const auto& [rod, share] : {std::pair(0, -60.0), {1, -60.0}, {2, 40.0}, {3, 40.0}, {4, -30.0}, {5, -30.0}})
    EXPECT_NEAR(tensions[rod], share, 1e-9) << rod;
  EXPECT_LT(system.state().v.norm() + system.state().w.norm(), 1e-12);
}

}  // namespace carried_rods_test
}  // namespace nilas::vessel
