#include "fracture/cut/cut_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/geometry/mass_properties.h"
#include "tests/support/cut_judge.h"

namespace cut_outline_test {

using namespace nilas;
using namespace nilas::fracture;
using namespace nilas::test;

const Outline k_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
/// Opens towards +x.
const Outline k_u_shape{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 3}, {0, 3}};

double area_of(const CutPiece& piece) { return geometry::polygon_moments(piece.outline).area; }

TEST(CutOutline, ALineCutsASquareInTwoAndTellsTheNewEdges) {
  const CutResult cut = cut_outline(k_square, {{{0.25, -1}, {0.25, 2}}});
  ASSERT_EQ(cut.status, CutStatus::cut);
  ASSERT_EQ(cut.pieces.size(), 2u);
  EXPECT_EQ(cut.pieces[0].outline, (Outline{{0, 0}, {0.25, 0}, {0.25, 1}, {0, 1}}));
  EXPECT_EQ(cut.pieces[0].crack, (std::vector<bool>{false, true, false, false}));
  EXPECT_EQ(cut.pieces[1].outline, (Outline{{0.25, 0}, {1, 0}, {1, 1}, {0.25, 1}}));
  EXPECT_EQ(cut.pieces[1].crack, (std::vector<bool>{false, false, false, true}));
  EXPECT_EQ(cut.crack_length, 1);
}

TEST(CutOutline, PiecesShareTheRoundedCrossingBitForBit) {
  const CutResult cut = cut_outline(k_square, {{{0.3, -1}, {0.4, 2}}, {{-1, 0.3}, {2, 0.1}}});
  ASSERT_EQ(cut.pieces.size(), 4u);
  // x = 0.3 + (y + 1) / 30, y = 0.3 - (x + 1) / 15: x = (0.3 + (1.3 - 1 / 15) / 30) / (1 + 1 / 450)
  const double x = (0.3 + (1.3 - 1.0 / 15) / 30) / (1 + 1.0 / 450);
  std::vector<Vec2> inner;
  for (const CutPiece& piece : cut.pieces)
    for (const Vec2& p : piece.outline)
      if (p.x() > 0 && p.x() < 1 && p.y() > 0 && p.y() < 1) inner.push_back(p);
  ASSERT_EQ(inner.size(), 4u);
  for (const Vec2& p : inner) EXPECT_EQ(p, inner[0]);
  EXPECT_NEAR(inner[0].x(), x, 2e-16);
  EXPECT_NEAR(inner[0].y(), 0.3 - (x + 1) / 15, 2e-16);
}

TEST(CutOutline, ALineThroughAConcaveOutlineCutsEveryLimb) {
  const CutResult cut = cut_outline(k_u_shape, {{{2, -1}, {2, 4}}});
  ASSERT_EQ(cut.pieces.size(), 3u);
  EXPECT_EQ(area_of(cut.pieces[0]), 5);  // the web with both stumps holds the outline's first edge
  EXPECT_EQ(area_of(cut.pieces[1]), 1);
  EXPECT_EQ(area_of(cut.pieces[2]), 1);
  EXPECT_EQ(cut.crack_length, 2);
}

TEST(CutOutline, WhatSeparatesNothingIsDropped) {
  const Lines into{{{0.3, -1}, {0.4, 0.5}}}, inside{{{0.2, 0.2}, {0.7, 0.3}, {0.4, 0.8}}};
  const Lines outside{{{2, -1}, {2, 2}}, {{-5, -5}, {5, -6}}}, along{{{-1, 0}, {0.5, 0}}}, touching{{{-1, 1}, {1, -1}}};
  for (const Lines& cracks : {into, inside, outside, along, touching, Lines{}, Lines{{}}, Lines{{{0.5, 0.5}}}}) {
    const CutResult cut = cut_outline(k_square, cracks);
    EXPECT_EQ(cut.status, CutStatus::uncut);
    ASSERT_EQ(cut.pieces.size(), 1u);
    EXPECT_EQ(cut.pieces[0].outline, k_square);
    EXPECT_EQ(cut.crack_length, 0);
  }
  const CutResult cut = cut_outline(k_square, {into[0], inside[0], {{-1, 0.9}, {2, 0.9}}, {{0.6, 0.9}, {0.6, 0.95}}});
  ASSERT_EQ(cut.pieces.size(), 2u);
  EXPECT_EQ(cut.pieces[0].outline.size(), 4u) << "the dead ends left no vertices behind";
  EXPECT_EQ(cut.pieces[1].outline.size(), 4u);
}

TEST(CutOutline, CracksThatMeetInsideCutTogether) {
  const CutResult cut = cut_outline(k_square, {{{0, 0.5}, {0.5, 0.5}}, {{0.5, 0}, {0.5, 0.5}}, {{1, 1}, {0.5, 0.5}}});
  ASSERT_EQ(cut.pieces.size(), 3u);
  EXPECT_EQ(area_of(cut.pieces[0]), 0.25);
  EXPECT_EQ(area_of(cut.pieces[1]) + area_of(cut.pieces[2]), 0.75);
}

TEST(CutOutline, EndsRoundedShortOfTheEdgeStillCut) {
  const Outline skew{{0, 0}, {3, 1}, {2, 3}, {-1, 2}};
  RandomStream random(7, "ends");
  for (int i = 0; i < 200; ++i) {
    const Vec2 a = skew[0] + random.uniform(0.1, 0.9) * (skew[1] - skew[0]);
    const Vec2 b = skew[2] + random.uniform(0.1, 0.9) * (skew[3] - skew[2]);
    const CutResult cut = cut_outline(skew, {{a, b}});
    ASSERT_EQ(cut.pieces.size(), 2u) << i;
    EXPECT_EQ(cut.pieces[0].outline.size(), 4u);
    EXPECT_NEAR(cut.crack_length, (b - a).norm(), 1e-15 * 4);
  }
}

TEST(CutOutline, PiecesThatMeetAtAVertexOnlyAreSeparate) {
  const CutResult cut = cut_outline(k_square, {{{0, 0}, {1, 1}}, {{0, 1}, {1, 0}}});
  ASSERT_EQ(cut.pieces.size(), 4u);
  for (const CutPiece& piece : cut.pieces) EXPECT_EQ(area_of(piece), 0.25);
  // a notch whose tip touches the far side: the outline's limbs are pieces of their own
  const CutResult notch = cut_outline(k_square, {{{0.2, 0}, {0.5, 1}, {0.8, 0}}});
  ASSERT_EQ(notch.pieces.size(), 3u);
  for (const CutPiece& piece : notch.pieces) EXPECT_TRUE(sound(piece.outline));
}

TEST(CutOutline, RefusesWithTheReason) {
  const std::vector<Vec2> ring{{0.3, 0.3}, {0.6, 0.3}, {0.5, 0.5}, {0.3, 0.3}};
  EXPECT_EQ(cut_outline(k_square, {ring}).status, CutStatus::hole);
  EXPECT_EQ(cut_outline(k_square, {ring, {{0, 0}, {0.3, 0.3}}}).status, CutStatus::hole);
  EXPECT_EQ(cut_outline(k_square, {ring, {{0.45, -1}, {0.45, 2}}}).status, CutStatus::cut);
  EXPECT_EQ(cut_outline(k_square, {{{0, 0}, {0.6, 0.3}, {0.5, 0.5}, {0, 0}}}).status, CutStatus::pinched);
  EXPECT_EQ(cut_outline({{0, 0}, {1, 1}, {1, 0}}, {}).status, CutStatus::bad_outline);
  EXPECT_EQ(cut_outline({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}).status, CutStatus::bad_outline);
  EXPECT_EQ(cut_outline({}, {}).status, CutStatus::bad_outline);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(cut_outline({{0, 0}, {1, 0}, {nan, 1}}, {}).status, CutStatus::bad_outline);
  EXPECT_EQ(cut_outline(k_square, {{{0, 0}, {nan, 1}}}).status, CutStatus::bad_crack);
  const CutResult refused = cut_outline(k_square, {ring});
  EXPECT_TRUE(refused.pieces.empty());
  EXPECT_FALSE(refused.message.empty());
}

TEST(CutOutline, WhatIsThinnerThanTheResolutionStaysWithItsNeighbour) {
  for (const double aside : {1e-15, 5e-15}) {
    const CutResult cut = cut_outline(k_square, {{{-1, 0.5}, {2, 0.5}}, {{-1, 0.5 + aside}, {2, 0.5 + aside}}});
    ASSERT_EQ(cut.pieces.size(), 2u) << aside;
    EXPECT_NEAR(area_of(cut.pieces[0]) + area_of(cut.pieces[1]), 1, 1e-15);
  }
  const CutResult thin = cut_outline(k_square, {{{-1, 0.5}, {2, 0.5}}, {{-1, 0.5 + 1e-12}, {2, 0.5 + 1e-12}}});
  EXPECT_EQ(thin.pieces.size(), 3u) << "above the resolution a thin piece is a piece";
  // between a crack and an edge that it runs along, with its ends off the edge by more than the resolution
  const CutResult wedge = cut_outline(k_square, {{{0.1, 0}, {0.5, 2e-14}, {0.9, 0}}});
  EXPECT_EQ(wedge.status, CutStatus::uncut);
  EXPECT_EQ(wedge.slivers, 1);
}

TEST(CutOutline, GivesTheSameBitsAgain) {
  RandomStream random(3, "again");
  for (int i = 0; i < 20; ++i) {
    const CutCase made = cut_case(CutClass::many_lines, random);
    const CutResult first = cut_outline(made.outline, made.cracks);
    const std::vector<std::vector<char>> heap(static_cast<std::size_t>(i + 1), std::vector<char>(977));
    const CutResult second = cut_outline(made.outline, made.cracks);
    ASSERT_EQ(first.pieces.size(), second.pieces.size());
    for (std::size_t k = 0; k < first.pieces.size(); ++k) EXPECT_EQ(first.pieces[k].outline, second.pieces[k].outline);
  }
}

TEST(CutOutline, PiecesFollowTheOutlineFromItsFirstEdge) {
  // Two lines in each direction cut a square: nine pieces, and the middle one without an edge of the outline comes
  // last.
  const Lines grid{{{-1, 0.3}, {2, 0.3}}, {{-1, 0.6}, {2, 0.6}}, {{0.3, -1}, {0.3, 2}}, {{0.6, -1}, {0.6, 2}}};
  const CutResult cut = cut_outline(k_square, grid);
  ASSERT_EQ(cut.pieces.size(), 9u);
  EXPECT_EQ(cut.pieces[0].outline[0], Vec2(0, 0));
  EXPECT_EQ(cut.pieces[1].outline[0], Vec2(0.3, 0));
  EXPECT_EQ(cut.pieces[2].outline[0], Vec2(0.6, 0));
  EXPECT_EQ(cut.pieces[8].outline, (Outline{{0.3, 0.3}, {0.6, 0.3}, {0.6, 0.6}, {0.3, 0.6}}));
}

}  // namespace cut_outline_test
