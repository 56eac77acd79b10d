#include <gtest/gtest.h>

#include <set>

#include "core/base/error.h"
#include "core/geometry/polygon.h"
#include "tests/core/bodies/solids.h"

namespace nilas::geometry {
namespace convex_pieces_test {

/// Convex, counter-clockwise, over the outline's vertices, every outline edge used once, areas adding up.
void expect_partition(const std::vector<Vec2>& outline) {
  const auto pieces = convex_piece_indices(outline);
  const int n = static_cast<int>(outline.size());
  double area = 0;
  std::multiset<std::pair<int, int>> edges;
  for (const auto& piece : pieces) {
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      points.push_back(outline.at(static_cast<std::size_t>(piece[k])));
      edges.emplace(piece[k], piece[(k + 1) % piece.size()]);
    }
    EXPECT_TRUE(is_convex(points));
    EXPECT_GT(polygon_moments(points).area, 0);
    area += polygon_moments(points).area;
  }
  EXPECT_NEAR(area, polygon_moments(outline).area, 1e-14 * n * area);
  for (int i = 0; i < n; ++i) EXPECT_EQ(edges.count({i, (i + 1) % n}), 1u);
  // Every other edge is a cut, which two pieces share in opposite directions.
  for (const auto& [a, b] : edges)
    if (b != (a + 1) % n) {
      EXPECT_EQ(edges.count({b, a}), 1u);
    }
}

TEST(ConvexPieces, AConvexOutlineIsItsOnlyPiece) {
  const std::vector<Vec2> outline{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}};
  ASSERT_EQ(convex_pieces(outline).size(), 1u);
  EXPECT_EQ(convex_pieces(outline)[0], outline);
}

TEST(ConvexPieces, AnLGivesTwo) {
  EXPECT_EQ(convex_pieces(bodies::l_outline()).size(), 2u);
  expect_partition(bodies::l_outline());
}

/// A cut mends two hollows at most, so hollows / 2 + 1 pieces at least; Hertel and Mehlhorn's way gives at most
/// 2 hollows + 1. Cutting every tip off
/// gives arms + 1, so the fewest are no more.
TEST(ConvexPieces, RegularStars) {
  for (const int arms : {3, 4, 5, 9, 12, 13, 40}) {
    const auto outline = bodies::star_outline(arms, 2, 0.7);
    expect_partition(outline);
    const int pieces = static_cast<int>(convex_pieces(outline).size());
    EXPECT_GE(pieces, (arms + 1) / 2 + 1);
    EXPECT_LE(pieces, arms <= 12 ? arms + 1 : 2 * arms + 1);
  }
}

TEST(ConvexPieces, ThousandRandomStars) {
  RandomStream random(2024, "stars");
  for (int i = 0; i < 1000; ++i) expect_partition(bodies::random_star_polygon(random));
}

/// Teeth cut back, as crushed edges leave them; also straight runs and cuts that meet straight vertices.
TEST(ConvexPieces, CombsAndCrosses) {
  std::vector<Vec2> comb{{10, -1}, {10, 1}};
  for (int tooth = 9; tooth >= 0; --tooth) {
    comb.emplace_back(tooth + 0.5, 0);
    comb.emplace_back(tooth, 1);
  }
  comb.emplace_back(0, -1);
  expect_partition(comb);
  const std::vector<Vec2> cross{{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2},
                                {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
  expect_partition(cross);
  EXPECT_EQ(convex_pieces(cross).size(), 3u);
}

/// Straight vertices rounded to the wrong side cost no further piece.
TEST(ConvexPieces, RoundedStraightVerticesAddNoPieces) {
  RandomStream random(4, "straight");
  for (int i = 0; i < 100; ++i) {
    const Eigen::Rotation2Dd R(random.uniform(0, 2 * k_pi));
    std::vector<Vec2> outline;
    for (std::size_t k = 0; k < bodies::l_outline().size(); ++k) {
      const Vec2 &a = bodies::l_outline()[k], &b = bodies::l_outline()[(k + 1) % bodies::l_outline().size()];
      for (const double s : {0.0, 0.3, 0.7}) outline.push_back(R * (a + s * (b - a)) + Vec2(17, -3));
    }
    EXPECT_EQ(convex_pieces(outline).size(), 2u);
    expect_partition(outline);
  }
}

TEST(ConvexPieces, WrongOutlinesAreRefused) {
  EXPECT_THROW(convex_pieces({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), InputError);
  EXPECT_THROW(convex_pieces({{0, 0}, {0, 1}, {1, 1}, {1, 0}}), InputError);
  EXPECT_THROW(convex_pieces({{0, 0}, {1, 0}}), InputError);
  EXPECT_THROW(convex_pieces({{0, 0}, {1, 0}, {std::nan(""), 1}}), InputError);
}

}  // namespace convex_pieces_test
}  // namespace nilas::geometry
