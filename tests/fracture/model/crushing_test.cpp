/// Tests of the forces of hulls driven steadily into ice against closed forms, and of the crushed volume.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/core/sim/crushing_rig.h"

namespace crushing_test {

using namespace nilas;
using namespace nilas::fracture;
using namespace nilas::test;

TEST(Crushing, ForceOfASteadyWedgeIsStrengthTimesArea) {
  Rig rig(towed("wedge.stl", -0.0025) + crushing(k_seed), 0.01);
  for (int k = 0; k < 100; ++k) {
    const double depth = std::max(0.0, rig.front(0));
    const sim::StepRecord record = rig.step();
    const Vec3 force = record.vessel->contact.force;
    const double expected = k_strength * depth * k_thickness;  // both sides, along x
    EXPECT_NEAR(force.x(), -expected, 1e-9 * (1 + expected));
    EXPECT_NEAR(force.y(), 0, 1e-9 * (1 + expected));
    EXPECT_NEAR(force.z(), 0, 1e-9 * (1 + expected));
  }
}

TEST(Crushing, ForceOfASteadyFlaredWedge) {
  Rig rig(towed("flared.stl", -0.13) + crushing(k_seed), 0.01);
  bool partial = false, full = false;
  for (int k = 0; k < 120; ++k) {
    const double at_middle = rig.front(0) - 0.5;  // the edge is 0.5 m further forward 1 m up
    // the edge stands at at_middle + z/2 at height z: from there up the sides are in the ice
    const double low = std::max(-k_thickness / 2, -2 * at_middle);
    const sim::StepRecord record = rig.step();
    const Vec3 force = record.vessel->contact.force;
    double expected_x = 0, expected_z = 0;
    if (low < k_thickness / 2) {
      const double top = at_middle + k_thickness / 4, bottom = at_middle + low / 2;
      expected_x = k_strength * (top * top - bottom * bottom);        // of the frontal width at_middle + z/2
      expected_z = k_strength * 0.5 * (top * top - bottom * bottom);  // of the sections' areas
      (low > -k_thickness / 2 ? partial : full) = true;
    }
    EXPECT_NEAR(force.x(), -expected_x, 1e-9 * (1 + expected_x)) << at_middle;
    EXPECT_NEAR(force.z(), expected_z, 1e-9 * (1 + expected_x));
  }
  EXPECT_TRUE(partial && full);
}

TEST(Crushing, DoublingTheStrengthDoublesTheForce) {
  for (const std::string& model : {k_seed, k_compliant}) {
    Rig one(towed("wedge.stl", -0.0025) + crushing(model), 0.01);
    Rig two(towed("wedge.stl", -0.0025) + crushing(model, 2 * k_strength), 0.01);
    for (int k = 0; k < 50; ++k) {
      const Vec3 once = one.step().vessel->contact.force, twice = two.step().vessel->contact.force;
      EXPECT_NEAR(twice.x(), 2 * once.x(), 1e-9 * std::abs(twice.x()));
    }
    EXPECT_LT(one.step().vessel->contact.force.x(), -1000);
  }
}

/// The implicit force at steady speed is that of the area at the step's end.
TEST(Crushing, ImplicitForceIsThatOfTheStepsEnd) {
  Rig rig(towed("wedge.stl", -0.0025) + crushing(k_compliant), 0.01);
  for (int k = 0; k < 60; ++k) {
    const sim::StepRecord record = rig.step();
    const double expected = k_strength * std::max(0.0, rig.front(0)) * k_thickness;
    EXPECT_NEAR(record.vessel->contact.force.x(), -expected, 1e-9 * (1 + expected)) << k;
  }
}

/// C A^(1 + e) with the area A of the front alone, however deep the sides stand in the ice, and when the rear does.
TEST(Crushing, PressureAreaCountsTheFacesThatPress) {
  for (const double angle : {0.0, 33.0}) {
    Rig rig(towed("pile.stl", -0.0025, angle) + crushing("model='pressure-area' coefficient='2e5' exponent='-0.7'"),
            0.01);
    const double expected = 2e5 * std::pow(0.6 * k_thickness, 0.3);
    double deepest = 0;
    for (int k = 0; k < 200; ++k) {
      const Vec3 force = rig.step().vessel->contact.force;
      if (k == 0) continue;  // in which it only comes to touch
      const Vec2 along = turned(angle, 1, 0);
      EXPECT_NEAR(force.head<2>().dot(along), -expected, 1e-6 * expected) << k;
      deepest = 0.005 * k;
    }
    EXPECT_GT(deepest, 0.9) << "the rear is in the ice";
  }
}

TEST(Crushing, ItsEnergyIsTheWorkOfItsForce) {
  for (const std::string& model :
       {k_seed, k_compliant, std::string("model='pressure-area' coefficient='1e5' exponent='-0.3'")}) {
    Rig rig(towed("flared.stl", -0.13) + crushing(model), 0.01, 1, "", 0.1);
    double work = 0;
    sim::StepRecord record;
    for (int k = 0; k < 100; ++k) {
      record = rig.step();
      work -= record.vessel->contact.force.x() * 0.5 * 0.01;
    }
    const sim::Ledger& ledger = record.ledger;
    EXPECT_GT(ledger.crushing, 100);
    EXPECT_NEAR(ledger.crushing, work - ledger.friction, 1e-6 * work) << model;
    EXPECT_EQ(ledger.impact, 0);
    EXPECT_LE(std::abs(ledger.imbalance), 1e-12 * work);
    // without the term the ledger is open
    EXPECT_GT(std::abs(ledger.imbalance - ledger.crushing), 0.1 * work);
  }
}

/// A face's area at each step's start times its displacement in the step.
TEST(Crushing, CrushedMassIsWhatTheFacesWentThrough) {
  for (const std::string& model : {k_seed, k_compliant}) {
    Rig rig(towed("wedge.stl", -0.0025) + crushing(model), 0.01);
    double area = 0;
    sim::StepRecord record;
    for (int k = 0; k < 100; ++k) {
      area += std::max(0.0, rig.front(0)) * k_thickness;
      record = rig.step();
    }
    const double swept = model == k_seed ? area * 0.5 * 0.01 : 0.5 * std::pow(rig.front(0), 2) * k_thickness;
    EXPECT_NEAR(rig.simulation.total("crushed_mass"), 920 * swept, (model == k_seed ? 1e-9 : 0.02) * 920 * swept)
        << model;
    EXPECT_NEAR(rig.simulation.total("crushed_mass"), 920 * record.ledger.crushing / k_strength, 1e-9 * 920 * swept);
  }
}

/// A box that turns as it goes presses with its sides on ice that they were never in: all that it sweeps is crushed.
/// The swept area by cells of 2 cm.
TEST(Crushing, ATurningHullCrushesWhatItSweeps) {
  Rig rig(
      "<body name='box' shape='box' size='1 0.4 2' mass='1e9' position='-0.505 0 0' velocity='0.5 0 0' "
      "angular_velocity='0 0 0.4'/><ice thickness='0.25'><floe fixed='true' breakable='true' outline='0 -3 4 -3 4 3 0 "
      "3'/></ice>" +
          crushing(k_seed),
      0.02);
  constexpr int k_across = 200, k_along = 100;
  constexpr double k_cell = 0.02;
  std::vector<char> swept(static_cast<std::size_t>(k_across) * k_along, 0);
  for (int k = 0; k < 200; ++k) {
    rig.step();
    const std::size_t box = rig.hull();
    for (std::size_t i = 0; i < swept.size(); ++i) {
      const Vec3 x(k_cell * (0.5 + static_cast<double>(i % k_along)),
                   k_cell * (0.5 + static_cast<double>(i / k_along)) - 2, 0);
      const Vec3 in_box = rig.bodies().R_GB[box].transpose() * (x - rig.bodies().p_GB[box]);
      if (std::abs(in_box.x()) < 0.5 && std::abs(in_box.y()) < 0.2) swept[i] = 1;
    }
  }
  const auto cells = static_cast<double>(std::count(swept.begin(), swept.end(), 1));
  const double mass = 920 * k_thickness * k_cell * k_cell * cells;
  EXPECT_NEAR(rig.simulation.total("crushed_mass"), mass, 0.02 * mass);
}

/// Driven in, back, and in again along a track.
TEST(Crushing, CrushedIceDoesNotPushBack) {
  for (const std::string& model : {k_seed, k_compliant}) {
    const std::string track =
        "<vessel hull='wedge.stl' position='-0.0025 0 0'><mass value='1000'/><carriage><path "
        "file='track.csv'/></carriage></vessel><ice thickness='0.25'><floe fixed='true' "
        "breakable='true' outline='0 -3 4 -3 4 3 0 3'/></ice>";
    Rig rig(track + crushing(model), 0.01);
    double deepest = 0;
    int behind = 0, again = 0;
    for (int k = 0; k < 150; ++k) {
      const double before = rig.front(0);
      const sim::StepRecord record = rig.step();
      const double after = rig.front(0), force = -record.vessel->contact.force.x();
      deepest = std::max(deepest, before);
      const double most = k_strength * k_thickness * std::max(after, before);
      EXPECT_LE(force, most * (1 + 1e-9));
      EXPECT_GE(force, 0);
      if (std::max(after, before) < deepest - 1e-9) {
        EXPECT_EQ(force, 0) << model << " at step " << k;
        ++behind;
      } else if (before >= deepest && after > before) {
        EXPECT_GE(force, k_strength * k_thickness * before * (1 - 1e-9));
        if (behind > 0) ++again;
      }
    }
    EXPECT_GT(behind, 30);
    EXPECT_GT(again, 20);
  }
}

}  // namespace crushing_test
