/// Tests of floes that break in the step: breaking loads, conserved quantities, properties of the pieces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>

#include "core/geometry/mass_properties.h"
#include "fracture/bend/plate.h"
#include "fracture/split/splitting_lefm.h"
#include "tests/core/sim/breaking_rig.h"

namespace breaking_test {

using namespace nilas;
using namespace nilas::fracture;
using namespace nilas::test;

using Rig = BreakingRig;

/// The load that the wedges bear, within its growth in a step.
TEST(Breaking, ASheetBendsAtTheLoadOfItsWedges) {
  for (const double step : {0.01, 0.005, 0.0025, 0.00125}) {
    Rig rig(bow() + breaking_ice(), step);
    const sim::StepRecord record = rig.until_broken();
    ASSERT_EQ(record.broken.size(), 1u);
    const FractureEvent& event = record.broken[0];
    EXPECT_EQ(event.kind, "bending");
    EXPECT_EQ(event.t, record.t);
    EXPECT_GE(event.ratio, 1);
    // The load grows with less than the cube of the distance, which is proportional to time.
    EXPECT_LT(event.ratio - 1, 3 * step / record.t) << "more than the load grows by in a step";
    EXPECT_NEAR(event.p_G.y(), 0, 1e-9) << "the contact is symmetric";
    const double l = beam_characteristic_length({0.05, 1e8, 0.3, 1000, 9.81});
    EXPECT_GT(event.radius, 0.2 * l);
    EXPECT_LT(event.radius, 0.6 * l);
  }
}

TEST(Breaking, WedgesFloatFreeAndTheSheetStaysFixed) {
  Rig rig(bow() + breaking_ice());
  const double mass = rig.bodies().mass[1];
  const sim::StepRecord record = rig.until_broken();
  const bodies::Bodies& bodies = rig.bodies();
  const FractureEvent& event = record.broken[0];
  ASSERT_EQ(event.pieces.size(), 5u);
  EXPECT_EQ(event.floe, 2);
  EXPECT_EQ(event.pieces.front(), 3);
  ASSERT_EQ(bodies.size(), 6) << "the vessel and the pieces";
  EXPECT_EQ(bodies.kind[0], bodies::BodyKind::vessel);
  EXPECT_EQ(bodies.name[1], "floe 1 piece 3");
  double sum = 0;
  int fixed = 0;
  for (std::size_t b = 1; b < 6; ++b) {
    sum += bodies.mass[b];
    fixed += bodies.motion[b] == bodies::Motion::fixed ? 1 : 0;
    const double area = geometry::polygon_moments(bodies.shape[b]->outline).area;
    EXPECT_EQ(bodies.motion[b] == bodies::Motion::fixed, area > 50);
    EXPECT_EQ(bodies.R_GB[b], Mat3::Identity());
  }
  EXPECT_EQ(fixed, 1);
  EXPECT_NEAR(sum, mass, 1e-12 * mass);
  EXPECT_EQ(event.brash, 0);
  EXPECT_NEAR(event.length, 3 * event.radius + 8 * event.radius * std::sin(k_pi / 8), 1e-9)
      << "three radial cracks, the two along the edge left out, and four chords";
  EXPECT_EQ(rig.simulation.step().floes, 5);
}

/// No edge is near, so nothing of the models applies.
TEST(Breaking, ALoadInTheMiddleOfASheetBreaksNothing) {
  Rig rig(
      "<body shape='sphere' radius='0.2' mass='200' position='0 0 0.24' velocity='0.01 0 0'/>"
      "<ice thickness='0.05' density='900' youngs_modulus='1e8'><floe breakable='true' fixed='true' outline='-10 -10 "
      "10 -10 10 10 -10 10'/></ice>" +
      breaking_ice("<bending/><splitting model='lefm'/>"));
  for (int k = 0; k < 60; ++k) EXPECT_TRUE(rig.simulation.step().broken.empty());
}

/// A floe breaks while it moves and turns: momentum and energy are conserved.
TEST(Breaking, AFreeFloeKeepsMassMomentumAndEnergy) {
  Rig rig(bow("outline='0 -2 3 -1.5 3.5 1.5 0.1 2' velocity='-0.3 0.05 0'") +
          "<body shape='sphere' radius='0.05' mass='2' position='2.9 1 0.08' velocity='0 0 -0.5'/>" + breaking_ice());
  const double mass = rig.bodies().mass[1];
  sim::StepRecord before, record;
  do {
    before = record;
    record = rig.simulation.step();
  } while (record.broken.empty() && record.step < 3000);
  ASSERT_FALSE(record.broken.empty());
  const bodies::Bodies& bodies = rig.bodies();
  double sum = 0;
  for (std::size_t b = 0; b < bodies.id.size(); ++b)
    if (bodies.kind[b] == bodies::BodyKind::floe) sum += bodies.mass[b];
  EXPECT_NEAR(sum + record.broken[0].brash, mass, 1e-12 * mass);
  const double scale = std::abs(record.ledger.kinetic) + std::abs(record.ledger.potential);
  EXPECT_LE(std::abs(record.broken[0].energy), 1e-12 * scale);
  EXPECT_LE(std::abs(record.ledger.fracture), 1e-12 * scale);
  EXPECT_LE(std::abs(record.ledger.imbalance), 1e-11 * scale);
  EXPECT_LE(record.momentum_imbalance, 1e-9 * record.momentum_scale);
}

TEST(Breaking, SmallPiecesAreBrashOrStopIt) {
  const auto with = [](const std::string& small, double min_area) {
    return bow() + "<fracture flexural_strength='5e4' compressive_strength='2e5' min_area='" + text(min_area) +
           "' small_pieces='" + small + "'><crushing model='explicit'/><bending/></fracture>";
  };
  Rig brash(with("brash", 0.03));
  const double mass = brash.bodies().mass[1];
  const sim::StepRecord record = brash.until_broken();
  const FractureEvent& event = record.broken[0];
  EXPECT_EQ(event.pieces.size(), 1u) << "the sheet alone";
  EXPECT_GT(event.brash, 0);
  EXPECT_NEAR(brash.bodies().mass[1] + event.brash, mass, 1e-12 * mass);
  EXPECT_EQ(brash.simulation.total("brash_mass"), event.brash);
  EXPECT_EQ(brash.bodies().motion[1], bodies::Motion::fixed);

  Rig refuse(with("refuse", 1));
  for (int k = 0; k < 100; ++k) EXPECT_TRUE(refuse.simulation.step().broken.empty());
  EXPECT_EQ(refuse.bodies().size(), 2);
  EXPECT_GT(refuse.warnings.counts().at("floes that could not be cut"), 0);
}

/// The bow in the middle of a square floe opens it with F_Y on each side.
TEST(Breaking, LefmSplitsAFloeThatIsHeld) {
  Rig rig(bow("outline='0 -1 2 -1 2 1 0 1' fixed='true'") +
          breaking_ice("<splitting model='lefm'/>", "fracture_toughness='2e3'"));
  const sim::StepRecord record = rig.until_broken();
  ASSERT_EQ(record.broken.size(), 1u);
  const FractureEvent& event = record.broken[0];
  EXPECT_EQ(event.kind, "splitting");
  EXPECT_EQ(event.pieces.size(), 2u);
  EXPECT_EQ(std::count(rig.bodies().motion.begin(), rig.bodies().motion.end(), bodies::Motion::fixed), 1)
      << "one half is free";
  EXPECT_NEAR(event.length, 2, 1e-9);
  EXPECT_GE(event.ratio, 1);
  EXPECT_LT(event.ratio, 1.3);
  // without friction the bow's sides press square to themselves: F_Y / F_x as on its faces
  const double bears = 2e3 * 0.05 * std::sqrt(2) / SplittingTable().least(1).H;
  const Vec3 n = Vec3(1, 4, -1).normalized();  // of the face at y > 0
  const double F_x = -record.vessel->contact.force.x();
  EXPECT_NEAR(F_x / 2 * n.y() / n.x() / bears, event.ratio, 1e-6);
}

/// The load is that of the weak line's toughness; a second line, far behind, goes with the piece that it crosses.
TEST(Breaking, AFloeSplitsAlongItsWeakLine) {
  std::string content = bow("outline='0 -1 2 -1 2 1 0 1' fixed='true'");
  content.replace(
      content.find("</ice>"), 6,
      "<weak_line points='0 0 2 0.6' strength='0.5'/><weak_line points='1.5 0.8 1.9 0.8' strength='0.7'/></ice>");
  const auto models = [](const std::string& path) {
    return breaking_ice("<splitting model='lefm'/><cracks path='" + path + "' segment_thicknesses='1'/>",
                        "fracture_toughness='2e3'");
  };
  Rig straight(content + models("straight"));
  const sim::StepRecord passed_by = straight.until_broken();
  EXPECT_NEAR(passed_by.broken[0].length, 2, 1e-9);
  Rig rig(content + models("curved"));
  const sim::StepRecord record = rig.until_broken();
  const FractureEvent& event = record.broken[0];
  EXPECT_NEAR(event.length, std::hypot(2, 0.6), 1e-6);
  ASSERT_EQ(event.pieces.size(), 2u);
  const Vec3 n = Vec3(1, 4, -1).normalized();  // of the bow's face at y > 0
  const double F_Y = -record.vessel->contact.force.x() / 2 * n.y() / n.x();
  const double bears = 0.5 * 2e3 * 0.05 * std::sqrt(2) / SplittingTable().least(1).H;
  EXPECT_NEAR(F_Y / bears, event.ratio, 1e-4) << "H is least at the same share of the crack's length";
  std::vector<double> areas;
  for (std::size_t b = 1; b < 3; ++b) areas.push_back(geometry::polygon_moments(rig.bodies().shape[b]->outline).area);
  std::sort(areas.begin(), areas.end());
  EXPECT_NEAR(areas[0], 1.4, 1e-5);
  EXPECT_NEAR(areas[1], 2.6, 1e-5);
}

TEST(Breaking, PiecesKeepTheStrengthsOfTheirPlaces) {
  const std::string vary = "<vary property='flexural_strength' cov='0.3' correlation_length='0.5'/></ice>";
  std::string content = bow();
  content.replace(content.find("</ice>"), 6, vary);
  Rig rig(content + breaking_ice());
  rig.until_broken();
  // the same again, saved and restored: pieces find their strengths by their places in the scene's floe
  State state;
  rig.simulation.save(StateWriter(state));
  sim::Simulation other(rig.scene, 1, rig.warnings);
  other.restore(StateReader(state));
  bool again = false;
  for (int k = 0; k < 130; ++k) {
    const sim::StepRecord one = rig.simulation.step(), two = other.step();
    ASSERT_EQ(one.state_hash, two.state_hash) << k;
    ASSERT_EQ(one.broken.size(), two.broken.size());
    again = again || !one.broken.empty();
    for (std::size_t i = 0; i < one.broken.size(); ++i) EXPECT_EQ(one.broken[i].ratio, two.broken[i].ratio);
  }
  EXPECT_TRUE(again) << "pieces break too";
}

TEST(Breaking, ASheetOfFrozenFloesBreaksAlongItsSeams) {
  const std::string frozen =
      "<vessel hull='bow.stl' position='-0.02 0 0'><mass value='1000'/><carriage speed='0.3'/></vessel>"
      "<ice thickness='0.05' density='900' youngs_modulus='1e8'><field kind='voronoi' region='0 -3 6 3' "
      "concentration='1' breakable='true' fixed='true'><size distribution='fixed' mean='0.5'/>"
      "<bond strength='0.3'/></field></ice>" +
      breaking_ice("<bending/><cracks path='curved'/>");
  Rig rig(frozen);
  const double mass = rig.bodies().mass[1];
  sim::StepRecord record = rig.until_broken();
  EXPECT_LT(record.broken[0].ratio, 1.5);
  // saved, and on as if never stopped: the pieces find their seams by their places
  State state;
  rig.simulation.save(StateWriter(state));
  sim::Simulation other(rig.scene, 1, rig.warnings);
  other.restore(StateReader(state));
  std::size_t again = 0;
  for (int k = 0; k < 60; ++k) {
    const sim::StepRecord one = rig.simulation.step(), two = other.step();
    ASSERT_EQ(one.state_hash, two.state_hash) << k;
    again += one.broken.size();
  }
  EXPECT_GT(again, 0u);
  double left = rig.simulation.total("brash_mass");
  for (std::size_t b = 1; b < rig.bodies().mass.size(); ++b) left += rig.bodies().mass[b];
  EXPECT_NEAR(left, mass, 1e-12 * mass);
}

TEST(Breaking, IceThatNothingBreaksMovesAsIfItCouldNot) {
  const std::string floe = bow("outline='0 -2 3 -2 3 2 0 2'");
  const auto hashes = [&](const std::string& models) {
    Rig rig(floe + breaking_ice(models).replace(breaking_ice().find("5e4"), 3, "5e9"));
    std::vector<std::uint64_t> all;
    for (int k = 0; k < 100; ++k) all.push_back(rig.simulation.step().state_hash);
    return all;
  };
  EXPECT_EQ(hashes("<bending/><splitting/>"), hashes(""));
}

TEST(Breaking, ThreadsChangeNoBit) {
  Rig one(bow() + breaking_ice("<bending/><splitting/>")), two(bow() + breaking_ice("<bending/><splitting/>"), 0.01, 2);
  std::size_t broken = 0;
  for (int k = 0; k < 130; ++k) {
    const sim::StepRecord a = one.simulation.step(), b = two.simulation.step();
    ASSERT_EQ(a.state_hash, b.state_hash) << k;
    broken += a.broken.size();
  }
  EXPECT_GT(broken, 1u);
}

}  // namespace breaking_test
