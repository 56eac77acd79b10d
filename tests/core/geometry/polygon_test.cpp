#include "core/geometry/polygon.h"

#include <gtest/gtest.h>

#include "core/geometry/mass_properties.h"
#include "core/geometry/orientation.h"
#include "tests/core/bodies/solids.h"

namespace nilas::geometry {
namespace polygon_test {

const std::vector<Vec2> k_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

std::vector<Vec2> turned(std::vector<Vec2> outline, double angle, const Vec2& shift) {
  const Eigen::Rotation2Dd R(angle);
  for (auto& p : outline) p = R * p + shift;
  return outline;
}

/// Points (0.5 + i u, 0.5 + j u), u = 2^-53, against the line y = x through (12, 12) and (24, 24): the rounded cross
/// product has the wrong sign or is zero at many of them (Kettner et al. 2008).
TEST(Orientation, IsExactNearTheLine) {
  const double u = 0x1.0p-53;
  int rounded_wrong = 0;
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      const Vec2 p(0.5 + i * u, 0.5 + j * u), q(12, 12), r(24, 24);
      const int left_of_diagonal = (p.y() > p.x()) - (p.y() < p.x());
      EXPECT_EQ(orientation(q, r, p), left_of_diagonal);
      const double rounded = (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
      rounded_wrong += (rounded > 0) - (rounded < 0) != left_of_diagonal;
    }
  EXPECT_GT(rounded_wrong, 100);  // else the case would show nothing
}

TEST(IsSimple, PlainOutlines) {
  EXPECT_TRUE(is_simple(k_square));
  EXPECT_TRUE(is_simple(bodies::l_outline()));
  EXPECT_TRUE(is_simple({{0, 0}, {0.5, 0}, {1, 0}, {1, 1}}));  // a straight vertex
  auto clockwise = bodies::l_outline();
  std::reverse(clockwise.begin(), clockwise.end());
  EXPECT_TRUE(is_simple(clockwise));
  EXPECT_TRUE(is_simple({{0, 0}, {1, 0}, {1, 1e-9}, {0, 1}}));                   // a nanometre's edge on a metre's floe
  EXPECT_TRUE(is_simple({{0, 0}, {1e4, 0}, {1e4, 1e-9}, {0, 1e4}}));             // and on a ten kilometre sheet
  EXPECT_TRUE(is_simple({{1, 0}, {1 + 1e-9, 0}, {1 + 1e-9, 1e-9}, {1, 1e-9}}));  // a floe of nanometres
}

TEST(IsSimple, CrossingsTouchesAndSpikesAreFound) {
  EXPECT_FALSE(is_simple({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));                                  // bow tie
  EXPECT_FALSE(is_simple({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));                          // vertex on an edge
  EXPECT_FALSE(is_simple({{0, 0}, {1, 0}, {1, 1}, {0, 0}, {-1, 1}, {-1, 0}}));                // vertex met twice
  EXPECT_FALSE(is_simple({{0, 0}, {2, 0}, {2, 1}, {2, -1}, {2, 3}, {0, 3}}));                 // spike
  EXPECT_FALSE(is_simple({{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 0}, {1, 0}, {1, 1}, {0, 1}}));  // edges overlap
  EXPECT_FALSE(is_simple({{0, 0}, {1, 0}, {1, 0}, {0, 1}}));                                  // point repeated
  EXPECT_FALSE(is_simple({{0, 0}, {1, 1}}));
  EXPECT_FALSE(is_simple({{0, 0}, {1, 1}, {2, 2}}));
  EXPECT_FALSE(is_simple({{0, 0}, {1, 0}, {std::nan(""), 1}}));
}

/// Slivers whose rounded area has the wrong sign or none.
TEST(IsClockwise, IsExactOnSlivers) {
  const double u = 0x1.0p-53;
  int rounded_wrong = 0;
  for (int i = 0; i < 16; ++i)
    for (int j = 0; j < 16; ++j) {
      if (i == j) continue;
      const std::vector<Vec2> sliver{{0.5 + i * u, 0.5 + j * u}, {12, 12}, {24, 24}};
      EXPECT_EQ(is_clockwise(sliver), j < i);
      rounded_wrong += (polygon_moments(sliver).area < 0) != (j < i);
    }
  EXPECT_GT(rounded_wrong, 10);
  EXPECT_FALSE(is_clockwise(bodies::l_outline()));
}

TEST(IsConvex, TellsConvexFromConcave) {
  EXPECT_TRUE(is_convex(k_square));
  EXPECT_FALSE(is_convex(bodies::l_outline()));
  EXPECT_FALSE(is_convex(bodies::star_outline(5, 2, 0.7)));
  std::vector<Vec2> pentagram;  // turns left everywhere, but twice around
  for (int i = 0; i < 5; ++i) pentagram.emplace_back(std::cos(4 * k_pi * i / 5), std::sin(4 * k_pi * i / 5));
  EXPECT_FALSE(is_convex(pentagram));
}

/// Straight vertices that turning and shifting round to either side must not make an outline concave.
TEST(IsConvex, RoundedStraightVerticesStayStraight) {
  RandomStream random(11, "turns");
  const std::vector<Vec2> midpoints{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {1.7, 2}, {0, 2}, {0, 0.3}};
  for (int i = 0; i < 200; ++i) {
    const Vec2 shift(random.uniform(-100, 100), random.uniform(-100, 100));
    const auto outline = turned(midpoints, random.uniform(0, 2 * k_pi), shift);
    EXPECT_TRUE(is_convex(outline));
    EXPECT_EQ(corners(outline), (std::vector<int>{0, 3, 5, 7}));
  }
}

TEST(Contains, InsideOutsideAndBoundary) {
  for (const Vec2& inside : {Vec2(0.5, 0.5), Vec2(0.5, 3.9), Vec2(2.9, 0.1), Vec2(0.999, 1.001)})
    EXPECT_TRUE(contains(bodies::l_outline(), inside)) << inside.transpose();
  for (const Vec2& outside : {Vec2(1.001, 1.001), Vec2(2, 2), Vec2(-1, 0), Vec2(-1, 1), Vec2(5, 1), Vec2(-1, 4)})
    EXPECT_FALSE(contains(bodies::l_outline(), outside)) << outside.transpose();
  for (std::size_t i = 0; i < bodies::l_outline().size(); ++i) {
    const Vec2 &a = bodies::l_outline()[i], &b = bodies::l_outline()[(i + 1) % bodies::l_outline().size()];
    for (const double s : {0.0, 0.25, 0.5}) EXPECT_TRUE(contains(bodies::l_outline(), a + s * (b - a)));
  }
}

/// Share of points inside a random star equals its area share (5 standard deviations).
TEST(Contains, CountsTheArea) {
  RandomStream random(5, "points");
  const auto outline = bodies::random_star_polygon(random);
  const int samples = 20000;
  int inside = 0;
  for (int i = 0; i < samples; ++i) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    inside += contains(outline, {x, y});
  }
  const double share = polygon_moments(outline).area / 4;
  EXPECT_NEAR(inside / double{samples}, share, 5 * std::sqrt(share * (1 - share) / samples));
}

TEST(ConvexHull, HoldsAllPointsAndOnlyCorners) {
  RandomStream random(9, "hull");
  std::vector<Vec2> points;
  for (int i = 0; i < 300; ++i) {
    const double x = std::floor(random.uniform(0, 12)), y = std::floor(random.uniform(0, 9));
    points.emplace_back(x, y);
  }
  const auto hull = convex_hull(points);
  EXPECT_TRUE(is_convex(hull));
  EXPECT_GT(polygon_moments(hull).area, 0);
  EXPECT_EQ(corners(hull).size(), hull.size());
  for (const auto& p : points) EXPECT_TRUE(contains(hull, p));
  for (const auto& p : hull) EXPECT_NE(std::find(points.begin(), points.end(), p), points.end());
}

TEST(WidthBehind, IsTheWayToTheOtherSide) {
  for (const double angle : {0.0, 0.3, 2.0}) {
    const std::vector<Vec2> l = turned(bodies::l_outline(), angle, {5, -3});
    const double widths[] = {1, 3, 1, 1, 4, 1};  // of sides 0 to 5, from their middles
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(width_behind(l, i), widths[i], 1e-12) << i << " at " << angle;
  }
  const std::vector<Vec2> wedge{{0, 0}, {10, 0}, {10, 1}};
  EXPECT_NEAR(width_behind(wedge, 0), 0.5, 1e-12);
}

TEST(ConvexHull, OfPointsOnALineIsItsEnds) {
  EXPECT_EQ(convex_hull({{1, 1}, {0, 0}, {3, 3}, {2, 2}, {0, 0}}), (std::vector<Vec2>{{0, 0}, {3, 3}}));
}

TEST(ConvexOverlap, SquaresSideBySide) {
  for (const double x : {-1.25, -1.0, -0.75, 0.75, 1.0, 1.25})
    EXPECT_DOUBLE_EQ(convex_overlap(k_square, turned(k_square, 0, {x, 0.1})), 1 - std::abs(x));
}

TEST(ConvexOverlap, CornerIntoSideWhicheverComesFirst) {
  const double reach = std::sqrt(0.5);
  for (const double gap : {-0.3, 0.2}) {
    // a square on its corner, left of the unit square
    const auto diamond = turned({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}, k_pi / 4, {-reach - gap, 0.5});
    EXPECT_NEAR(convex_overlap(k_square, diamond), -gap, 1e-15);
    EXPECT_NEAR(convex_overlap(diamond, k_square), -gap, 1e-15);
  }
}

TEST(ConvexOverlap, DoesNotDependOnTheFrame) {
  RandomStream random(2, "frames");
  const std::vector<Vec2> triangle{{0.8, 0.2}, {2, 0.1}, {1.5, 1.4}};
  const double overlap = convex_overlap(k_square, triangle);
  EXPECT_GT(overlap, 0);
  for (int i = 0; i < 50; ++i) {
    const double angle = random.uniform(0, 2 * k_pi);
    EXPECT_NEAR(convex_overlap(turned(k_square, angle, {3, -2}), turned(triangle, angle, {3, -2})), overlap, 1e-14);
  }
}

}  // namespace polygon_test
}  // namespace nilas::geometry
