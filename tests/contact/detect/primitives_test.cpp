/// Planes, spheres and cylinders against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/detect/detector.h"
#include "tests/contact/detect/bodies_of_tests.h"
#include "tests/support/random_vectors.h"

namespace nilas::detect {
namespace primitives_test {

constexpr double k_exact = 1e-14;

std::vector<ContactPoint> contacts(const bodies::Bodies& bodies, double margin) {
  return ContactDetector().detect(bodies, margin);
}

Quat turn(double angle, const Vec3& axis) { return Quat(Eigen::AngleAxisd(angle, axis.normalized())); }

void expect_point(const ContactPoint& c, const Vec3& p, const Vec3& n, double gap, double tolerance = k_exact) {
  EXPECT_NEAR((c.p - p).norm(), 0, tolerance) << c.p.transpose();
  EXPECT_NEAR((c.n - n).norm(), 0, tolerance) << c.n.transpose();
  EXPECT_NEAR(c.gap, gap, tolerance);
}

TEST(Primitives, TwoSpheres) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::sphere_shape(1), {1, 2, 3});
  add_body(bodies, geometry::sphere_shape(2), Vec3(1, 2, 3) + 2.9 * Vec3(2, 3, 6) / 7);
  const auto points = contacts(bodies, 0);
  ASSERT_EQ(points.size(), 1u);
  const Vec3 n = Vec3(2, 3, 6) / 7;
  expect_point(points[0], Vec3(1, 2, 3) + 0.95 * n, n, -0.1);
}

TEST(Primitives, SphereOnATiltedPlaneInEitherOrder) {
  const Quat tilt = turn(0.3, {1, 1, 0});
  const Vec3 up = tilt * Vec3::UnitZ();
  for (bool plane_first : {true, false}) {
    bodies::Bodies bodies;
    if (plane_first) add_body(bodies, geometry::plane_shape(), {0.1, 0.2, 0.3}, tilt, bodies::Motion::fixed);
    add_body(bodies, geometry::sphere_shape(0.5), Vec3(0.1, 0.2, 0.3) + 0.51 * up + tilt * Vec3(3, 4, 0));
    if (!plane_first) add_body(bodies, geometry::plane_shape(), {0.1, 0.2, 0.3}, tilt, bodies::Motion::fixed);
    const auto points = contacts(bodies, 0.02);
    ASSERT_EQ(points.size(), 1u);
    const Vec3 foot = Vec3(0.1, 0.2, 0.3) + tilt * Vec3(3, 4, 0);
    expect_point(points[0], foot + 0.005 * up, plane_first ? up : Vec3(-up), 0.01);
  }
}

TEST(Primitives, SphereOnFaceEdgeCornerAndInsideOfABox) {
  struct Case {
    Vec3 centre, nearest;
  };
  for (const Case& c : {Case{{0.2, -0.1, 1.3}, {0.2, -0.1, 0.5}}, Case{{1.0, 0.3, 0.9}, {0.5, 0.3, 0.5}},
                        Case{{0.8, 0.9, 0.7}, {0.5, 0.5, 0.5}}}) {
    bodies::Bodies bodies;
    add_body(bodies, geometry::box_shape({1, 1, 1}), {0, 0, 0}, Quat::Identity(), bodies::Motion::fixed);
    const double distance = (c.centre - c.nearest).norm();
    add_body(bodies, geometry::sphere_shape(distance + 0.01), c.centre);
    const auto points = contacts(bodies, 0);
    ASSERT_EQ(points.size(), 1u);
    const Vec3 n = (c.centre - c.nearest) / distance;
    expect_point(points[0], c.nearest - 0.005 * n, n, -0.01);
  }
  bodies::Bodies bodies;
  add_body(bodies, geometry::box_shape({1, 1, 1}), {0, 0, 0});
  add_body(bodies, geometry::sphere_shape(0.1), {0.1, 0.2, -0.45});
  const auto points = contacts(bodies, 0);
  ASSERT_EQ(points.size(), 1u);
  expect_point(points[0], {0.1, 0.2, -0.5 + 0.075}, -Vec3::UnitZ(), -0.15);
}

TEST(Primitives, SphereOnACylinder) {
  struct Case {
    Vec3 centre, nearest;
  };
  for (const Case& c : {Case{{0.9, 1.2, 0.3}, {0.6, 0.8, 0.3}}, Case{{0.3, 0.4, 2.5}, {0.3, 0.4, 2}},
                        Case{{1.2, 1.6, 3}, {0.6, 0.8, 2}}}) {
    bodies::Bodies bodies;
    add_body(bodies, geometry::cylinder_shape(1, 4), {0, 0, 0});
    const double distance = (c.centre - c.nearest).norm();
    add_body(bodies, geometry::sphere_shape(distance - 0.02), c.centre);
    const auto points = contacts(bodies, 0.05);
    ASSERT_EQ(points.size(), 1u);
    const Vec3 n = (c.centre - c.nearest) / distance;
    expect_point(points[0], c.nearest + 0.01 * n, n, 0.02);
  }
}

TEST(Primitives, BoxOnAPlane) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::plane_shape(), {0, 0, 0}, Quat::Identity(), bodies::Motion::fixed);
  add_body(bodies, geometry::box_shape({1, 2, 0.4}), {5, 6, 0.199});
  const auto flat = contacts(bodies, 0.01);
  ASSERT_EQ(flat.size(), 4u);
  for (const ContactPoint& c : flat) {
    EXPECT_NEAR(c.gap, -0.001, k_exact);
    EXPECT_NEAR(std::abs(c.p.x() - 5), 0.5, k_exact);
    EXPECT_NEAR(std::abs(c.p.y() - 6), 1, k_exact);
    EXPECT_NEAR(c.p.z(), -0.0005, k_exact);
  }
  bodies.set_pose(1, {5, 6, 0.5 * std::sin(0.1) + 0.2 * std::cos(0.1)}, turn(0.1, Vec3::UnitY()));
  const auto on_edge = contacts(bodies, 0.01);
  ASSERT_EQ(on_edge.size(), 2u);
  for (const ContactPoint& c : on_edge) EXPECT_NEAR(c.gap, 0, k_exact);
}

TEST(Primitives, HexagonOnAPlaneKeepsASymmetricSet) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::plane_shape(), {0, 0, 0}, Quat::Identity(), bodies::Motion::fixed);
  add_body(bodies, floe_shape(regular_outline(6, 1), 0.2), {0, 0, 0.1});
  const auto points = contacts(bodies, 0.01);
  ASSERT_EQ(points.size(), 4u);
  for (const ContactPoint& c : points)
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](const ContactPoint& d) {
      return std::abs(d.p.x() - c.p.x()) < 1e-13 && std::abs(d.p.y() + c.p.y()) < 1e-13;
    }));
}

TEST(Primitives, CylinderStandingLyingAndTiltedOnAPlane) {
  const double r = 0.3, h = 0.5;
  bodies::Bodies bodies;
  add_body(bodies, geometry::plane_shape(), {0, 0, 0}, Quat::Identity(), bodies::Motion::fixed);
  add_body(bodies, geometry::cylinder_shape(r, 2 * h), {0, 0, h - 0.002}, turn(0.4, Vec3::UnitZ()));
  const auto standing = contacts(bodies, 0.01);
  ASSERT_EQ(standing.size(), 4u);
  for (const ContactPoint& c : standing) {
    EXPECT_NEAR(c.gap, -0.002, k_exact);
    EXPECT_NEAR(c.p.head<2>().norm(), r, k_exact);
  }
  bodies.set_pose(1, {0, 0, r + 0.001}, turn(0.4, Vec3::UnitZ()) * turn(k_pi / 2, Vec3::UnitY()));
  const auto lying = contacts(bodies, 0.01);
  ASSERT_EQ(lying.size(), 2u);
  for (const ContactPoint& c : lying) {
    EXPECT_NEAR(c.gap, 0.001, k_exact);
    EXPECT_NEAR(c.p.head<2>().norm(), h, k_exact);
  }
  bodies.set_pose(1, {0, 0, 1}, turn(0.7, Vec3::UnitY()));
  const double lowest = 1 - h * std::cos(0.7) - r * std::sin(0.7);
  const auto tilted = contacts(bodies, lowest + 0.01);
  ASSERT_EQ(tilted.size(), 1u);
  EXPECT_NEAR(tilted[0].gap, lowest, k_exact);
}

TEST(Primitives, UprightCylinderBesideAWallTouchesAlongALine) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::box_shape({1, 4, 0.3}), {0, 0, 0.1}, Quat::Identity(), bodies::Motion::fixed);
  for (double gap : {0.004, -0.004}) {
    bodies::Bodies pair = bodies;
    add_body(pair, geometry::cylinder_shape(0.7, 2), {1.2 + gap, 0.3, 0}, turn(0.4, Vec3::UnitZ()));
    const auto points = contacts(pair, 0.01);
    ASSERT_EQ(points.size(), 2u);
    for (const ContactPoint& c : points) {
      EXPECT_NEAR(c.gap, gap, 1e-13);
      EXPECT_NEAR((c.n - Vec3::UnitX()).norm(), 0, 1e-12);
      EXPECT_NEAR(c.p.x(), 0.5 + 0.5 * gap, 1e-13);
      EXPECT_NEAR(c.p.y(), 0.3, 1e-12);
      EXPECT_NEAR(std::abs(c.p.z() - 0.1), 0.15, 1e-13);
    }
  }
}

TEST(Primitives, UprightCylinderBesideACornerTouchesRadially) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::box_shape({1, 1, 0.4}), {0, 0, 0});
  const Vec3 n = Vec3(3, 4, 0) / 5;
  add_body(bodies, geometry::cylinder_shape(0.7, 2), Vec3(0.5, 0.5, 0) + 0.705 * n);
  const auto points = contacts(bodies, 0.01);
  ASSERT_EQ(points.size(), 2u);
  for (const ContactPoint& c : points) {
    EXPECT_NEAR(c.gap, 0.005, 1e-13);
    EXPECT_NEAR((c.n - n).norm(), 0, 1e-12);
    EXPECT_NEAR(std::abs(c.p.z()), 0.2, 1e-13);
  }
}

TEST(Primitives, CylinderStandsOnABox) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::box_shape({2, 2, 1}), {0, 0, -0.5}, Quat::Identity(), bodies::Motion::fixed);
  add_body(bodies, geometry::cylinder_shape(0.4, 1), {0.1, 0.2, 0.499});
  const auto points = contacts(bodies, 0.01);
  ASSERT_EQ(points.size(), 4u);
  for (const ContactPoint& c : points) {
    EXPECT_NEAR(c.gap, -0.001, 1e-13);
    EXPECT_NEAR((c.p - Vec3(0.1, 0.2, -0.0005)).norm(), 0.4, 1e-12);
  }
}

TEST(Primitives, TwoCylinders) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::cylinder_shape(0.5, 2), {0, 0, 0});
  add_body(bodies, geometry::cylinder_shape(0.25, 2), {0.1, 0.74, 0.2}, turn(k_pi / 2, Vec3::UnitY()));
  const auto crossed = contacts(bodies, 0);
  ASSERT_EQ(crossed.size(), 1u);
  expect_point(crossed[0], {0, 0.495, 0.2}, Vec3::UnitY(), -0.01, 1e-12);
  bodies.set_pose(1, 0.76 * Vec3(0.6, 0.8, 0) + Vec3(0, 0, 1), Quat::Identity());
  const auto parallel = contacts(bodies, 0.02);
  ASSERT_EQ(parallel.size(), 1u);
  expect_point(parallel[0], 0.505 * Vec3(0.6, 0.8, 0) + Vec3(0, 0, 0.5), Vec3(0.6, 0.8, 0), 0.01, 1e-12);
  bodies.set_pose(1, {0.1, 0.2, 1.999}, Quat::Identity());
  const auto stacked = contacts(bodies, 0);
  ASSERT_FALSE(stacked.empty());
  for (const ContactPoint& c : stacked) EXPECT_NEAR(c.gap, -0.001, 1e-13);
}

/// All directions normal to the common axis are equally good.
TEST(Primitives, CoaxialCylindersInsideEachOtherOverlapByBothRadii) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::cylinder_shape(0.5, 4), {0, 0, 0});
  add_body(bodies, geometry::cylinder_shape(0.25, 3), {0, 0, 0.1}, turn(0.7, Vec3::UnitZ()));
  const auto points = contacts(bodies, 0);
  ASSERT_FALSE(points.empty());
  for (const ContactPoint& c : points) {
    EXPECT_NEAR(c.gap, -0.75, 1e-13);
    EXPECT_NEAR(c.n.z(), 0, 1e-13);
  }
}

/// The vector from x to the nearest point of a solid cylinder (axis z through the origin).
Vec3 into_cylinder(const Vec3& x, double radius, double half_height) {
  const double r = x.head<2>().norm();
  const double scale = r > radius ? radius / r : 1.0;
  return {scale * x.x(), scale * x.y(), std::clamp(x.z(), -half_height, half_height)};
}

/// Distance of a cylinder and a box by alternating projections, which converge for convex bodies [von Neumann 1933].
double distance_by_projections(const Vec3& size, const Pose& cylinder, double radius, double half_height) {
  Vec3 in_box = Vec3::Zero(), in_cylinder = cylinder.p;
  for (int k = 0; k < 20000; ++k) {
    in_box = in_cylinder.cwiseMax(-0.5 * size).cwiseMin(0.5 * size);
    const Vec3 local = cylinder.q.conjugate() * (in_box - cylinder.p);
    in_cylinder = cylinder.q * into_cylinder(local, radius, half_height) + cylinder.p;
  }
  return (in_box - in_cylinder).norm();
}

TEST(Primitives, CylinderAndBoxAtAnyAttitudeHaveTheTrueDistance) {
  RandomStream random(5, "cylinder");
  double worst = 0;
  int compared = 0;
  for (int k = 0; k < 300; ++k) {
    const Vec3 size(1, 1.5, 0.4);
    const Pose pose{test::random_attitude(random),
                    1.1 * Vec3(random.normal(), random.normal(), random.normal()).normalized()};
    const double truth = distance_by_projections(size, pose, 0.3, 0.4);
    if (truth < 1e-3) continue;
    bodies::Bodies bodies;
    add_body(bodies, geometry::box_shape(size), {0, 0, 0});
    add_body(bodies, geometry::cylinder_shape(0.3, 0.8), pose.p, pose.q);
    const auto points = contacts(bodies, 3);
    ASSERT_FALSE(points.empty());
    double gap = 3;
    for (const ContactPoint& c : points) gap = std::min(gap, c.gap);
    worst = std::max(worst, std::abs(gap - truth));
    ++compared;
  }
  EXPECT_GT(compared, 200);
  EXPECT_LT(worst, 1e-6);
}

}  // namespace primitives_test
}  // namespace nilas::detect
