/// A towed vessel with parts at rest: its joints and cells deflect as in statics, and nothing moves from then on.
#include <cmath>

#include "tests/core/vessel/tree/jointed_example.h"

namespace nilas::vessel {
namespace jointed_rest_test {

constexpr double k_h = 0.01;
const std::vector<std::optional<double>> k_schemes{std::nullopt, 0.5};

VesselModel towed(BalanceKind balance, std::optional<double> theta) {
  VesselModel model = example::carried(balance);
  model.theta = theta;
  return model;
}

RestModel under_weight(const VesselModel& model) {
  RestModel rest;
  rest.loads = [model](const std::vector<Pose>&) { return example::weights(model); };
  rest.weight = example::k_gravity * model.mass.mass;
  rest.length = 3;
  return rest;
}

/// Hinged across the hull, its centre of mass ahead of the hinge at its height.
PartModel arm(double stiffness) {
  PartModel part;
  part.mass = 40;
  part.inertia_B = Vec3(2, 3, 1).asDiagonal();
  part.point_V = {5, 0.1, 0.4};
  part.axis_V = Vec3::UnitY();
  part.in_V.p = {5.8, 0.1, 0.4};
  part.stiffness = stiffness;
  part.damping = 0.05 * stiffness;
  return part;
}

/// Steps of the vessel under its weight: the largest speed of any body and the largest change of what the carriage has.
void expect_rest(const VesselModel& model, VesselSystem& system, const CarriageLoads& tare) {
  const double weight = example::k_gravity * model.mass.mass;
  for (int k = 0; k < 50; ++k) {
    example::step(system, example::weights(model), k_h);
    double speed = std::sqrt(example::totals(model, system).kinetic / model.mass.mass);
    ASSERT_LT(speed, 1e-11) << k;
    const CarriageLoads& read = system.carriage_loads();
    ASSERT_LT((read.about_joint.force - tare.about_joint.force).norm(), 1e-10 * weight) << k;
    ASSERT_LT((read.about_joint.torque - tare.about_joint.torque).norm(), 1e-9 * weight) << k;
    for (std::size_t c = 0; c < 6; ++c) ASSERT_NEAR(read.cells[c], tare.cells[c], 1e-9 * weight) << k << " " << c;
  }
}

TEST(JointedRest, ASprungArmSagsAsStaticsSay) {
  for (const auto theta : k_schemes)
    for (const BalanceKind balance : {BalanceKind::rigid, BalanceKind::six_cells}) {
      VesselModel model = towed(balance, theta);
      model.parts = {arm(400)};
      if (balance == BalanceKind::six_cells) model.carriage->stiffness = 1e9;
      VesselSystem system(model, 0);
      const VesselRest rest = system.settle(under_weight(model), true);
      ASSERT_TRUE(rest.carried.has_value());
      // A turn about +y lowers the bodies ahead: k a = m g l cos(a).
      const double moment = 40 * example::k_gravity * 0.8;
      double a = 0;
      for (int k = 0; k < 50; ++k) a -= (400 * a - moment * std::cos(a)) / (400 + moment * std::sin(a));
      EXPECT_NEAR(system.parts()[0].coordinates[0], a, balance == BalanceKind::rigid ? 1e-12 : 1e-4);
      const double weight = example::k_gravity * (example::k_mass + 40);
      EXPECT_NEAR(rest.carried->about_joint.force.z(), weight, 1e-9 * weight);
      const Vec3 lever = system.parts()[0].state.pose.p - model.carriage->motion.at(0).p;
      const Vec3 hull = system.state().pose.p - model.carriage->motion.at(0).p;
      const Vec3 torque = example::k_gravity * (40 * lever + example::k_mass * hull).cross(Vec3::UnitZ());
      EXPECT_NEAR((rest.carried->about_joint.torque - torque).norm(), 0, 1e-9 * weight);
      expect_rest(model, system, *rest.carried);
    }
}

TEST(JointedRest, ASprungSliderGivesWayByItsWeight) {
  for (const auto theta : k_schemes) {
    VesselModel model = towed(BalanceKind::six_cells, theta);
    PartModel part = arm(5e4);
    part.joint = JointKind::slider;
    part.axis_V = Vec3::UnitZ();
    part.rest = 0.05;
    model.parts = {part};
    VesselSystem system(model, 0);
    const VesselRest rest = system.settle(under_weight(model), true);
    ASSERT_TRUE(rest.carried.has_value());
    // the hull's trim on its cells turns the slider by less than a thousandth
    EXPECT_NEAR(system.parts()[0].coordinates[0], 0.05 - 40 * example::k_gravity / 5e4, 1e-8);
    expect_rest(model, system, *rest.carried);
  }
}

/// Weight holds a pendulum, on a hinge and on a ball, and the chain of both.
TEST(JointedRest, WhatHangsWithoutASpringComesToRestBelow) {
  VesselModel model = towed(BalanceKind::six_cells, 0.5);
  PartModel first = arm(0);
  first.in_V.p = {5.5, 0.1, -0.6};
  PartModel second = first;
  second.joint = JointKind::ball;
  second.to = 0;
  second.point_V = {5.6, 0.1, -0.9};
  second.in_V.p = {5.8, 0.3, -1.8};
  model.parts = {first, second};
  VesselSystem system(model, 0);
  const VesselRest rest = system.settle(under_weight(model), true);
  ASSERT_TRUE(rest.carried.has_value());
  EXPECT_GT(std::abs(system.parts()[0].coordinates[0]), 0.1);
  expect_rest(model, system, *rest.carried);
}

TEST(JointedRest, WhatNothingBringsBackStartsAsPlaced) {
  VesselModel model = towed(BalanceKind::six_cells, 0.5);
  model.parts = {arm(400), arm(0)};
  VesselSystem system(model, 0);
  const VecX placed = system.coordinates();
  const VesselRest rest = system.settle(under_weight(model), true);
  EXPECT_FALSE(rest.carried.has_value());
  EXPECT_EQ(rest.moving_part, std::optional<std::size_t>(1));
  EXPECT_EQ(system.coordinates(), placed);
  // upright on a spring too weak, and one that the scene sets going
  for (const bool goes : {false, true}) {
    VesselModel other = towed(BalanceKind::rigid, 0.5);
    PartModel part = arm(goes ? 400 : 100);
    if (goes)
      part.rate = 0.1;
    else
      part.in_V.p = {5, 0.1, 1.4};
    other.parts = {part};
    VesselSystem moving(other, 0);
    EXPECT_EQ(moving.settle(under_weight(other), true).moving_part, std::optional<std::size_t>(0)) << goes;
  }
}

/// Its axis is upright: weight has no moment about it, so it rests wherever it stands.
TEST(JointedRest, AnUprightHingeWithoutASpringStays) {
  VesselModel model = towed(BalanceKind::rigid, 0.5);
  PartModel part = arm(0);
  part.axis_V = Vec3::UnitZ();
  part.coordinate = 0.4;
  model.parts = {part};
  VesselSystem system(model, 0);
  const VesselRest rest = system.settle(under_weight(model), true);
  ASSERT_TRUE(rest.carried.has_value());
  EXPECT_EQ(system.parts()[0].coordinates[0], 0.4);
  expect_rest(model, system, *rest.carried);
}

TEST(JointedRest, AsPlacedHasTheTareOfRest) {
  VesselModel model = towed(BalanceKind::six_cells, 0.5);
  model.parts = {arm(400)};
  VesselSystem settled(model, 0), placed(model, 0);
  const VecX before = placed.coordinates();
  const VesselRest one = settled.settle(under_weight(model), true), two = placed.settle(under_weight(model), false);
  EXPECT_EQ(one.carried.value().cells, two.carried.value().cells);
  EXPECT_EQ(placed.coordinates(), before);
  EXPECT_NE(settled.coordinates(), before);
}

}  // namespace jointed_rest_test
}  // namespace nilas::vessel
