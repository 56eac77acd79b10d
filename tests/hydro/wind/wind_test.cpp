#include "hydro/wind/wind.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/mass_properties.h"

namespace nilas::hydro {

namespace wind_test {

constexpr double k_level = 0.5;

WindSettings blowing(double speed, double direction_deg) {
  WindSettings settings;
  settings.speed = speed;
  settings.direction = direction_deg * k_deg;
  return settings;
}

int add(bodies::Bodies& bodies, bodies::BodyKind kind, const geometry::Shape& shape, const Pose& pose,
        bodies::Motion motion = bodies::Motion::free) {
  bodies::BodySpec spec;
  spec.kind = kind;
  spec.motion = motion;
  spec.shape = std::make_shared<const geometry::Shape>(shape);
  spec.mass = 1000;
  spec.pose = pose;
  return bodies.add(spec);
}

bodies::Bodies ship(double yaw_deg, const Vec3& v) {
  bodies::Bodies bodies;
  add(bodies, bodies::BodyKind::vessel, geometry::box_shape({80, 18, 8}),
      {Quat(Eigen::AngleAxisd(yaw_deg * k_deg, Vec3::UnitZ())), {10, 20, 1.5}}, bodies::Motion::articulated);
  bodies.v_GB[0] = v;
  return bodies;
}

WindOnVessel seen() {
  WindOnVessel vessel;
  vessel.midship = {-2, 0, 0};
  vessel.area.ship = BlendermannShip::offshore_supply;
  vessel.area.frontal = 350;
  vessel.area.lateral = 900;
  vessel.area.length = 83;
  vessel.area.centroid = -4;
  vessel.area.height = 7;
  return vessel;
}

Wrench load(const bodies::Bodies& bodies, const WindSettings& settings) {
  bodies::Wrenches out(static_cast<std::size_t>(bodies.size()));
  make_wind(settings, k_level, 1, seen())->add_forces(bodies, 0, out);
  return out[0];
}

/// Wind towards +Y at a ship that heads along X comes from starboard. q A_L C_Y = 0.5 1.225 15^2 900 0.9 acts at the
/// height 1.2 * 7 m above the water, 1 m below the centre of mass, and moments refer to the midship section, 2 m aft:
///   N = q C_N A_L L + (-2) Y, K about x = -(1.2 * 7 - 1) Y.
TEST(Wind, BeamWind) {
  const Wrench out = load(ship(0, Vec3::Zero()), blowing(15, 90));
  const double Y = 0.5 * 1.225 * 225 * 900 * 0.9;
  EXPECT_NEAR(out.force.x(), 0, 1e-9 * Y);
  EXPECT_NEAR(out.force.y(), Y, 1e-12 * Y);
  EXPECT_EQ(out.force.z(), 0);
  EXPECT_NEAR(out.torque.x(), -(1.2 * 7 - 1) * Y, 1e-9 * Y);
  EXPECT_NEAR(out.torque.y(), 0, 1e-9 * Y);
  EXPECT_NEAR(out.torque.z(), -4 * Y - 2 * Y, 1e-9 * Y);
}

/// A ship that makes 5 m/s against a wind of 10 m/s feels 15 m/s from ahead.
TEST(Wind, HeadWindIsRelative) {
  const Wrench out = load(ship(0, {5, 0, 0}), blowing(10, 180));
  const double X = -0.5 * 1.225 * 225 * 350 * 0.55;
  EXPECT_NEAR(out.force.x(), X, 1e-9 * std::abs(X));
  EXPECT_NEAR(out.torque.y(), (7 - 1) * X, 1e-9 * std::abs(X));
  EXPECT_NEAR(load(ship(0, {10, 0, 0}), blowing(10, 0)).force.norm(), 0, 1e-12) << "the ship goes with the wind";
}

/// The load turns with ship and wind, and mirrored winds give mirrored loads.
TEST(Wind, TurnsAndMirrors) {
  const Quat turn(Eigen::AngleAxisd(70 * k_deg, Vec3::UnitZ()));
  for (const double direction : {0.0, 35.0, 90.0, 145.0, 180.0}) {
    const Wrench here = load(ship(0, {1, 0.5, 0}), blowing(12, direction));
    const Wrench turned = load(ship(70, turn * Vec3(1, 0.5, 0)), blowing(12, direction + 70));
    EXPECT_LT((turned.force - turn * here.force).norm(), 1e-10 * here.force.norm());
    EXPECT_LT((turned.torque - turn * here.torque).norm(), 1e-10 * here.torque.norm());
    const Wrench mirrored = load(ship(0, {1, -0.5, 0}), blowing(12, -direction));
    EXPECT_LT((mirrored.force - Vec3(here.force.x(), -here.force.y(), 0)).norm(), 1e-10 * here.force.norm());
    EXPECT_LT((mirrored.torque - Vec3(-here.torque.x(), here.torque.y(), -here.torque.z())).norm(),
              1e-10 * here.torque.norm());
  }
}

/// rho C_a A |w| w on the dry upper face of free floes, and on nothing else.
TEST(Wind, FloesTakeSkinDragOfTheAir) {
  const geometry::Shape floe = geometry::prism_shape({{-2, -1}, {2, -1}, {2, 1}, {-2, 1}}, 0.4);
  const Quat level = Quat::Identity(), upside_down(Eigen::AngleAxisd(k_pi, Vec3::UnitX())),
             heeled(Eigen::AngleAxisd(60 * k_deg, Vec3::UnitX()));
  bodies::Bodies bodies;
  using bodies::BodyKind;
  add(bodies, BodyKind::floe, floe, {level, {0, 0, k_level}});
  add(bodies, BodyKind::floe, floe, {upside_down, {0, 0, k_level}});
  add(bodies, BodyKind::floe, floe, {heeled, {0, 0, k_level}});
  add(bodies, BodyKind::floe, floe, {level, {0, 0, k_level - 0.3}});
  add(bodies, BodyKind::floe, floe, {level, {0, 0, k_level}}, bodies::Motion::fixed);
  add(bodies, BodyKind::rigid, floe, {level, {0, 0, k_level}});
  for (auto& v : bodies.v_GB) v = {0.2, 0, 3};
  bodies::Wrenches out(6);
  const auto module = make_wind(blowing(10, 0), k_level, 1, std::nullopt);
  module->add_forces(bodies, 0, out);
  const double F = 1.225 * 0.002 * 8 * 9.8 * 9.8;
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_LT((out[b].force - Vec3(F, 0, 0)).norm(), 1e-12);
    EXPECT_LT((out[b].torque - Vec3(0, 0.2 * F, 0)).norm(), 1e-12);
  }
  EXPECT_LT((out[2].force - Vec3(0.5 * F, 0, 0)).norm(), 1e-12);
  for (std::size_t b = 3; b < 6; ++b) EXPECT_EQ(out[b].force, Vec3::Zero()) << b;
  EXPECT_EQ(module->load_on_vessel(), bodies::VesselLoad::none);
  EXPECT_EQ(module->drift(), std::optional<Vec3>(Vec3::Zero()));
}

TEST(Wind, NamesOnlyWhatItLoads) {
  WindSettings settings = blowing(10, 0);
  settings.floe_drag = 0;
  const auto module = make_wind(settings, k_level, 1, seen());
  EXPECT_EQ(module->load_on_vessel(), bodies::VesselLoad::own);
  EXPECT_EQ(module->drift(), std::nullopt);
  EXPECT_FALSE(module->conservative());
}

}  // namespace wind_test

}  // namespace nilas::hydro
