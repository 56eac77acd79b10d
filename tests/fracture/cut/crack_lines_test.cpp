#include "fracture/cut/crack_lines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/polygon.h"
#include "tests/support/cut_judge.h"

namespace crack_lines_test {

using namespace nilas;
using namespace nilas::fracture;
using namespace nilas::test;

const Outline k_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
/// Limbs of 1 m and 2 m breadth, opening towards +x.
const Outline k_u_shape{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 4}, {0, 4}};

TEST(Chords, AreAllPartsInsideAheadOfThePoint) {
  const std::vector<Chord> up = chords(k_u_shape, {2, 0}, k_pi / 2);
  ASSERT_EQ(up.size(), 2u);
  EXPECT_NEAR((up[0].start - Vec2(2, 0)).norm() + (up[0].end - Vec2(2, 1)).norm(), 0, 1e-15);
  EXPECT_NEAR((up[1].start - Vec2(2, 2)).norm() + (up[1].end - Vec2(2, 4)).norm(), 0, 1e-15);
  EXPECT_TRUE(chords(k_u_shape, {2, 0}, -k_pi / 2).empty()) << "away from the ice";
  EXPECT_EQ(chords(k_u_shape, {2, 3}, k_pi / 2).size(), 1u) << "the limb behind does not count";
  EXPECT_TRUE(chords(k_square, {2, 0}, k_pi / 2).empty()) << "misses";
}

TEST(Chords, BeginAtTheEdgeWhenThePointIsInsideOrOutside) {
  for (const double y : {-0.2, 0.0, 1e-16, 0.2}) {
    const std::vector<Chord> found = chords(k_square, {0.3, y}, k_pi / 2);
    ASSERT_EQ(found.size(), 1u) << y;
    EXPECT_NEAR((found[0].start - Vec2(0.3, 0)).norm(), 0, 1e-15);
    EXPECT_NEAR(found[0].length(), 1, 1e-15);
  }
}

TEST(Chords, ThroughVerticesStayPaired) {
  const std::vector<Chord> diagonal = chords(k_square, {0, 0}, k_pi / 4);
  ASSERT_EQ(diagonal.size(), 1u);
  EXPECT_NEAR(diagonal[0].length(), std::sqrt(2), 1e-14);
}

TEST(Chords, TheShortestIsTheCandidate) {
  const auto chord = shortest_chord(k_u_shape, {2, 4}, -k_pi / 2);
  ASSERT_TRUE(chord.has_value());
  EXPECT_NEAR(chord->length(), 1, 1e-15) << "the limb of 1 m, behind that of 2 m";
  EXPECT_FALSE(shortest_chord(k_square, {0, 2}, 0).has_value());
}

TEST(Chords, CutTheFloeThatTheyCross) {
  RandomStream random(11, "chords");
  for (int i = 0; i < 300; ++i) {
    const Outline outline = sound_outline(any_shape, 1, Vec2::Zero(), random);
    const Vec2 point = on_edge(outline, random);
    const auto chord = shortest_chord(outline, point, random.uniform(0, 2 * k_pi));
    if (!chord || chord->length() < 1e-6) continue;
    const CutResult cut = cut_outline(outline, {{chord->start, chord->end}});
    ASSERT_EQ(cut.pieces.size(), 2u) << i;
    EXPECT_NEAR(cut.crack_length, chord->length(), 1e-13);
  }
}

TEST(NearestEdgePoint, IsTheFootOrACorner) {
  EXPECT_EQ(nearest_edge_place(k_square, {0.3, 0.1}).point, Vec2(0.3, 0));
  EXPECT_EQ(nearest_edge_place(k_square, {2, 3}).point, Vec2(1, 1));
}

TEST(Split, ComparesTheChordWithTheBendingRadius) {
  SplitRule rule;
  const auto verdict = [&](double radius) {
    rule.bending_radius = radius;
    return split_along(k_square, {0.3, 0}, k_pi / 2, rule).verdict;
  };
  EXPECT_EQ(verdict(1.01), SplitVerdict::below_bending);
  EXPECT_EQ(verdict(0.99), SplitVerdict::splits);
  EXPECT_EQ(verdict(0.41), SplitVerdict::splits);
  EXPECT_EQ(verdict(0.39), SplitVerdict::above_reach);  // 2.5 x 0.39 < 1
  EXPECT_EQ(split_along(k_square, {0.3, 0}, -k_pi / 2, rule).verdict, SplitVerdict::no_chord);
}

TEST(Split, RefusesSmallAndNarrowPieces) {
  SplitRule rule;
  rule.bending_radius = 0.9;
  EXPECT_EQ(split_along(k_square, {1e-4, 0}, k_pi / 2, rule).verdict, SplitVerdict::too_small);
  EXPECT_EQ(split_along(k_square, {0.12, 0}, k_pi / 2, rule).verdict, SplitVerdict::too_narrow);  // 1 : 0.12
  EXPECT_EQ(split_along(k_square, {0.13, 0}, k_pi / 2, rule).verdict, SplitVerdict::splits);
  EXPECT_NEAR(split_along(k_square, {0.12, 0}, k_pi / 2, rule).chord.length(), 1, 1e-15);
}

WedgeFan three_wedges(double tolerance) { return {{0.5, 0}, k_pi / 2, 3, k_pi / 3, 0.4, tolerance}; }

TEST(WedgeCracks, BreakStraightChordedWedgesFromAnEdge) {
  const auto cracks = wedge_cracks(three_wedges(1));
  ASSERT_EQ(cracks.size(), 5u);
  const CutResult cut = cut_outline(k_square, cracks);
  ASSERT_EQ(cut.pieces.size(), 4u);
  const double wedge = 0.5 * 0.4 * 0.4 * std::sin(k_pi / 3);
  int wedges = 0;
  for (const CutPiece& piece : cut.pieces)
    wedges += std::abs(geometry::polygon_moments(piece.outline).area - wedge) < 1e-15;
  EXPECT_EQ(wedges, 3);
  // two radial cracks inside, the outer two lie along the edge
  EXPECT_NEAR(cut.crack_length, 2 * 0.4 + 3 * 0.4, 1e-14);
}

TEST(WedgeCracks, KeepToTheArcWithinTheTolerance) {
  for (const double tolerance : {1e-2, 1e-4}) {
    const auto arc = wedge_cracks(three_wedges(tolerance)).back();
    double worst = 0;
    for (std::size_t i = 1; i < arc.size(); ++i)
      worst = std::max(worst, 0.4 - (0.5 * (arc[i - 1] + arc[i]) - Vec2(0.5, 0)).norm());
    EXPECT_LE(worst, tolerance);
    EXPECT_GT(worst, tolerance / 8) << "no finer than asked for, but for whole numbers of chords";
    const CutResult cut = cut_outline(k_square, wedge_cracks(three_wedges(tolerance)));
    ASSERT_EQ(cut.pieces.size(), 4u);
    double broken = 0;
    for (const CutPiece& piece : cut.pieces)
      if (const double area = geometry::polygon_moments(piece.outline).area; area < 0.2) broken += area;
    // every chord leaves a segment of at most 2/3 chord times sagitta; the arc is 0.4 pi long
    EXPECT_NEAR(broken, 0.5 * k_pi * 0.16, 2.0 / 3 * 0.4 * k_pi * tolerance);
  }
}

TEST(WedgeCracks, AreClippedByAFloeSmallerThanTheirRadius) {
  WedgeFan fan = three_wedges(0.01);
  fan.radius = 5;
  const CutResult cut = cut_outline(k_square, wedge_cracks(fan));
  ASSERT_EQ(cut.pieces.size(), 3u) << "radial cracks only";
  EXPECT_LE(area_error(k_square, cut.pieces), 1e-15);
}

TEST(WedgeCracks, SpanTheIceAtAnEdgeAndAtCorners) {
  const WedgeFan edge = fan_across(k_square, {0.4, -0.1}, 1.0, 0.2, 0.01);
  EXPECT_EQ(edge.apex, Vec2(0.4, 0));
  EXPECT_EQ(edge.wedges, 3);
  EXPECT_NEAR(edge.wedge_angle, k_pi / 3, 1e-15);
  EXPECT_NEAR(edge.direction, k_pi / 2, 1e-15);
  const WedgeFan corner = fan_across(k_square, {-1, -1}, 1.0, 0.2, 0.01);
  EXPECT_EQ(corner.wedges, 2);
  EXPECT_NEAR(corner.wedge_angle, k_pi / 4, 1e-15);
  EXPECT_NEAR(corner.direction, k_pi / 4, 1e-15);
  const WedgeFan reflex = fan_across(k_u_shape, {1.1, 1}, 1.0, 0.2, 0.01);
  EXPECT_NEAR(reflex.wedges * reflex.wedge_angle, k_pi, 1e-15);
  const WedgeFan notch = fan_across({{-1, -1}, {1, -1}, {1, 1}, {0, 0}, {-1, 1}}, {0, -0.1}, 1.0, 0.2, 0.01);
  EXPECT_NEAR(notch.wedges * notch.wedge_angle, 1.5 * k_pi, 1e-14);
}

TEST(WedgeCracks, ThatTouchTheEdgeAtTheirTipOnlyAreRefused) {
  const WedgeFan narrow{{0.5, 0}, k_pi / 2, 1, 1.0, 0.4, 0.01};
  EXPECT_EQ(cut_outline(k_square, wedge_cracks(narrow)).status, CutStatus::pinched);
}

TEST(WedgeCracks, BreakFromARandomEdgePoint) {
  RandomStream random(13, "wedges");
  int pieces = 0;
  for (int i = 0; i < 300; ++i) {
    const Outline outline = sound_outline(any_shape, 1, Vec2::Zero(), random);
    const Vec2 near = at_angle(random.uniform(0.5, 2), random.uniform(0, 2 * k_pi));
    const WedgeFan fan = fan_across(outline, near, random.uniform(0.3, 2), random.uniform(0.02, 0.5), 0.01);
    const CutResult cut = cut_outline(outline, to_free_edges(outline, fan, wedge_cracks(fan)));
    ASSERT_FALSE(cut.pieces.empty()) << i << cut.message;
    EXPECT_LE(area_error(outline, cut.pieces), 1e-12 * geometry::polygon_moments(outline).area);
    pieces += static_cast<int>(cut.pieces.size());
  }
  EXPECT_GT(pieces, 600);
}

/// Whether piece k can move in some direction without pressing on any other.
bool can_leave(const std::vector<CutPiece>& pieces, std::size_t k) {
  constexpr double k_way = 1e-3;
  constexpr int k_directions = 360;
  const auto blocked = [&](const Vec2& way) {
    for (std::size_t other = 0; other < pieces.size(); ++other) {
      if (other == k) continue;
      for (const Outline& fixed : geometry::convex_pieces(pieces[other].outline))
        for (Outline moved : geometry::convex_pieces(pieces[k].outline)) {
          for (Vec2& p : moved) p += way;
          if (geometry::convex_overlap(moved, fixed) > 1e-3 * k_way) return true;
        }
    }
    return false;
  };
  for (int i = 0; i < k_directions; ++i)
    if (!blocked(k_way * at_angle(1, 2 * k_pi * i / k_directions))) return true;
  return false;
}

int number_that_can_leave(const std::vector<CutPiece>& pieces) {
  int number = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) number += can_leave(pieces, k) ? 1 : 0;
  return number;
}

/// The base of a notch that is shorter than two radii: both sides of the fan run into the limbs. The crack needs one
/// chord more on either side.
TEST(WedgeCracks, GoOnToTheFreeEdgesOfANotch) {
  const WedgeFan fan = fan_across(k_u_shape, {1, 1.5}, k_pi / 4, 0.6, 0.6);
  ASSERT_EQ(fan.wedges, 4);
  const CutResult ends_at_sides = cut_outline(k_u_shape, wedge_cracks(fan));
  const CutResult ends_at_edges = cut_outline(k_u_shape, to_free_edges(k_u_shape, fan, wedge_cracks(fan)));
  ASSERT_EQ(ends_at_sides.pieces.size(), 5u);
  ASSERT_EQ(ends_at_edges.pieces.size(), 5u);
  EXPECT_EQ(number_that_can_leave(ends_at_sides.pieces), 0) << "the outermost wedges have the limbs on their backs";
  EXPECT_EQ(number_that_can_leave(ends_at_edges.pieces), 2) << "the outermost wedges slide off along their far faces";
  EXPECT_LE(area_error(k_u_shape, ends_at_edges.pieces), 1e-14);
}

TEST(WedgeCracks, StayAsTheyAreWhereNoIceIsBeyondTheSides) {
  for (const Vec2& near : {Vec2(0.5, 0), Vec2(0, 0)}) {
    const WedgeFan fan = fan_across(k_square, near, k_pi / 4, 0.4, 0.4);
    EXPECT_EQ(to_free_edges(k_square, fan, wedge_cracks(fan)), wedge_cracks(fan));
  }
}

/// Within a quarter of a turn, the crack meets even a narrow slit. The two radial cracks along the slit's base go.
TEST(WedgeCracks, MeetANarrowSlit) {
  const Outline slit{{-4, -4}, {4, -4}, {4, 4}, {0.1, 4}, {0.1, 0}, {-0.1, 0}, {-0.1, 4}, {-4, 4}};
  const WedgeFan fan = fan_across(slit, {0, 0}, k_pi / 4, 1, 1);
  EXPECT_EQ(to_free_edges(slit, fan, wedge_cracks(fan)).size(), 4u);
}

TEST(WayOutside, IsThatAcrossANotch) {
  EXPECT_NEAR(way_outside(k_u_shape, {2, 0.5}, {2, 2.5}), 1, 1e-15);
  EXPECT_EQ(way_outside(k_u_shape, {0.5, 0.5}, {0.5, 3}), 0);
  EXPECT_NEAR(way_outside(k_u_shape, {2, -1}, {2, 0.5}), 1, 1e-15) << "from outside";
}

TEST(WayOutside, IsNoneAlongAnEdge) {
  for (const double beside : {0.0, 1e-3, -1e-3, 1e-16}) {
    EXPECT_EQ(way_outside(k_square, {0.2, -beside}, {0.9, -beside}), 0) << beside;
    EXPECT_NEAR(way_outside(k_u_shape, {2, 1 + beside}, {2, 2 - beside}), 1 - 2 * beside, 3e-3) << "from edge to edge";
  }
}

TEST(WedgeCracks, DemandAFanThatMakesSense) {
  WedgeFan none = three_wedges(0.1), round = none, exact = none;
  none.wedges = 0;
  round.wedges = 6;
  exact.arc_tolerance = 0;
  for (const WedgeFan& fan : {none, round, exact}) EXPECT_THROW(wedge_cracks(fan), ContractError);
  EXPECT_THROW(to_free_edges(k_square, three_wedges(0.1), {}), ContractError);
}

}  // namespace crack_lines_test
