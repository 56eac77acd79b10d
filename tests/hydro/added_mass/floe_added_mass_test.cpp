/// Closed forms of the added mass of floes: disc, plate, axes, scale.
#include "hydro/added_mass/floe_added_mass.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/added_mass/added_mass.h"

namespace floe_added_mass_test {

using namespace nilas;
using namespace nilas::hydro;

constexpr double k_density = 1025;

geometry::Shape disc(double radius, double thickness) {
  constexpr int k_corners = 720;
  std::vector<Vec2> outline;
  for (int k = 0; k < k_corners; ++k) {
    const double angle = 2 * k_pi * k / k_corners;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return geometry::prism_shape(outline, thickness);
}

geometry::Shape rectangle(double length, double width, double turn) {
  const Eigen::Rotation2Dd R(turn);
  std::vector<Vec2> outline;
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    outline.push_back(R * Vec2(0.5 * x * length, 0.5 * y * width));
  return geometry::prism_shape(outline, 0.5);
}

/// Half of Lamb's 8/3 rho a^3 and 16/45 rho a^5. The outline of 720 corners has 1e-5 less area than its circle.
TEST(FloeAddedMass, OfADiscIsHalfOfLambs) {
  const Mat6 added = floe_added_mass(FloeAddedMass::automatic, disc(5, 1), 0.9, k_density);
  EXPECT_NEAR(added(2, 2) / (4.0 / 3 * k_density * 125), 1, 1e-4);
  EXPECT_NEAR(added(3, 3) / (8.0 / 45 * k_density * 3125), 1, 1e-4);
  EXPECT_NEAR(added(4, 4), added(3, 3), 1e-9 * added(3, 3));
  EXPECT_EQ(added(5, 5), 0);
  EXPECT_NEAR(added(0, 0), added(1, 1), 1e-9 * added(0, 0));
}

/// A plate of aspect 4 by DNV's table, and the strips of a very long one: pi/8 rho s^2 a metre.
TEST(FloeAddedMass, OfAPlateFollowsTheTable) {
  const Mat6 added = floe_added_mass(FloeAddedMass::automatic, rectangle(8, 2, 0), 0.4, k_density);
  EXPECT_NEAR(added(2, 2), 0.871 * k_pi / 8 * k_density * 4 * 8, 1e-6);
  EXPECT_NEAR(added(3, 3), k_pi / 16 * k_density * 8, 1e-6);
  EXPECT_NEAR(added(4, 4), added(2, 2) * 64 / 12, 1e-6);
  // Along the length, the short faces act: W = 2 m, a/b = 2 d / L = 0.1.
  EXPECT_NEAR(added(0, 0), 2.23 * k_pi / 2 * k_density * 0.16 * 2, 1e-6);
  EXPECT_GT(added(1, 1), 3 * added(0, 0));
  const Mat6 strip = floe_added_mass(FloeAddedMass::plate, rectangle(2000, 2, 0), 0.4, k_density);
  EXPECT_NEAR(strip(2, 2) / (k_pi / 8 * k_density * 4 * 2000), 1, 1e-3);
}

TEST(FloeAddedMass, TurnsWithTheOutline) {
  const Mat6 straight = floe_added_mass(FloeAddedMass::plate, rectangle(8, 2, 0), 0.4, k_density);
  const Mat6 turned = floe_added_mass(FloeAddedMass::plate, rectangle(8, 2, 0.7), 0.4, k_density);
  const Mat3 R = Eigen::AngleAxisd(0.7, Vec3::UnitZ()).toRotationMatrix();
  EXPECT_LT((turned - bodies::turned(straight, R)).norm(), 1e-9 * straight.norm());
  EXPECT_EQ(turned, turned.transpose());
}

/// At the aspect where the form changes, rounding does not choose it: 3 m x 2 m is a disc in any direction.
TEST(FloeAddedMass, OfTheLongestDiscDoesNotTurnIntoAPlate) {
  const Mat6 straight = floe_added_mass(FloeAddedMass::automatic, rectangle(3, 2, 0), 0.4, k_density);
  for (int k = 1; k < 60; ++k) {
    const Mat6 turned = floe_added_mass(FloeAddedMass::automatic, rectangle(3, 2, 0.1 * k), 0.4, k_density);
    EXPECT_LT((turned - straight).norm(), 1e-9 * straight.norm()) << k;
  }
}

TEST(FloeAddedMass, GrowsWithTheCubeOfTheScale) {
  const Mat6 small = floe_added_mass(FloeAddedMass::automatic, rectangle(3, 1, 0), 0.4, k_density);
  std::vector<Vec2> outline;
  for (const Vec2& p : rectangle(3, 1, 0).outline) outline.push_back(2 * p);
  const Mat6 large = floe_added_mass(FloeAddedMass::automatic, geometry::prism_shape(outline, 1), 0.8, k_density);
  EXPECT_NEAR(large(2, 2) / small(2, 2), 8, 1e-12);
  EXPECT_NEAR(large(0, 0) / small(0, 0), 8, 1e-12);
  EXPECT_NEAR(large(4, 4) / small(4, 4), 32, 1e-11);
}

TEST(FloeAddedMass, TablesMeetTheirRowsAndTheirLimits) {
  EXPECT_EQ(plate_coefficient(1), 0.579);
  EXPECT_EQ(plate_coefficient(10), 0.947);
  EXPECT_NEAR(plate_coefficient(1e6), 1, 1e-6);
  EXPECT_EQ(rectangle_coefficient(0.01), 2.23);
  EXPECT_EQ(rectangle_coefficient(1), 1.51);
}

/// The kinetic energy of one motion does not depend on the point of reference.
TEST(AddedMass, MovedToAnotherPointKeepsTheEnergy) {
  Mat6 matrix = Mat6::Zero();
  matrix.diagonal() << 10, 40, 80, 300, 900, 700;
  matrix(1, 5) = matrix(5, 1) = 25;
  const Vec3 arm(1.5, -0.4, 0.7);  // from the new point to the old one
  Vec6 at_new, at_old;
  at_new << 0.3, -0.2, 0.5, 0.1, 0.4, -0.6;
  at_old << at_new.head<3>() + at_new.tail<3>().cross(arm), at_new.tail<3>();
  const Mat6 moved = about_other_point(matrix, arm);
  EXPECT_NEAR(at_new.dot(moved * at_new), at_old.dot(matrix * at_old), 1e-12);
}

}  // namespace floe_added_mass_test
