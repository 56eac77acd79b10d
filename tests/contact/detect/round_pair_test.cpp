/// Points of round parts after a motion, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "contact/detect/detector.h"
#include "contact/step_motion.h"
#include "tests/contact/detect/bodies_of_tests.h"

namespace nilas::detect {
namespace round_pair_test {

constexpr double k_exact = 1e-13, k_margin = 0.01;

Quat turn(double angle, const Vec3& axis) { return Quat(Eigen::AngleAxisd(angle, axis.normalized())); }

/// Two bodies whose contacts are found, carried along with a motion, and measured anew.
struct Pair {
  bodies::Bodies bodies;
  ContactDetector detector;
  contact::StepMotion motion;

  void find() {
    motion.p = bodies.p_GB;
    motion.R = bodies.R_GB;
    motion.points = detector.detect(bodies, k_margin);
  }
  void move(int body, const Vec3& way, const Quat& turned) {
    bodies.set_pose(body, bodies.p_GB[body] + way, turned * bodies.q_GB[body]);
  }
  std::vector<ContactPoint> carried() const { return contact::carried_points(motion, bodies); }
  std::vector<ContactPoint> measured() {
    std::vector<ContactPoint> points = carried();
    detector.measure_round(bodies, points);
    return points;
  }
};

/// A ball and something fixed. Returns its one point after the ball has moved and turned.
ContactPoint after_motion(const geometry::Shape& fixed, double radius, const Vec3& centre, const Vec3& way) {
  Pair pair;
  add_body(pair.bodies, fixed, {0, 0, 0}, Quat::Identity(), bodies::Motion::fixed);
  add_body(pair.bodies, geometry::sphere_shape(radius), centre);
  pair.find();
  pair.move(1, way, turn(0.1, {1, 0.3, -0.4}));
  EXPECT_EQ(pair.motion.points.size(), 1u);
  return pair.measured().front();
}

TEST(RoundPair, ABallTouchesAPlaneBelowItsCentreHoweverItTurns) {
  const ContactPoint c = after_motion(geometry::plane_shape(), 0.2, {0, 0, 0.2}, {0.02, 0.01, 0});
  EXPECT_NEAR(c.gap, 0, k_exact);
  EXPECT_NEAR((c.p - Vec3(0.02, 0.01, 0)).norm(), 0, k_exact);
  EXPECT_EQ(c.n, Vec3::UnitZ());
}

TEST(RoundPair, ABallIsAsFarAsItsCentreFromFaceEdgeAndCornerOfABox) {
  const geometry::Shape box = geometry::box_shape({1, 1, 1});
  EXPECT_NEAR(after_motion(box, 0.2, {0.1, 0.2, 0.7}, {0.01, 0, 0.001}).gap, 0.001, k_exact);
  const Vec3 edge(0.6, 0.1, 0.6), way(0.01, 0.02, -0.012);
  const double from_edge = std::hypot(edge.x() + way.x() - 0.5, edge.z() + way.z() - 0.5);
  EXPECT_NEAR(after_motion(box, 0.14, edge, way).gap, from_edge - 0.14, k_exact);
  const Vec3 corner(0.6, 0.6, 0.6);
  const double from_corner = (corner + way - Vec3(0.5, 0.5, 0.5)).norm();
  EXPECT_NEAR(after_motion(box, 0.17, corner, way).gap, from_corner - 0.17, k_exact);
}

/// A ball that rolls off a face onto its edge has left the face's plane as the nearest feature.
TEST(RoundPair, ABallThatLeavesAFaceIsMeasuredFromItsEdge) {
  const geometry::Shape box = geometry::box_shape({1, 1, 1});
  const ContactPoint c = after_motion(box, 0.2, {0.49, 0, 0.7}, {0.03, 0, 0});
  EXPECT_NEAR(c.gap, std::hypot(0.02, 0.2) - 0.2, k_exact);
}

TEST(RoundPair, TwoBallsAreAsFarAsTheirCentres) {
  Pair pair;
  add_body(pair.bodies, geometry::sphere_shape(0.3), {0, 0, 0});
  add_body(pair.bodies, geometry::sphere_shape(0.2), {0, 0, 0.5});
  pair.find();
  pair.move(0, {-0.02, 0, 0}, turn(-0.1, Vec3::UnitX()));
  pair.move(1, {0.01, 0.02, 0}, turn(0.2, {1, 1, 0}));
  const Vec3 between(0.03, 0.02, 0.5);
  const ContactPoint c = pair.measured().front();
  EXPECT_NEAR(c.gap, between.norm() - 0.5, k_exact);
  EXPECT_NEAR((c.n - between.normalized()).norm(), 0, k_exact);
}

/// A disc that leans on its rim and whose axis turns about the vertical stays as high as it was.
TEST(RoundPair, ALeaningDiscTouchesBelowItsAxisHoweverItTurns) {
  constexpr double k_radius = 0.2, k_half = 0.01, k_lean = 0.4;
  for (const double spin : {0.0, 0.15}) {
    Pair pair;
    add_body(pair.bodies, geometry::plane_shape(), {0, 0, 0}, Quat::Identity(), bodies::Motion::fixed);
    const double height = k_radius * std::sin(k_lean) + k_half * std::cos(k_lean);
    add_body(pair.bodies, geometry::cylinder_shape(k_radius, 2 * k_half), {0, 0, height}, turn(k_lean, Vec3::UnitX()));
    pair.find();
    ASSERT_EQ(pair.motion.points.size(), 1u);
    pair.move(1, {0.001, 0, 0}, turn(0.05, Vec3::UnitZ()) * turn(spin, pair.bodies.R_GB[1].col(2)));
    EXPECT_NEAR(pair.measured().front().gap, 0, k_exact);
    EXPECT_EQ(std::abs(pair.carried().front().gap) > 1e-5, spin > 0);
  }
}

/// A cylinder on its side that turns about its axis: both points stay below the axis, on a plane and on a box.
TEST(RoundPair, ARollerTouchesBelowItsAxis) {
  for (const bool on_plane : {true, false}) {
    Pair pair;
    if (on_plane)
      add_body(pair.bodies, geometry::plane_shape(), {0, 0, 0}, Quat::Identity(), bodies::Motion::fixed);
    else
      add_body(pair.bodies, geometry::box_shape({4, 4, 1}), {0, 0, -0.5}, Quat::Identity(), bodies::Motion::fixed);
    add_body(pair.bodies, geometry::cylinder_shape(0.2, 1), {0, 0, 0.2}, turn(k_pi / 2, Vec3::UnitY()));
    pair.find();
    ASSERT_EQ(pair.motion.points.size(), 2u);
    pair.move(1, {0, 0.01, 0}, turn(0.1, Vec3::UnitX()));
    for (const ContactPoint& c : pair.measured()) {
      EXPECT_NEAR(c.gap, 0, k_exact);
      EXPECT_NEAR(std::abs(c.p.x()), 0.5, 1e-9);
      EXPECT_NEAR(c.p.y(), 0.01, 1e-9);
    }
  }
}

/// A cylinder that rocks from one side of its rim to the other: each point keeps its own side.
TEST(RoundPair, ARockingCylinderKeepsItsPointsApart) {
  constexpr double k_radius = 0.2, k_half = 0.3, k_lean = 1e-3;
  Pair pair;
  add_body(pair.bodies, geometry::plane_shape(), {0, 0, 0}, Quat::Identity(), bodies::Motion::fixed);
  add_body(pair.bodies, geometry::cylinder_shape(k_radius, 2 * k_half), {0, 0, k_half}, turn(k_lean, Vec3::UnitY()));
  pair.find();
  ASSERT_GE(pair.motion.points.size(), 4u);
  pair.move(1, {0, 0, 0}, turn(-2 * k_lean, Vec3::UnitY()));
  const std::vector<ContactPoint> measured = pair.measured();
  for (std::size_t i = 0; i < measured.size(); ++i) {
    EXPECT_LE((measured[i].p - pair.motion.points[i].p).norm(), 0.01);
    const double side = k_half - k_half * std::cos(k_lean) + std::sin(k_lean) * pair.motion.points[i].p.x();
    EXPECT_NEAR(measured[i].gap, side, 1e-6);
  }
}

/// Points of bodies with plane faces stay as the bodies carry them, and so do points where ice crushes.
TEST(RoundPair, OtherPointsStayAsTheyAre) {
  Pair boxes;
  add_body(boxes.bodies, geometry::box_shape({1, 1, 1}), {0, 0, 0});
  add_body(boxes.bodies, geometry::box_shape({1, 1, 1}), {0.1, 0, 1});
  boxes.find();
  boxes.move(1, {0.01, 0, 0}, turn(0.01, {1, 2, 3}));
  const std::vector<ContactPoint> carried = boxes.carried(), measured = boxes.measured();
  ASSERT_EQ(measured.size(), 4u);
  for (std::size_t i = 0; i < measured.size(); ++i) {
    EXPECT_EQ(measured[i].gap, carried[i].gap);
    EXPECT_EQ(measured[i].p, carried[i].p);
  }

  Pair ball;
  add_body(ball.bodies, geometry::plane_shape(), {0, 0, 0}, Quat::Identity(), bodies::Motion::fixed);
  add_body(ball.bodies, geometry::sphere_shape(0.2), {0, 0, 0.2});
  ball.find();
  ball.motion.points[0].force_limit = 100;
  ball.move(1, {0, 0, 0}, turn(0.1, Vec3::UnitX()));
  EXPECT_EQ(ball.measured()[0].gap, ball.carried()[0].gap);
}

}  // namespace round_pair_test
}  // namespace nilas::detect
