#include "contact/position_correction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/base/random.h"

namespace nilas::contact {
namespace position_correction_test {

constexpr double k_step = 0.01;

/// Cubes of 1 m along x, each penetrating its left neighbour by the depths given; 0 is a fixed wall.
struct Row {
  bodies::Bodies bodies;
  std::vector<detect::ContactPoint> points;
  AssembledContacts contacts;
  CorrectionSettings settings{.h = k_step, .erp = 0.2, .slop = 0.001, .max_speed = 1};

  explicit Row(const std::vector<double>& depths, const std::vector<ArticulatedBlock>& articulated = {}) {
    double x = 0;
    add(x, bodies::Motion::fixed);
    for (std::size_t k = 0; k < depths.size(); ++k) {
      detect::ContactPoint c;
      c.a = static_cast<int>(k);
      c.b = static_cast<int>(k) + 1;
      c.p = Vec3(x + 0.5, 0, 0);
      c.gap = -depths[k];
      c.key = k + 1;
      points.push_back(c);
      x += 1 - depths[k];
      const bool moved = !articulated.empty() && articulated[0].bodies[0].body == c.b;
      add(x, moved ? bodies::Motion::articulated : bodies::Motion::free);
    }
    FrictionTable friction;
    friction.add("*", "*", {0.3, 0.3, 0});
    contacts = assemble(bodies, bodies::Wrenches(bodies.id.size()), points, friction.resolve(bodies.materials),
                        {.h = k_step}, articulated);
    settings.tolerance = 1e-12;
    settings.max_sweeps = 100000;
  }

  void add(double x, bodies::Motion motion) {
    bodies::BodySpec spec;
    spec.shape = std::make_shared<geometry::Shape>();
    spec.motion = motion;
    spec.mass = 10;
    spec.inertia_B = 1.7 * Mat3::Identity();
    spec.pose.p = Vec3(x, 0, 0);
    spec.v = Vec3(-3, 0, 0);
    bodies.add(spec);
  }

  /// Correction speeds along x per body [m/s].
  std::vector<double> speeds(PositionCorrection* result = nullptr) const {
    std::vector<Vec3> v(bodies.id.size(), Vec3::Zero()), w = v;
    const PositionCorrection out = correction_velocities(contacts, points, settings, v, w);
    if (result != nullptr) *result = out;
    std::vector<double> x;
    for (const auto& velocity : v) x.push_back(velocity.x());
    for (const auto& spin : w) EXPECT_LT(spin.norm(), 1e-12);
    return x;
  }
};

TEST(PositionCorrection, RemovesItsShareOfTheDepthBeyondTheSlop) {
  PositionCorrection result;
  const auto v = Row({0.006}).speeds(&result);
  EXPECT_NEAR(v[1], 0.2 * 0.005 / k_step, 1e-12);  // The body's own speed of -3 m/s has no influence.
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.contacts, 1);
}

TEST(PositionCorrection, LeavesPointsThatCrushOut) {
  Row row({0.006, 0.01});
  row.points[0].force_limit = 5;
  PositionCorrection result;
  const auto v = row.speeds(&result);
  EXPECT_EQ(result.contacts, 1);
  // The second pair shares its displacement, and the first may overlap more.
  EXPECT_NEAR(v[2] - v[1], 0.2 * 0.009 / k_step, 1e-12);
  EXPECT_NEAR(v[2] + v[1], 0, 1e-12);
}

TEST(PositionCorrection, IsCappedAtItsLargestSpeed) {
  Row row({0.2});
  EXPECT_NEAR(row.speeds()[1], 1, 1e-12);
}

TEST(PositionCorrection, SaysWhenItsSweepsDidNotDoOrItsInputIsNoNumber) {
  PositionCorrection result;
  Row row({0.006, 0.011, 0.004, 0.02});
  row.settings.max_sweeps = 2;
  row.speeds(&result);
  EXPECT_FALSE(result.converged);
  row.settings.max_sweeps = 1000;
  row.points[1].gap = std::numeric_limits<double>::quiet_NaN();
  std::vector<Vec3> v(row.bodies.id.size(), Vec3::Zero()), w = v;
  EXPECT_FALSE(correction_velocities(row.contacts, row.points, row.settings, v, w).converged);
}

TEST(PositionCorrection, LeavesTheSlopAlone) {
  PositionCorrection result;
  EXPECT_EQ(Row({0.0009, -0.001}).speeds(&result), (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(result.contacts, 0);
}

TEST(PositionCorrection, DoesNotPushIntoTheNeighbour) {
  // Body 2 touches body 1: both move. Body 3 is 0.4 mm away: it is pushed once the gap is used up.
  const auto v = Row({0.006, 0, -0.0004}).speeds();
  EXPECT_NEAR(v[1], 0.1, 1e-11);
  EXPECT_NEAR(v[2], 0.1, 1e-11);
  EXPECT_NEAR(v[3], 0.1 - 0.0004 / k_step, 1e-11);
}

TEST(PositionCorrection, TwoDeepContactsSeparateBoth) {
  const auto v = Row({0.006, 0.011}).speeds();
  EXPECT_NEAR(v[1], 0.1, 1e-11);
  EXPECT_NEAR(v[2], 0.3, 1e-11);
}

/// The order-free method gives the same motion, with bits that do not depend on the contacts' order.
TEST(PositionCorrection, OrderFreeGivesTheSameMotionInAnyOrder) {
  Row row({0.003, 0.02, 0, 0.005, 0.011});
  row.settings.tolerance = 1e-9;
  const auto swept = row.speeds();
  row.settings.order_free = true;
  PositionCorrection result;
  const auto one = row.speeds(&result);
  EXPECT_TRUE(result.converged);
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_NEAR(one[k], swept[k], 1e-7);
  EXPECT_GT(one[2], 0.1);

  std::reverse(row.points.begin(), row.points.end());
  FrictionTable friction;
  friction.add("*", "*", {0.3, 0.3, 0});
  row.contacts = assemble(row.bodies, bodies::Wrenches(row.bodies.id.size()), row.points,
                          friction.resolve(row.bodies.materials), {.h = k_step}, {});
  EXPECT_EQ(row.speeds(), one);
}

/// One cube is pressed from five sides: rounding of the sums over its contacts could show the order.
TEST(PositionCorrection, OrderFreeSumsManyContactsOfOneBody) {
  Row row({});
  row.add(2, bodies::Motion::free);
  RandomStream random(8, "sides");
  for (int k = 0; k < 7; ++k) {
    detect::ContactPoint c;
    c.a = 0;
    c.b = 1;
    c.p = Vec3(2, 0, 0) + 0.5 * Vec3(random.normal(), random.normal(), random.normal());
    c.n = Vec3(1, 0.3 * random.normal(), 0.3 * random.normal()).normalized();
    c.gap = -random.uniform(0.002, 0.02);
    c.key = static_cast<std::uint64_t>(k) + 1;
    row.points.push_back(c);
  }
  row.settings.tolerance = 1e-9;
  row.settings.order_free = true;
  FrictionTable friction;
  friction.add("*", "*", {0.3, 0.3, 0});
  const auto correct = [&] {
    row.contacts = assemble(row.bodies, bodies::Wrenches(row.bodies.id.size()), row.points,
                            friction.resolve(row.bodies.materials), {.h = k_step}, {});
    const PositionCorrection out = position_correction(row.contacts, row.points, row.settings);
    EXPECT_TRUE(out.converged);
    return out.v;
  };
  const VecX first = correct();
  EXPECT_GT(first.norm(), 0.01);
  for (int k = 0; k < 6; ++k) {
    std::rotate(row.points.begin(), row.points.begin() + 1 + k % 3, row.points.end());
    EXPECT_EQ(correct(), first);
  }
  row.points[3].gap = std::numeric_limits<double>::quiet_NaN();
  row.contacts = assemble(row.bodies, bodies::Wrenches(row.bodies.id.size()), row.points,
                          friction.resolve(row.bodies.materials), {.h = k_step}, {});
  EXPECT_FALSE(position_correction(row.contacts, row.points, row.settings).converged);
}

/// A pile of cubes against a wall: the last is forty times as heavy, so that sweeps creep.
TEST(PositionCorrection, NewtonFinishesWhatSweepsLeaveShort) {
  Row row({0.003, 0.02, 0, 0.005, 0.011, 0.004});
  row.bodies.mass.back() *= 40;
  FrictionTable friction;
  friction.add("*", "*", {0.3, 0.3, 0});
  row.contacts = assemble(row.bodies, bodies::Wrenches(row.bodies.id.size()), row.points,
                          friction.resolve(row.bodies.materials), {.h = k_step}, {});
  row.settings.tolerance = 1e-10;
  PositionCorrection result;
  const auto exact = row.speeds(&result);
  ASSERT_TRUE(result.converged);
  EXPECT_EQ(result.finished, 0);
  ASSERT_GT(result.sweeps, 1000);
  row.settings.max_sweeps = 50;
  row.speeds(&result);
  ASSERT_FALSE(result.converged);
  row.settings.finish = true;
  const auto finished = row.speeds(&result);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.finished, 1);
  for (std::size_t k = 0; k < exact.size(); ++k) EXPECT_NEAR(finished[k], exact[k], 1e-8);
}

/// Each of many cubes must leave the one before at its own speed, so that the last one moves at the sum of them all.
TEST(PositionCorrection, LargeGroupsAreFinished) {
  RandomStream random(5, "depths");
  std::vector<double> depths(400);
  for (double& depth : depths) depth = random.uniform(0.002, 0.02);
  Row row(depths);
  row.settings.tolerance = 1e-9;
  row.settings.max_sweeps = 50;
  PositionCorrection result;
  row.speeds(&result);
  ASSERT_FALSE(result.converged);
  row.settings.finish = true;
  const auto speeds = row.speeds(&result);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.finished, 1);
  double sum = 0;
  for (std::size_t k = 0; k < depths.size(); ++k) {
    sum += row.settings.erp * (depths[k] - row.settings.slop) / k_step;
    EXPECT_NEAR(speeds[k + 1], sum, 1e-6 * sum) << k;
  }
}

/// Between two walls that are too near no motion parts the bodies: what the sweeps found stays, and it says so.
TEST(PositionCorrection, OverlapsThatCannotPartKeepTheResultOfTheSweeps) {
  Row row({0.004, 0.004});
  row.bodies.motion[2] = bodies::Motion::fixed;
  FrictionTable friction;
  friction.add("*", "*", {0.3, 0.3, 0});
  row.contacts = assemble(row.bodies, bodies::Wrenches(row.bodies.id.size()), row.points,
                          friction.resolve(row.bodies.materials), {.h = k_step}, {});
  row.settings.tolerance = 1e-6;
  row.settings.max_sweeps = 20;
  PositionCorrection result;
  const auto swept = row.speeds(&result);
  EXPECT_FALSE(result.converged);
  row.settings.finish = true;
  EXPECT_EQ(row.speeds(&result), swept);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.finished, 0);
}

TEST(PositionCorrection, IslandsWithoutDepthStayStill) {
  // No deep contact is in reach of body 2: only the wall's island {1} is corrected.
  Row row({0.006});
  row.add(20, bodies::Motion::free);
  row.add(20.9995, bodies::Motion::free);
  detect::ContactPoint shallow;
  shallow.a = 2;
  shallow.b = 3;
  shallow.p = Vec3(20.5, 0, 0);
  shallow.gap = -0.0005;
  shallow.key = 99;
  row.points.push_back(shallow);
  FrictionTable friction;
  row.contacts =
      assemble(row.bodies, bodies::Wrenches(4), row.points, friction.resolve(row.bodies.materials), {.h = k_step}, {});
  PositionCorrection result;
  const auto v = row.speeds(&result);
  EXPECT_EQ(result.contacts, 1);
  EXPECT_NEAR(v[1], 0.1, 1e-12);
  EXPECT_EQ(v[2], 0);
  EXPECT_EQ(v[3], 0);
}

TEST(PositionCorrection, ArticulatedBodiesStandStill) {
  ArticulatedBlock vessel;
  vessel.bodies.push_back({1, MatX::Zero(6, 1)});
  vessel.bodies[0].jacobian(0, 0) = 1;
  vessel.mass = MatX::Constant(1, 1, 10);
  vessel.f = VecX::Zero(1);
  Row row({0, 0.006}, {vessel});
  PositionCorrection result;
  EXPECT_NEAR(row.speeds(&result)[2], 0.1, 1e-11);
  EXPECT_EQ(result.v[6], 0);
  EXPECT_EQ(result.contacts, 1);  // The vessel's contact with the wall moves no body.
}

TEST(PositionCorrection, DeepOverlapOfTwoImmovableBodiesIsLeftOut) {
  ArticulatedBlock vessel;
  vessel.bodies.push_back({1, MatX(6, 0)});
  Row row({0.05}, {vessel});
  PositionCorrection result;
  row.speeds(&result);
  EXPECT_EQ(result.contacts, 0);
  EXPECT_TRUE(result.converged);
}

}  // namespace position_correction_test
}  // namespace nilas::contact
