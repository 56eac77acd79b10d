/// Tests of contact patches of two polytopes: corners, local gaps, symmetry, keys.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "contact/detect/detector.h"
#include "tests/contact/detect/bodies_of_tests.h"
#include "tests/support/mirrored.h"

namespace nilas::detect {
namespace manifold_test {

constexpr double k_exact = 1e-14;  // Rounding of coordinates of about 1 m [m].

std::vector<ContactPoint> contacts(const bodies::Bodies& bodies, double margin) {
  return ContactDetector().detect(bodies, margin);
}

bool has_point(const std::vector<ContactPoint>& points, const Vec3& p, double tolerance = k_exact) {
  return std::any_of(points.begin(), points.end(), [&](const auto& c) { return (c.p - p).norm() < tolerance; });
}

std::set<std::uint64_t> keys(const std::vector<ContactPoint>& points) {
  std::set<std::uint64_t> set;
  for (const ContactPoint& p : points) set.insert(p.key);
  return set;
}

TEST(Manifold, StackTouchesAtTheCornersOfTheCommonRectangle) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::box_shape({3, 1, 0.5}), {0, 0, 0});
  add_body(bodies, geometry::box_shape({1, 2, 0.25}), {0.4, 0, 0.5 * 0.75 - 1e-3});
  const auto points = contacts(bodies, 1e-3);
  ASSERT_EQ(points.size(), 4u);
  for (const ContactPoint& c : points) {
    EXPECT_NEAR((c.n - Vec3::UnitZ()).norm(), 0, k_exact);
    EXPECT_NEAR(c.gap, -1e-3, k_exact);
  }
  for (double x : {-0.1, 0.9})
    for (double y : {-0.5, 0.5}) EXPECT_TRUE(has_point(points, {x, y, 0.25 - 0.5e-3})) << x << " " << y;
}

TEST(Manifold, SideBySideTouchesAtTheCornersOfTheCommonSide) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::box_shape({1, 1, 0.2}), {0, 0, 0});
  add_body(bodies, geometry::box_shape({1, 1, 0.2}), {1.002, 0.3, 0.05});
  const auto points = contacts(bodies, 0.01);
  ASSERT_EQ(points.size(), 4u);
  for (double y : {-0.2, 0.5})
    for (double z : {-0.05, 0.1}) EXPECT_TRUE(has_point(points, {0.501, y, z}));
  for (const ContactPoint& c : points) EXPECT_NEAR(c.gap, 0.002, k_exact);
}

TEST(Manifold, TiltedFloeHasItsLocalGaps) {
  const double tilt = 0.01;
  bodies::Bodies bodies;
  add_body(bodies, geometry::box_shape({4, 4, 0.2}), {0, 0, -0.1}, Quat::Identity(), bodies::Motion::fixed);
  add_body(bodies, geometry::box_shape({1, 1, 0.2}), {0, 0, 0.5 * std::sin(tilt) + 0.1 * std::cos(tilt)},
           Quat(Eigen::AngleAxisd(tilt, Vec3::UnitY())));
  const auto points = contacts(bodies, 0.02);
  ASSERT_EQ(points.size(), 4u);
  int low = 0;
  for (const ContactPoint& c : points) {
    const bool is_low = c.gap < 0.5 * std::sin(tilt);
    low += is_low ? 1 : 0;
    EXPECT_NEAR(c.gap, is_low ? 0 : std::sin(tilt), 1e-14);
  }
  EXPECT_EQ(low, 2);
}

TEST(Manifold, PointsBeyondTheMarginAreLeftOut) {
  const double tilt = 0.01;
  bodies::Bodies bodies;
  add_body(bodies, geometry::box_shape({4, 4, 0.2}), {0, 0, -0.1}, Quat::Identity(), bodies::Motion::fixed);
  add_body(bodies, geometry::box_shape({1, 1, 0.2}), {0, 0, 0.5 * std::sin(tilt) + 0.1 * std::cos(tilt)},
           Quat(Eigen::AngleAxisd(tilt, Vec3::UnitY())));
  EXPECT_EQ(contacts(bodies, 0.5 * std::sin(tilt)).size(), 2u);
}

TEST(Manifold, CrossingEdgesTouchAtOnePoint) {
  bodies::Bodies bodies;
  const double half = 0.5 * std::sqrt(2.0);
  add_body(bodies, geometry::box_shape({1, 1, 1}), {0, 0, 0}, Quat(Eigen::AngleAxisd(k_pi / 4, Vec3::UnitX())));
  add_body(bodies, geometry::box_shape({1, 1, 1}), {0.1, -0.2, 2 * half + 2e-3},
           Quat(Eigen::AngleAxisd(k_pi / 4, Vec3::UnitY())));
  for (double lift : {0.0, -4e-3}) {
    bodies.set_pose(1, Vec3(0.1, -0.2, 2 * half + 2e-3 + lift), bodies.q_GB[1]);
    const auto points = contacts(bodies, 3e-3);
    ASSERT_EQ(points.size(), 1u);
    EXPECT_NEAR((points[0].n - Vec3::UnitZ()).norm(), 0, k_exact);
    EXPECT_NEAR(points[0].gap, 2e-3 + lift, 1e-14);
    EXPECT_NEAR((points[0].p - Vec3(0.1, 0, half + 1e-3 + 0.5 * lift)).norm(), 0, 1e-14);
  }
}

TEST(Manifold, CornersTouchAlongTheLineBetweenThem) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::box_shape({1, 1, 1}), {0, 0, 0});
  add_body(bodies, geometry::box_shape({1, 1, 1}), {1.003, 1.004, 1.012});
  const auto points = contacts(bodies, 0.02);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_NEAR(points[0].gap, 0.013, 1e-14);
  EXPECT_NEAR((points[0].n - Vec3(3, 4, 12) / 13).norm(), 0, 1e-13);
  EXPECT_NEAR((points[0].p - Vec3(0.5015, 0.502, 0.506)).norm(), 0, 1e-14);
}

TEST(Manifold, ParallelEdgesTouchAtBothEnds) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::box_shape({1, 1, 1}), {0, 0, 0});
  add_body(bodies, geometry::box_shape({1, 1, 1}), {1.003, 1.004, 0.25});
  const auto points = contacts(bodies, 0.02);
  ASSERT_EQ(points.size(), 2u);
  for (double z : {-0.25, 0.5}) EXPECT_TRUE(has_point(points, {0.5015, 0.502, z}));
  for (const ContactPoint& c : points) EXPECT_NEAR(c.gap, 0.005, 1e-14);
}

TEST(Manifold, CoincidentPlatesPartThroughTheirThickness) {
  bodies::Bodies bodies;
  const geometry::Shape plate = floe_shape(regular_outline(6, 1), 0.01);
  add_body(bodies, plate, {2, 1, 0});
  add_body(bodies, plate, {2, 1, 0});
  const auto points = contacts(bodies, 0);
  ASSERT_EQ(points.size(), 4u);
  for (const ContactPoint& c : points) {
    EXPECT_NEAR(std::abs(c.n.z()), 1, k_exact);
    EXPECT_NEAR(c.gap, -0.01, k_exact);
  }
}

TEST(Manifold, ManyCornersAreReducedToTheLargestQuadrilateral) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::box_shape({4, 4, 0.2}), {0, 0, -0.1}, Quat::Identity(), bodies::Motion::fixed);
  add_body(bodies, floe_shape(regular_outline(12, 1), 0.2), {0, 0, 0.1});
  const auto points = contacts(bodies, 0.01);
  ASSERT_EQ(points.size(), 4u);
  // The largest quadrilateral in a regular dodecagon is a square, whose half is spanned at any of its corners.
  double half = 0;
  for (int i = 1; i < 4; ++i)
    for (int j = 1; j < 4; ++j)
      half = std::max(half, 0.5 * std::abs((points[i].p - points[0].p).cross(points[j].p - points[0].p).z()));
  EXPECT_NEAR(half, 1, 1e-12);
}

/// The mirror image of prisms in the plane y = 0.
bodies::Bodies mirrored_scene(const bodies::Bodies& bodies) {
  bodies::Bodies image;
  for (int b = 0; b < bodies.size(); ++b) {
    const geometry::Shape& shape = *bodies.shape[b];
    add_body(image, geometry::prism_shape(test::mirrored(shape.outline), shape.thickness),
             test::mirrored(bodies.p_GB[b]), test::mirrored(bodies.q_GB[b]));
  }
  return image;
}

double image_error(const std::vector<ContactPoint>& points, const ContactPoint& of) {
  double least = 1;
  for (const ContactPoint& c : points)
    least = std::min(least, std::max({(c.p - test::mirrored(of.p)).norm(), (c.n - test::mirrored(of.n)).norm(),
                                      std::abs(c.gap - of.gap)}));
  return least;
}

/// Tolerance of mirror images [m]. The reversed outline reverses the edges, which magnifies rounding where edges are
/// nearly parallel.
constexpr double k_mirror = 2e-14;

TEST(Manifold, MirroredPairsHaveMirroredPoints) {
  RandomStream random(11, "mirror");
  int points_seen = 0, reduced = 0, exact = 0;
  double worst = 0;
  for (int k = 0; k < 2000; ++k) {
    bodies::Bodies bodies;
    const bool stacked = k % 3 == 0;
    const bool regular = k % 2 == 0;
    for (int b = 0; b < 2; ++b) {
      const auto outline = regular ? regular_outline(4 + k % 5, 1) : random_outline(random, 1);
      const double way = stacked ? 0.2 * random.uniform() : 2 * std::cos(k_pi / (4 + k % 5)) - 1e-3;
      const double angle =
          regular ? 2 * k_pi * static_cast<int>(random.uniform(0, 8)) / (4 + k % 5) : random.uniform(0, 6);
      add_body(bodies, floe_shape(outline, 0.2), Vec3(b * way, stacked ? 0.0 : 0.05 * b, stacked ? 0.2 * b : 0),
               regular ? Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ())) : random_tilt(random, 0.02));
    }
    const auto points = contacts(bodies, 0.005), images = contacts(mirrored_scene(bodies), 0.005);
    ASSERT_EQ(points.size(), images.size()) << k;
    for (const ContactPoint& c : points) {
      const double error = image_error(images, c);
      worst = std::max(worst, error);
      exact += error <= 1e-15 ? 1 : 0;
    }
    points_seen += static_cast<int>(points.size());
    reduced += stacked && points.size() == 4 ? 1 : 0;
  }
  EXPECT_LT(worst, k_mirror);
  EXPECT_GT(exact, points_seen - points_seen / 1000);
  EXPECT_GT(points_seen, 2000);
  EXPECT_GT(reduced, 500);
}

TEST(Manifold, APairThatIsItsOwnImageKeepsASymmetricSet) {
  for (int corners : {5, 6, 7, 8, 9, 12}) {
    bodies::Bodies bodies;
    add_body(bodies, floe_shape(regular_outline(corners, 1), 0.2), {0, 0, 0});
    add_body(bodies, floe_shape(regular_outline(corners, 1), 0.2), {0, 0, 0.2});
    const auto points = contacts(bodies, 0.005);
    ASSERT_EQ(points.size(), 4u) << corners;
    for (const ContactPoint& c : points) EXPECT_LT(image_error(points, c), 1e-13) << corners;
  }
}

TEST(Manifold, KeysAreUniqueAndLastThroughASlowDrift) {
  RandomStream random(3, "drift");
  int same = 0, total = 0;
  for (int k = 0; k < 200; ++k) {
    bodies::Bodies bodies;
    add_body(bodies, floe_shape(random_outline(random, 1), 0.2), {0, 0, 0}, random_tilt(random, 0.01));
    add_body(bodies, floe_shape(random_outline(random, 1), 0.2), {0.2, 0.1, 0.2}, random_tilt(random, 0.01));
    ContactDetector detector;
    auto last = detector.detect(bodies, 0.05);
    ASSERT_FALSE(last.empty());
    for (int step = 0; step < 10; ++step) {
      bodies.set_pose(1, bodies.p_GB[1] + Vec3(1e-6, -2e-6, 1e-7), bodies.q_GB[1]);
      const auto now = detector.detect(bodies, 0.05);
      ASSERT_EQ(keys(now).size(), now.size());
      ++total;
      same += keys(now) == keys(last) ? 1 : 0;
      last = now;
    }
  }
  EXPECT_GE(same, total - total / 100);
}

/// Two square prisms touch edge on edge at angles down to rounding.
TEST(Manifold, EdgesThatAreNearlyParallelTellTheirDistance) {
  const double reach = std::sqrt(0.5);
  const Quat on_edge(Eigen::AngleAxisd(0.25 * k_pi, Vec3::UnitY()));
  for (const double turn : {1e-10, 1e-9, 5e-8, 9e-8, 1.1e-7, 1e-6})
    for (const double gap : {1e-8, -1e-8, -1e-7}) {
      bodies::Bodies bodies;
      add_body(bodies, geometry::box_shape({1, 1, 1}), Vec3::Zero(), on_edge);
      add_body(bodies, geometry::box_shape({1, 1, 1}), {0, 0, 2 * reach + gap},
               Quat(Eigen::AngleAxisd(turn, Vec3::UnitZ())) * on_edge);
      double least = 1;
      for (const ContactPoint& c : ContactDetector().detect(bodies, 1e-3)) least = std::min(least, c.gap);
      // Where the width of the crossing equals the depth of the overlap, a face may have a smaller depth.
      const double deepest = gap > 0 ? gap : 1.001 * gap;
      EXPECT_GT(least, deepest - 1e-9) << turn << " " << gap;
      EXPECT_LT(least, (gap > 0 ? gap : 0.7 * gap) + 1e-9) << turn << " " << gap;
    }
}

}  // namespace manifold_test
}  // namespace nilas::detect
