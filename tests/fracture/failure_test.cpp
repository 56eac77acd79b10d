#include "fracture/failure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/mass_properties.h"
#include "fracture/cut/cut_outline.h"

namespace nilas::fracture {
namespace failure_test {

constexpr double k_E = 5e9, k_water = 1025;

/// A sheet of 200 m, its edge y = 0, with its middle in x = 0.
const std::vector<Vec2> k_sheet{{-100, 0}, {100, 0}, {100, 200}, {-100, 200}};

FailureSettings bending() {
  FailureSettings settings;
  settings.youngs_modulus = k_E;
  settings.water_density = k_water;
  settings.bending = true;
  return settings;
}

EdgeContact load(double P, double width = 4, double depth = 3) {
  EdgeContact contact;
  contact.inward = Vec2::UnitY();
  contact.force = {0, P, -P};
  contact.width = width;
  contact.depth = depth;
  contact.pushes_in = true;
  return contact;
}

IceAtContact ice(double thickness = 1, double strength = 5e5, double toughness = 1.15e5) {
  return {thickness, strength, toughness};
}

TEST(Failure, BendingStatesAreThoseOfTheOracles) {
  const FailureRules rules(bending());
  const IcePlate plate{1, k_E, 0.3, k_water, 9.81};
  const double l = characteristic_length(plate), l_beam = beam_characteristic_length(plate);
  EXPECT_NEAR(l, 14.608, 5e-4);
  const BendingState state = rules.bending_state(k_sheet, load(1e5, 0.2 * 2 * l, 0.2 * l_beam), ice());
  EXPECT_NEAR(state.radial, 3.380 * 1e5 / 5e5, 1e-3 * state.radial) << "sigma h^2 / P at b/l = 0.2";
  ASSERT_EQ(state.fan.wedges, 4);
  const double b0 = 2 * std::tan(k_pi / 8);
  const WedgeResponse exact = solve_wedge(TipLoad::pressure, 0.2);
  EXPECT_NEAR(1 / exact.curvature, 1.469, 0.0125 * 1.469) << "the finite elements of Nevel's wedge";
  EXPECT_NEAR(1e5 / state.wedges, 4 * b0 * 5e5 / 6 / exact.curvature, 1e-5 * 1e5 / state.wedges);
  EXPECT_NEAR(state.radius, exact.x_max * l_beam, 1e-5 * state.radius);
  EXPECT_NEAR(exact.x_max, 0.681, 0.005 * 0.681);
}

/// Each constant's power, with the contact in fixed proportion to the characteristic length where that changes.
TEST(Failure, LoadsFollowTheirPowers) {
  const FailureRules rules(bending());
  const BendingState once = rules.bending_state(k_sheet, load(1e5, 8, 6), ice());
  const BendingState stronger = rules.bending_state(k_sheet, load(1e5, 8, 6), ice(1, 1e6));
  EXPECT_NEAR(stronger.radial / once.radial, 0.5, 1e-12);
  EXPECT_NEAR(stronger.wedges / once.wedges, 0.5, 1e-12);
  EXPECT_EQ(stronger.radius, once.radius);
  const double longer = std::pow(2, 0.75);
  const BendingState thicker = rules.bending_state(k_sheet, load(1e5, 8 * longer, 6 * longer), ice(2));
  EXPECT_NEAR(thicker.radial / once.radial, 0.25, 1e-9) << "P ~ h^2";
  EXPECT_NEAR(thicker.wedges / once.wedges, 0.25, 1e-9);
  EXPECT_NEAR(thicker.radius / once.radius, longer, 1e-9) << "R ~ h^(3/4)";
  FailureSettings stiff = bending();
  stiff.youngs_modulus = 16 * k_E;
  const BendingState stiffer = FailureRules(stiff).bending_state(k_sheet, load(1e5, 16, 12), ice());
  EXPECT_NEAR(stiffer.radial / once.radial, 1, 1e-9) << "P at fixed b/l does not know E";
  EXPECT_NEAR(stiffer.radius / once.radius, 2, 1e-9) << "R ~ E^(1/4)";
}

/// Failure modes below the strength are reported when asked for, with the load over the strength.
TEST(Failure, WaysBelowTheStrengthAreToldWhereAsked) {
  FailureSettings settings = bending();
  settings.splitting = SplittingModel::lefm;
  const FailureRules rules(settings);
  const BendingState state = rules.bending_state(k_sheet, load(1e5), ice());
  const double bends = std::min(state.radial, state.wedges);
  ASSERT_LT(bends, 1);
  EXPECT_TRUE(rules.failures(k_sheet, load(1e5), ice()).empty());
  EXPECT_TRUE(rules.failures(k_sheet, load(1e5), ice(), 1.001 * bends).empty());
  const std::vector<Failure> ways = rules.failures(k_sheet, load(1e5), ice(), 0.999 * bends);
  ASSERT_EQ(ways.size(), 1u);
  EXPECT_EQ(ways[0].ratio, bends);
}

TEST(Failure, NarrowLoadsCountAsWestergaardsEquivalent) {
  const FailureRules rules(bending());
  const double equivalent = 1 - 0.675;  // of a point on ice of 1 m
  const BendingState point = rules.bending_state(k_sheet, load(1e5, 0, 0), ice());
  const BendingState narrow = rules.bending_state(k_sheet, load(1e5, 2 * 1.724 * 0.999999, 1.724 * 0.999999), ice());
  const BendingState wide = rules.bending_state(k_sheet, load(1e5, 2 * 1.724 * 1.000001, 1.724 * 1.000001), ice());
  EXPECT_GT(point.radius, 0);
  const IcePlate plate{1, k_E, 0.3, k_water, 9.81};
  const EdgeLoad edge(0.3);
  EXPECT_NEAR(point.radial, 1e5 / radial_crack_load(edge, equivalent, characteristic_length(plate), 1, 5e5), 1e-12);
  EXPECT_NEAR(narrow.radial, wide.radial, 2e-3 * wide.radial) << "the formula joins within its own rounding";
}

TEST(Failure, BendsOnlyWhereBothStagesFailAndTheIceIsLongEnough) {
  const FailureRules rules(bending());
  const BendingState at_one = rules.bending_state(k_sheet, load(1), ice());
  const double bears = 1 / std::min(at_one.radial, at_one.wedges);
  EXPECT_TRUE(rules.failures(k_sheet, load(0.999 * bears), ice()).empty());
  const auto found = rules.failures(k_sheet, load(1.001 * bears), ice());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, FailureKind::bending);
  EXPECT_NEAR(found[0].ratio, 1.001, 1e-9);
  EXPECT_TRUE(rules.failures(k_sheet, load(-1.001 * bears), ice()).size() == 1) << "lifted ice bends as well";
  const double R = at_one.radius;
  const double outermost = std::cos(1.5 * k_pi / 4);  // middle of the first of four wedges, from the edge's normal
  ASSERT_EQ(rules.bending_state(k_sheet, load(1), ice()).fan.wedges, 4);
  for (const double share : {0.99, 1.01}) {
    const double depth = share * outermost * R;
    const std::vector<Vec2> strip{{-100, 0}, {100, 0}, {100, depth}, {-100, depth}};
    EXPECT_EQ(rules.failures(strip, load(2 * bears), ice()).size(), share > 1 ? 1u : 0u);
  }
  // a narrow tongue of the same ice far behind is no reason to hold
  const std::vector<Vec2> tongued{{-100, 0},           {100, 0},  {100, 152}, {-90, 152}, {-90, 152 - 0.1 * R},
                                  {99, 152 - 0.1 * R}, {99, 150}, {-100, 150}};
  EXPECT_EQ(rules.failures(tongued, load(2 * bears), ice()).size(), 1u);
  const CutResult cut = cut_outline(k_sheet, found[0].cracks);
  ASSERT_EQ(cut.status, CutStatus::cut);
  EXPECT_EQ(cut.pieces.size(), 5u) << "four wedges and the rest";
}

/// Left between two breaks and pressed from the side: across the load there is less ice than R_bending.
TEST(Failure, ATongueBreaksOff) {
  const FailureRules rules(bending());
  const BendingState at_one = rules.bending_state(k_sheet, load(1), ice());
  const double R = at_one.radius, P = 2 / std::min(at_one.radial, at_one.wedges), half = 0.2 * R;
  const std::vector<Vec2> sheet{{-100, 0}, {-half, 0}, {-half, -2 * R}, {half, -2 * R},
                                {half, 0}, {100, 0},   {100, 200},      {-100, 200}};
  EdgeContact from_left = load(P);
  from_left.inward = Vec2::UnitX();
  from_left.edge_point = {-half, -1.5 * R};
  const auto found = rules.failures(sheet, from_left, ice());
  ASSERT_EQ(found.size(), 1u);
  const CutResult cut = cut_outline(sheet, found[0].cracks);
  ASSERT_EQ(cut.status, CutStatus::cut);
  double largest = 0;
  for (const auto& piece : cut.pieces) largest = std::max(largest, geometry::polygon_moments(piece.outline).area);
  EXPECT_GT(largest, 200.0 * 200);
  EXPECT_LT(largest, 200.0 * 200 + 2 * half * R) << "most of the tongue is off";
}

TEST(Failure, WedgesBreakShorterUnderASpeedThatShortensThem) {
  FailureSettings settings = bending();
  settings.speed.slope = -0.14;
  EdgeContact fast = load(1e5);
  fast.speed = 2;
  const double still = FailureRules(bending()).bending_state(k_sheet, fast, ice()).radius;
  EXPECT_NEAR(FailureRules(settings).bending_state(k_sheet, fast, ice()).radius, (1 - 0.28) * still, 1e-12);
  fast.speed = 100;
  EXPECT_NEAR(FailureRules(settings).bending_state(k_sheet, fast, ice()).radius, 0.25 * still, 1e-12);
}

TEST(Failure, SeedRuleSplitsByTheChord) {
  FailureSettings settings = bending();
  settings.splitting = SplittingModel::geometric;
  const FailureRules rules(settings);
  const BendingState at_one = rules.bending_state(k_sheet, load(1), ice());
  const double R = at_one.radius, P = 1.001 / at_one.radial;  // radial cracks alone
  const auto floe = [](double length) { return std::vector<Vec2>{{-9, 0}, {9, 0}, {9, length}, {-9, length}}; };
  EXPECT_TRUE(rules.failures(floe(0.99 * R), load(P), ice()).empty());
  for (const double share : {1.01, 2.49}) {
    const auto found = rules.failures(floe(share * R), load(P), ice());
    ASSERT_EQ(found.size(), 1u) << share;
    EXPECT_EQ(found[0].kind, FailureKind::splitting);
    ASSERT_EQ(found[0].cracks.size(), 1u);
    EXPECT_NEAR((found[0].cracks[0].back() - found[0].cracks[0].front()).norm(), share * R, 1e-9);
  }
  EXPECT_TRUE(rules.failures(floe(2.51 * R), load(P), ice()).empty()) << "bending wins, but the wedges hold";
  const auto bends = rules.failures(floe(2.51 * R), load(1.001 / at_one.wedges), ice());
  ASSERT_EQ(bends.size(), 1u);
  EXPECT_EQ(bends[0].kind, FailureKind::bending);
}

/// F_Y = 0.187 K h sqrt(L) of the square floe; in competition small floes split and large ones bend.
TEST(Failure, LefmSplitsAtWhatTheFloeBears) {
  FailureSettings settings = bending();
  settings.splitting = SplittingModel::lefm;
  const FailureRules rules(settings);
  const auto square = [](double L) { return std::vector<Vec2>{{-L / 2, 0}, {L / 2, 0}, {L / 2, L}, {-L / 2, L}}; };
  const auto opened = [](double F_Y, double P) {
    EdgeContact contact = load(P);
    contact.opening = F_Y;
    return contact;
  };
  const double F = 0.187 * 1.15e5 * std::sqrt(100);
  EXPECT_NEAR(F, 215e3, 1e3);
  const auto state = rules.splitting_state(square(100), opened(F, 0), ice());
  ASSERT_TRUE(state.has_value());
  EXPECT_NEAR(state->ratio, 1, 2e-3);
  EXPECT_NEAR(rules.splitting_state(square(100), opened(F, 0), ice(1, 5e5, 2.3e5))->ratio, 0.5, 1e-3) << "F ~ K";
  EXPECT_NEAR(rules.splitting_state(square(100), opened(F, 0), ice(2))->ratio, 0.5, 1e-3) << "F ~ h";
  EXPECT_NEAR(rules.splitting_state(square(400), opened(F, 0), ice())->ratio, 0.5, 1e-3) << "F ~ sqrt(L)";
  const double P = 1.2 / rules.bending_state(k_sheet, load(1), ice()).wedges;
  EXPECT_EQ(rules.failures(square(60), opened(2e5, P), ice())[0].kind, FailureKind::splitting);
  EXPECT_EQ(rules.failures(square(2000), opened(2e5, P), ice())[0].kind, FailureKind::bending);
  EXPECT_FALSE(rules.splitting_state(square(100), EdgeContact{}, ice()).has_value()) << "no direction, no crack";
}

TEST(Failure, CurvedCracksInIceThatIsAlikeAreStraight) {
  FailureSettings settings = bending();
  settings.splitting = SplittingModel::lefm;
  const FailureRules straight(settings);
  settings.curved = true;
  const FailureRules curved(settings);
  const LocalIce alike;
  LocalIce stated;
  stated.flexural_strength = [](const Vec2&) { return 5e5; };
  stated.fracture_toughness = [](const Vec2&) { return 1.15e5; };
  IceAtContact none = ice(), same = ice();
  none.around = &alike;
  same.around = &stated;
  EdgeContact contact = load(1e6);
  contact.opening = 4e5;
  const auto a = straight.failures(k_sheet, contact, ice()), b = curved.failures(k_sheet, contact, none),
             c = curved.failures(k_sheet, contact, same);
  ASSERT_EQ(a.size(), 2u);
  ASSERT_EQ(b.size(), 2u);
  ASSERT_EQ(c.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(b[i].ratio, a[i].ratio);
    EXPECT_EQ(b[i].cracks, a[i].cracks);
    EXPECT_NEAR(c[i].ratio, a[i].ratio, 1e-9 * a[i].ratio);
    EXPECT_NEAR(c[i].radius, a[i].radius, 1e-9);
  }
}

/// Ice with a weak half ring of half the strength around the load, of eight chords that touch this radius.
LocalIce ringed(double radius) {
  bodies::WeakLine ring{{}, 0.5};
  for (int k = 0; k <= 8; ++k)
    ring.points.emplace_back(radius / std::cos(k_pi / 16) * std::cos(k_pi * k / 8),
                             radius / std::cos(k_pi / 16) * std::sin(k_pi * k / 8));
  LocalIce around;
  around.weak_lines = {ring};
  return around;
}

/// Weak lines cross all wedges at their breaking length, or follow the splitting crack: both loads fall in proportion
/// to the remaining strength.
TEST(Failure, WeakLinesLowerTheLoad) {
  FailureSettings settings = bending();
  settings.splitting = SplittingModel::lefm;
  settings.curved = true;
  const FailureRules rules(settings);
  EdgeContact contact = load(1e6);
  contact.opening = 4e5;
  const BendingState whole = rules.bending_state(k_sheet, contact, ice());
  LocalIce around = ringed(whole.radius);
  IceAtContact weak = ice();
  weak.around = &around;
  const BendingState state = rules.bending_state(k_sheet, contact, weak);
  EXPECT_NEAR(state.wedges / whole.wedges, 2, 0.01) << "the chords of the ring are 2 % off its circle";
  around.weak_lines = {{{{0, 0}, {0, 200}}, 0.25}};
  EXPECT_NEAR(rules.splitting_state(k_sheet, contact, weak)->ratio,
              4 * rules.splitting_state(k_sheet, contact, ice())->ratio, 1e-6);
}

/// Damaged ice fails at a share of its strength. It then breaks along the same weak lines as whole ice does at its
/// strength, and all ratios are proportional to the load.
TEST(Failure, WeakLinesLowerTheLoadOfDamagedIceToo) {
  FailureSettings settings = bending();
  settings.curved = true;
  const FailureRules rules(settings);
  const BendingState at_one = rules.bending_state(k_sheet, load(1), ice());
  const double P = 0.8 / at_one.radial;
  const LocalIce around = ringed(at_one.radius);
  IceAtContact weak = ice();
  weak.around = &around;
  constexpr double k_share = 0.3;
  ASSERT_LT(P * at_one.wedges, k_share) << "without the weak line this load would not break the wedges";
  const auto damaged = rules.failures(k_sheet, load(P), weak, k_share);
  const auto whole = rules.failures(k_sheet, load(2 * P), weak, k_share);
  ASSERT_EQ(damaged.size(), 1u);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_DOUBLE_EQ(2 * damaged[0].ratio, whole[0].ratio);
  EXPECT_EQ(damaged[0].cracks, whole[0].cracks);
}

}  // namespace failure_test
}  // namespace nilas::fracture
