#include "core/field/spec/convex_contact.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/geometry/polygon.h"

namespace nilas::field {
namespace convex_contact_test {

ConvexOutline box(double x0, double y0, double x1, double y1) {
  ConvexOutline outline;
  outline.corners = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  fill_normals(outline);
  return outline;
}

ConvexOutline polygon(const Vec2& centre, int corners, double radius, double turn) {
  ConvexOutline outline;
  for (int k = 0; k < corners; ++k) {
    const double angle = turn + 2 * k_pi * k / corners;
    outline.corners.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  fill_normals(outline);
  return outline;
}

TEST(ConvexContact, BoxesOverlapByTheirSmallerDepth) {
  const auto axis = best_axis(box(0, 0, 2, 1), box(1.9, -3, 4, 5));
  EXPECT_NEAR(axis.gap, -0.1, 1e-15);
}

/// Two boxes side by side: both ends of the shared stretch touch, with the gap between the faces.
TEST(ConvexContact, FacesTouchAtBothEndsOfTheSharedStretch) {
  const auto a = box(0, 0, 1, 1), b = box(1.25, 0.5, 2, 3);
  const auto touching = touching_points(a, b, best_axis(a, b), 1);
  ASSERT_EQ(touching.count, 2);
  EXPECT_EQ(touching.normal, Vec2(1, 0));
  double low = 2, high = 0;
  for (int k = 0; k < 2; ++k) {
    EXPECT_DOUBLE_EQ(touching.gap[k], 0.25);
    low = std::min(low, touching.point[k].y());
    high = std::max(high, touching.point[k].y());
  }
  EXPECT_DOUBLE_EQ(low, 0.5);
  EXPECT_DOUBLE_EQ(high, 1);
}

TEST(ConvexContact, PointsBeyondReachAreLeftOut) {
  const auto a = box(0, 0, 1, 1), b = box(1.25, 0.5, 2, 3);
  EXPECT_EQ(touching_points(a, b, best_axis(a, b), 0.2).count, 0);
}

/// The gap is that of core/bodies' plain search over all normals and corners, for any pair of regular polygons.
TEST(ConvexContact, FollowingTheDeepestCornerFindsWhatASearchFinds) {
  int overlapping = 0;
  RandomStream random(3, "pairs");
  for (int k = 0; k < 2000; ++k) {
    const auto corners = [&] { return 3 + static_cast<int>(random.uniform() * 22); };
    const auto a = polygon({0, 0}, corners(), random.uniform(0.2, 2), random.uniform(0, 6));
    const Vec2 place(random.uniform(-3, 3), random.uniform(-3, 3));
    const auto b = polygon(place, corners(), random.uniform(0.2, 2), random.uniform(0, 6));
    const auto axis = best_axis(a, b);
    EXPECT_NEAR(-axis.gap, geometry::convex_overlap(a.corners, b.corners), 1e-12);
    EXPECT_NEAR(gap_on_axis(a, b, axis.edge, axis.of_first), axis.gap, 1e-15);
    const auto touching = touching_points(a, b, axis, 10);
    ASSERT_GE(touching.count, 1);
    const double least = std::min(touching.gap[0], touching.count > 1 ? touching.gap[1] : 10);
    overlapping += axis.gap < 0;
    if (axis.gap < 0)
      EXPECT_EQ(least, axis.gap);
    else
      EXPECT_GE(least, axis.gap - 1e-12);
  }
  EXPECT_GT(overlapping, 200);
}

}  // namespace convex_contact_test
}  // namespace nilas::field
