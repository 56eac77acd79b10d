/// Floes that crush each other: closed forms, whose faces count, accounts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "core/geometry/mass_properties.h"
#include "core/sim/build/module/crushing_settings.h"
#include "fracture/model/crushing.h"
#include "tests/core/sim/crushing_rig.h"

namespace crushing_floes_test {

using namespace nilas;
using namespace nilas::fracture;
using namespace nilas::test;

constexpr double k_density = 900, k_gap = 1e-3;
const std::vector<Vec2> k_pointed{{-k_gap, 0}, {-2 - k_gap, 1}, {-2 - k_gap, -1}};
const std::vector<Vec2> k_flat{{0, -3}, {4, -3}, {4, 3}, {0, 3}};
const std::vector<Vec2> k_plank{{-0.4 - k_gap, -1.5}, {-k_gap, -1.5}, {-k_gap, 1.5}, {-0.4 - k_gap, 1.5}};
const std::vector<Vec2> k_point_astern{{0, 0}, {2, -1}, {2, 1}};

std::string floe(const std::vector<Vec2>& corners, bool fixed) {
  return "<floe breakable='true' fixed='" + std::string(fixed ? "true" : "false") + "' outline='" +
         outline(0, corners) + "'/>";
}

std::string ice(const std::vector<Vec2>& moving, const std::vector<Vec2>& fixed) {
  return "<ice density='" + text(k_density) + "' thickness='" + text(k_thickness) + "'>" + floe(moving, false) +
         floe(fixed, true) + "</ice>";
}

std::string between_floes(const std::string& model, double strength = k_strength) {
  return crushing(model + " between_floes='true'", strength);
}

/// A floe that gravity pulls along x, over a gap and then into ice that resists with k depth: M g (gap + depth) =
/// 1/2 k depth^2 where it comes to rest, k = strength times thickness for a wedge of half angle atan 1/2.
TEST(CrushingOfFloes, DepthIsThatOfTheClosedForm) {
  const double g = 20;
  for (const auto& [moving, fixed] : {std::pair(k_pointed, k_flat), std::pair(k_plank, k_point_astern)}) {
    const double mass = k_density * k_thickness * geometry::polygon_moments(moving).area;
    const double weight = mass * g, k = k_strength * k_thickness;
    const double exact = (weight + std::sqrt(weight * (weight + 2 * k * k_gap))) / k;
    ASSERT_LT(exact, 1);
    for (const std::string& model : {k_seed, k_compliant}) {
      const double h = 1e-3;
      Rig rig(ice(moving, fixed) + between_floes(model), h, 1, "", 0, {g, 0, 0});
      const double start = rig.bodies().p_GB[0].x();
      sim::StepRecord record;
      for (int n = 0; n < 1000; ++n) record = rig.step();
      const double depth = rig.bodies().p_GB[0].x() - start - k_gap;
      EXPECT_NEAR(depth, exact, 0.02 * exact) << model;
      EXPECT_NEAR(rig.bodies().v_GB[0].norm(), 0, 1e-9) << "it rests where it crushed to";
      EXPECT_LE(std::abs(record.ledger.imbalance), 1e-11 * weight * exact);
      EXPECT_NEAR(record.ledger.crushing, weight * (k_gap + depth), 1e-6 * weight);
    }
  }
}

/// Whichever floe's faces count, an even pressure on them has the same resultant; those of the smaller area are taken.
TEST(CrushingOfFloes, FacesOfTheSmallerAreaCountAndTheWeakerIceYields) {
  Rig rig(ice(k_pointed, k_flat) + between_floes(k_seed), 0.01);
  bodies::Bodies bodies = rig.bodies();
  bodies.set_pose(0, bodies.p_GB[0] + Vec3(0.2 + k_gap, 0, 0), bodies.q_GB[0]);
  bodies.v_GB[0] = Vec3(1, 0, 0);
  for (const bool turned_over : {false, true}) {
    bodies::IceProperties ice;
    ice.resize(2);
    ice.breakable = {1, 1};
    ice.compressive_strength = {{turned_over ? 3e5 : 2e5, {}}, {turned_over ? 2e5 : 3e5, {}}};
    Crushing crush(sim::crushing_settings(rig.scene), bodies, ice);
    EXPECT_TRUE(crush.crushes(0, 1));
    const auto points = crush.points(bodies, {{0, 1}}, 0.01, 0.01);
    ASSERT_FALSE(points.empty());
    double force = 0;
    for (const detect::ContactPoint& c : points) {
      EXPECT_NEAR(c.n.x(), 1, 1e-12) << "the sheet's edge, not the floe's two sides";
      force += c.force_limit;
    }
    EXPECT_NEAR(force, 2e5 * 0.2 * k_thickness, 1e-6 * force);
  }
}

/// All its sides are in the sheet, none of the sheet's in it.
TEST(CrushingOfFloes, ASplinterWithinASheetIsBraked) {
  const std::vector<Vec2> splinter{{-0.4, -0.1}, {-0.2, -0.1}, {-0.2, 0.1}, {-0.4, 0.1}};
  for (const std::string& model : {k_seed, k_compliant}) {
    Rig rig(ice(splinter, k_flat) + between_floes(model), 0.01);
    bodies::Bodies bodies = rig.bodies();
    bodies.set_pose(0, bodies.p_GB[0] + Vec3(1, 0, 0), bodies.q_GB[0]);
    bodies.v_GB[0] = Vec3(1, 0, 0);
    bodies::IceProperties ice;
    ice.resize(2);
    ice.breakable = {1, 1};
    ice.compressive_strength = {{2e5, {}}, {3e5, {}}};
    Crushing crush(sim::crushing_settings(rig.scene), bodies, ice);
    double force = 0;
    for (const detect::ContactPoint& c : crush.points(bodies, {{0, 1}}, 0.01, 0.01))
      if (c.n.x() > 0.5) force += c.force_limit;
    EXPECT_NEAR(force, 2e5 * 0.2 * k_thickness, 1e-6 * force) << model;
  }
}

/// Two right angles that overlap have equal sides there: the places of the points decide whose faces count.
TEST(CrushingOfFloes, OfEqualAreasTheLighterFloesCountWhateverTheOrder) {
  const std::vector<Vec2> light{{0.2, 0}, {-0.8, 1}, {-1.3, 0.5}, {-1.3, -0.5}, {-0.8, -1}};
  const std::vector<Vec2> heavy{{-0.2, 0}, {0.8, -1}, {2.3, -1}, {2.3, 1}, {0.8, 1}};
  const auto mean_x = [&](bool turned_over) {
    Rig rig(ice(k_pointed, k_flat) + between_floes(k_seed), 0.01);
    bodies::Bodies bodies = rig.bodies();
    for (const auto& corners : {turned_over ? heavy : light, turned_over ? light : heavy}) {
      bodies::BodySpec floe;
      floe.kind = bodies::BodyKind::floe;
      floe.shape = std::make_shared<const geometry::Shape>(geometry::prism_shape(corners, k_thickness));
      floe.mass = k_density * k_thickness * geometry::polygon_moments(corners).area;
      floe.inertia_B = floe.mass * Mat3::Identity();
      bodies.add(floe);
    }
    bodies.remove({1, 1, 0, 0});
    bodies::IceProperties ice;
    ice.resize(2);
    ice.breakable = {1, 1};
    ice.compressive_strength.assign(2, {2e5, {}});
    Crushing crush(sim::crushing_settings(rig.scene), bodies, ice);
    double sum = 0, force = 0;
    for (const detect::ContactPoint& c : crush.points(bodies, {{0, 1}}, 0.01, 0.01)) {
      sum += c.force_limit * c.p.x();
      force += c.force_limit;
    }
    return sum / force;
  };
  EXPECT_NEAR(mean_x(false), 0.1, 1e-9) << "the light floe's point, which is the farther one";
  EXPECT_NEAR(mean_x(true), 0.1, 1e-9);
}

/// A step that is cut at an impact is begun anew: what it found before must not count. The plank comes to stand on the
/// point, or flies so far over it that nothing of the point stays in the plank.
TEST(CrushingOfFloes, WhatIsRememberedDependsOnPosesAlone) {
  for (const double depth : {0.05, -0.01}) {
    Rig rig(ice(k_plank, k_point_astern) + between_floes(k_compliant), 0.01);
    bodies::Bodies bodies = rig.bodies();
    bodies.set_pose(0, bodies.p_GB[0] + Vec3(depth + k_gap, 0, 0), bodies.q_GB[0]);
    bodies::IceProperties ice;
    ice.resize(2);
    ice.breakable = {1, 1};
    ice.compressive_strength = {{2e5, {}}, {2e5, {}}};
    const auto last_of = [&](const std::vector<double>& speeds) {
      Crushing crush(sim::crushing_settings(rig.scene), bodies, ice);
      std::vector<detect::ContactPoint> points;
      State state;
      for (const double speed : speeds) {
        bodies.v_GB[0] = Vec3(speed, 0, 0);
        points = crush.points(bodies, {{0, 1}}, 0.01, 0.01);
      }
      crush.save(StateWriter(state));
      std::vector<std::uint64_t> keys;
      for (const detect::ContactPoint& c : points) keys.push_back(c.key);
      return std::pair(keys, state.entries);
    };
    const auto direct = last_of({2});
    EXPECT_FALSE(direct.first.empty());
    for (const double before : {-50.0, 10.0, 90.0, 150.0}) EXPECT_EQ(last_of({before, 2}), direct) << before;
  }
}

TEST(CrushingOfFloes, WithoutItTheyAreRigid) {
  Rig rig(ice(k_pointed, k_flat) + crushing(k_compliant), 1e-3, 1, "", 0, {20, 0, 0});
  const double start = rig.bodies().p_GB[0].x();
  sim::StepRecord record;
  for (int n = 0; n < 200; ++n) record = rig.step();
  EXPECT_NEAR(rig.bodies().p_GB[0].x() - start, k_gap, 1e-5);
  EXPECT_EQ(record.ledger.crushing, 0);
}

}  // namespace crushing_floes_test
