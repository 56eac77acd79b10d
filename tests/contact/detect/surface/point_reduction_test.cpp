/// Tests of the choice of four points among many.
#include "contact/detect/surface/point_reduction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace nilas::detect {
namespace point_reduction_test {

constexpr double k_tolerance = 1e-10;

OverlayPoint point(double u, double v, double gap) {
  OverlayPoint p;
  p.u = u;
  p.v = v;
  p.gap = gap;
  return p;
}

bool has(const std::vector<OverlayPoint>& points, double u, double v) {
  return std::any_of(points.begin(), points.end(),
                     [&](const OverlayPoint& p) { return std::abs(p.u - u) + std::abs(p.v - v) < 1e-12; });
}

TEST(PointReduction, UpToFourPointsStayAsTheyAre) {
  std::vector<OverlayPoint> points{point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(0, 1, 0)};
  keep_spread_points(k_tolerance, 1, k_four_points_do, points);
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[2].u, 1);
}

TEST(PointReduction, TheDeepestPointIsKept) {
  std::vector<OverlayPoint> points;
  for (int k = 0; k < 12; ++k) points.push_back(point(std::cos(k_pi * k / 6), std::sin(k_pi * k / 6), 1e-3));
  points.push_back(point(0.2, 0.1, -1e-3));
  keep_spread_points(k_tolerance, 1, k_four_points_do, points);
  EXPECT_EQ(points.size(), 4u);
  EXPECT_TRUE(has(points, 0.2, 0.1));
}

TEST(PointReduction, CornersOfARectangleComeBeforePointsOnItsSides) {
  std::vector<OverlayPoint> points;
  for (double u : {-2.0, -1.0, 0.0, 1.0, 2.0})
    for (double v : {-1.0, 1.0}) points.push_back(point(u, v, 0));
  keep_spread_points(k_tolerance, 1, k_four_points_do, points);
  ASSERT_EQ(points.size(), 4u);
  for (double u : {-2.0, 2.0})
    for (double v : {-1.0, 1.0}) EXPECT_TRUE(has(points, u, v));
}

TEST(PointReduction, BothEndsOfALineAreKept) {
  std::vector<OverlayPoint> points;
  for (int k = 0; k <= 8; ++k) points.push_back(point(0.25 * k, 0, 0));
  keep_spread_points(k_tolerance, 1, k_four_points_do, points);
  EXPECT_EQ(points.size(), 4u);
  EXPECT_TRUE(has(points, 0, 0));
  EXPECT_TRUE(has(points, 2, 0));
}

TEST(PointReduction, BothEndsOfABluntRidgeAreKeptBeforeFarPointsNearTheMargin) {
  std::vector<OverlayPoint> points{point(-1, 0, -1e-4), point(1, 0, 0)};
  for (double u : {-1.0, 1.0})
    for (double v : {-1.0, 1.0}) points.push_back(point(u, v, 4.9e-3));
  keep_spread_points(k_tolerance, 5e-3, k_four_points_do, points);
  EXPECT_TRUE(has(points, -1, 0));
  EXPECT_TRUE(has(points, 1, 0));
}

TEST(PointReduction, ManyPointsOnACircleGiveNearlyASquare) {
  std::vector<OverlayPoint> points;
  for (int k = 0; k < 60; ++k) points.push_back(point(std::cos(k_pi * k / 30), std::sin(k_pi * k / 30), 0));
  keep_spread_points(k_tolerance, 1, k_four_points_do, points);
  ASSERT_EQ(points.size(), 4u);
  double smallest = 4;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      smallest = std::min(smallest, std::hypot(points[i].u - points[j].u, points[i].v - points[j].v));
  EXPECT_GT(smallest, 1.2);
}

TEST(PointReduction, AMirroredSetGivesTheMirroredPoints) {
  for (int corners = 5; corners <= 12; ++corners)
    for (double turn : {0.0, 0.1, 0.37}) {
      std::vector<OverlayPoint> points, images;
      for (int k = 0; k < corners; ++k) {
        const double angle = turn + 2 * k_pi * k / corners;
        points.push_back(point(std::cos(angle), std::sin(angle), 0));
        images.insert(images.begin(), point(std::cos(angle), -std::sin(angle), 0));
      }
      keep_spread_points(k_tolerance, 1, k_four_points_do, points);
      keep_spread_points(k_tolerance, 1, k_four_points_do, images);
      for (const OverlayPoint& p : points) EXPECT_TRUE(has(images, p.u, -p.v)) << corners << " " << turn;
    }
}

TEST(PointReduction, APointThatFourLeaveOpenIsKeptToo) {
  std::vector<OverlayPoint> points;
  for (double u : {-1.0, 1.0})
    for (double v : {-1.0, 1.0}) points.push_back(point(u, v, 0));
  points.push_back(point(0.2, 0.05, -2e-3));  // The deepest point is one of the four.
  points.push_back(point(0.1, 0, 5e-3));      // The others carry this point.
  keep_spread_points(k_tolerance, 1, 1e-3, points);
  EXPECT_EQ(points.size(), 5u);
  EXPECT_FALSE(has(points, 0.1, 0));
}

TEST(PointReduction, ALineOfContactsThatSagsKeepsItsMiddle) {
  std::vector<OverlayPoint> points;
  for (int k = -4; k <= 4; ++k) points.push_back(point(0.25 * k, 0, 0));
  points[4].gap = -1e-3;  // This point is the deepest.
  points[2].gap = -0.9e-3;
  points[6].gap = -0.9e-3;
  keep_spread_points(k_tolerance, 1, 1e-5, points);
  for (double u : {-1.0, -0.5, 0.0, 0.5, 1.0}) EXPECT_TRUE(has(points, u, 0)) << u;
}

TEST(PointReduction, PointsThatTieComeTogetherOrNotAtAll) {
  // Four of twelve points on a circle make a square; the other eight tie and find no place.
  std::vector<OverlayPoint> points;
  for (int k = 0; k < 12; ++k) points.push_back(point(std::cos(k_pi * k / 6), std::sin(k_pi * k / 6), 0));
  keep_spread_points(k_tolerance, 1, 1e-3, points);
  EXPECT_EQ(points.size(), 4u);
}

TEST(PointReduction, APointInTheMiddleOfAllChangesNothing) {
  const std::vector<OverlayPoint> corners{point(1, 0, 0), point(0, 1, 0), point(-1, 0, 0), point(0, -1, 0)};
  for (std::size_t place = 0; place <= corners.size(); ++place) {
    std::vector<OverlayPoint> points = corners;
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(place), point(0, 0, 0.1));
    keep_spread_points(k_tolerance, 1, k_four_points_do, points);
    EXPECT_EQ(points.size(), 4u) << place;
    for (const OverlayPoint& corner : corners) EXPECT_TRUE(has(points, corner.u, corner.v)) << place;
  }
}

}  // namespace point_reduction_test
}  // namespace nilas::detect
