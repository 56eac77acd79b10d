#include "hydro/equilibrium.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "hydro/modules.h"
#include "hydro/wetted.h"
#include "tests/hydro/solids.h"
#include "tests/support/random_vectors.h"
#include "tests/support/tetrahedron.h"

namespace nilas::water_test {

namespace equilibrium_test {

hydro::Water sea() {
  hydro::Water water;
  water.level = 1.5;
  return water;
}

/// A box floats at draught d = T rho_b / rho_w: freshwater ice 917 in 1025 at 0.894634 of its thickness.
TEST(FloatingHeight, Box) {
  const double T = 0.8, mass = 917 * 3 * 2 * T;
  const double z = hydro::floating_height(geometry::box_shape({3, 2, T}).surface, Mat3::Identity(), mass, sea());
  EXPECT_NEAR(z, 1.5 + 0.5 * T - T * 917 / 1025, 1e-12);
}

/// A cone-like corner, apex down: V = h^3 times its constant, so h = (m / (rho k))^(1/3).
TEST(FloatingHeight, PyramidApexDown) {
  const geometry::TriangleMesh mesh =
      test::tetrahedron({0, 0, 0}, {1, 0, 1}, {-1, 1, 1}, {-1, -1, 1});  // base area 2 at height 1
  const double mass = 100;
  const double z = hydro::floating_height(mesh, Mat3::Identity(), mass, sea());
  EXPECT_NEAR(1.5 - z, std::cbrt(mass / (1025 * 2.0 / 3)), 1e-12);
}

TEST(FloatingHeight, BalancesEveryMassAndAttitude) {
  for (const Solid& solid : solids()) {
    const double volume = geometry::mesh_properties(solid.mesh, 1).mass;
    // A plate at 1e3 m from its origin has its heights only to 1e-13 m: 1e-11 of its thickness.
    const double balance = solid.name == "thin plate far from its origin" ? 1e-10 : 1e-12;
    RandomStream random(8, solid.name);
    for (int k = 0; k < 30; ++k) {
      const Mat3 R = k == 0 ? Mat3::Identity() : test::random_attitude(random).toRotationMatrix();
      const double mass = 1025 * volume * random.uniform(0.001, 0.999);
      const double z = hydro::floating_height(solid.mesh, R, mass, sea());
      EXPECT_NEAR(1025 * hydro::submerged_mesh(solid.mesh, R, {0, 0, z}, 1.5).volume, mass, balance * mass)
          << solid.name;
    }
  }
}

TEST(FloatingHeight, JustAfloatAndSinking) {
  const geometry::TriangleMesh box = geometry::box_shape({1, 1, 1}).surface;
  EXPECT_NEAR(hydro::floating_height(box, Mat3::Identity(), 1025, sea()), 1.0, 1e-12);
  EXPECT_THROW(hydro::floating_height(box, Mat3::Identity(), 1026, sea()), InputError);
  EXPECT_THROW(hydro::floating_height(box, Mat3::Identity(), 0, sea()), InputError);
  EXPECT_THROW(hydro::floating_height({}, Mat3::Identity(), 1, sea()), InputError);
}

/// A solid of that surface whose centre of mass stands at `com` in the mesh's frame.
geometry::Shape about(geometry::TriangleMesh mesh, const Vec3& com) {
  for (Vec3& x : mesh.vertices) x -= com;
  return geometry::mesh_shape(std::move(mesh), {});
}

Quat tilt(double angle, const Vec3& axis) { return Quat(Eigen::AngleAxisd(angle, axis.normalized())); }

/// Draught m/(rho A), GM = d/2 + b^2/(12 d) - KG across and with the length along, at any heading.
TEST(FloatingEquilibrium, UprightBox) {
  const double l = 4, b = 2, depth = 1, d = 0.6, kg = 0.4, mass = 1025 * l * b * d;
  const geometry::Shape box = about(geometry::box_shape({l, b, depth}).surface, {0, 0, kg - 0.5 * depth});
  for (const double heading : {0.0, 0.7, 2.5}) {
    const auto found = hydro::floating_equilibrium(box, mass, tilt(heading, Vec3::UnitZ()), sea());
    EXPECT_NEAR(found.draught, d, 1e-11);
    EXPECT_NEAR(found.pose.p.z(), 1.5 - d + kg, 1e-11);
    EXPECT_NEAR(found.trim, 0, 1e-11);
    EXPECT_NEAR(found.heel, 0, 1e-11);
    EXPECT_NEAR(found.volume, l * b * d, 1e-10);
    EXPECT_NEAR(found.gm_transverse, d / 2 + b * b / (12 * d) - kg, 1e-10);
    EXPECT_NEAR(found.gm_longitudinal, d / 2 + l * l / (12 * d) - kg, 1e-10);
    EXPECT_NEAR(found.gm_least, found.gm_transverse, 1e-10);
    EXPECT_TRUE(found.stable());
  }
}

/// A wall-sided body inclined by t = tan(angle) rests where its centre of mass is off by t (GM + BM t^2 / 2). This is
/// exact while bottom and deck stay uncut.
TEST(FloatingEquilibrium, OffCentreMassTrimsAndHeelsABoxByTheWallSidedFormula) {
  const double l = 4, b = 2, depth = 1, d = 0.5, kg = 0.6, mass = 1025 * l * b * d;
  for (const double angle : {0.01, 0.1, 0.2, -0.15}) {
    const double t = std::tan(angle);
    const double bm_l = l * l / (12 * d), bm_t = b * b / (12 * d), up = d / 2 - kg;
    const double ahead = t * (up + bm_l + bm_l * t * t / 2), aside = t * (up + bm_t + bm_t * t * t / 2);
    const Vec3 centre(0, 0, kg - 0.5 * depth);
    const geometry::TriangleMesh box = geometry::box_shape({l, b, depth}).surface;
    const auto trimmed =
        hydro::floating_equilibrium(about(box, centre + ahead * Vec3::UnitX()), mass, Quat::Identity(), sea());
    EXPECT_NEAR(trimmed.trim, angle, 1e-10) << "a mass ahead puts the bow down";
    EXPECT_NEAR(trimmed.heel, 0, 1e-10);
    const auto heeled =
        hydro::floating_equilibrium(about(box, centre + aside * Vec3::UnitY()), mass, Quat::Identity(), sea());
    EXPECT_NEAR(heeled.heel, -angle, 1e-10) << "a mass to port puts port down";
    EXPECT_NEAR(heeled.trim, 0, 1e-10);
  }
}

/// GZ = sin(a) (GM + BM tan^2(a) / 2) for a wall-sided hull of any waterplane. A centre of mass off by e heels it to
/// the angle where GZ = e cos(a).
TEST(FloatingEquilibrium, RightingLeverOfAWallSidedHull) {
  std::vector<Vec2> waterline{{-4, -0.8}, {2, -0.9}, {4, 0}, {2, 0.9}, {-4, 0.8}};
  const geometry::PolygonMoments moments = geometry::polygon_moments(waterline);
  for (Vec2& q : waterline) q -= moments.centroid;
  const double thickness = 1.2, d = 0.6, kg = 0.5, bm = moments.yy / d / moments.area;
  const geometry::TriangleMesh hull = geometry::prism_shape(waterline, thickness).surface;
  for (const double e : {0.005, 0.02, 0.04}) {
    const geometry::Shape shape = about(hull, {0, e, kg - 0.5 * thickness});
    const auto found = hydro::floating_equilibrium(shape, 1025 * moments.area * d, tilt(1.0, Vec3::UnitZ()), sea());
    const double a = -found.heel;
    ASSERT_GT(a, 0);
    EXPECT_NEAR(std::sin(a) * (d / 2 + bm - kg + 0.5 * bm * std::pow(std::tan(a), 2)), e * std::cos(a), 1e-10);
  }
}

/// A box of equal width and depth and half the water's density is unstable when upright, where the search starts by
/// symmetry. It is stable on its edge.
TEST(FloatingEquilibrium, ASquareBeamIsUnstableFlatAndStableOnItsEdge) {
  const geometry::Shape beam = about(geometry::box_shape({8, 1, 1}).surface, Vec3::Zero());
  const double mass = 1025 * 8 * 0.5;
  const auto flat = hydro::floating_equilibrium(beam, mass, Quat::Identity(), sea());
  EXPECT_NEAR(flat.heel, 0, 1e-11);
  EXPECT_NEAR(flat.gm_transverse, 0.25 + 1.0 / 6 - 0.5, 1e-10);
  EXPECT_FALSE(flat.stable());
  EXPECT_GT(flat.gm_longitudinal, 0);
  const auto edge = hydro::floating_equilibrium(beam, mass, tilt(0.7, Vec3::UnitX()), sea());
  EXPECT_NEAR(edge.heel, k_pi / 4, 1e-10);
  EXPECT_NEAR(edge.gm_transverse, 2 * std::sqrt(2.0) / 6 - std::sqrt(2.0) / 6, 1e-9);
  EXPECT_TRUE(edge.stable());
}

TEST(FloatingEquilibrium, SphereAndPrismFloe) {
  const double r = 0.5, ball_mass = 1025 * 2.0 / 3 * k_pi * r * r * r;
  const auto half = hydro::floating_equilibrium(geometry::sphere_shape(r), ball_mass, Quat::Identity(), sea());
  EXPECT_NEAR(half.draught, r, 1e-11);
  EXPECT_NEAR(half.gm_transverse, 0, 1e-10) << "a ball's metacentre is its centre";

  const geometry::Shape floe = geometry::prism_shape(concave_outline(), 0.4);
  const double mass = 900 * geometry::mesh_properties(floe.surface, 1).mass;
  const auto level = hydro::floating_equilibrium(floe, mass, tilt(0.1, {1, 2, 0}), sea());
  EXPECT_NEAR(level.draught, 0.4 * 900 / 1025, 1e-10);
  EXPECT_NEAR(level.trim, 0, 1e-10);
  EXPECT_NEAR(level.heel, 0, 1e-10);
}

/// The buoyancy module of the simulation leaves no force and no torque at the equilibrium of any hull.
TEST(FloatingEquilibrium, TheSimulationsBuoyancyBalancesIt) {
  const geometry::TriangleMesh hull = lofted_hull();
  const geometry::MassProperties whole = geometry::mesh_properties(hull, 1);
  const auto buoyancy = hydro::make_buoyancy(sea(), 1);
  for (const Vec3& offset : {Vec3(0, 0, -0.1), Vec3(0.2, 0.01, -0.15), Vec3(-0.3, -0.02, -0.2)}) {
    const geometry::Shape shape = about(hull, whole.com + offset);
    const double mass = 600 * whole.mass;
    const auto found = hydro::floating_equilibrium(shape, mass, tilt(0.4, Vec3::UnitZ()), sea());
    EXPECT_TRUE(found.stable());
    bodies::BodySpec spec;
    spec.name = "hull";
    spec.shape = std::make_shared<const geometry::Shape>(shape);
    spec.mass = mass;
    spec.inertia_B = 600 * whole.inertia;
    spec.pose = found.pose;
    bodies::Bodies bodies;
    bodies.add(spec);
    bodies::Wrenches load(1);
    buoyancy->add_forces(bodies, 0, load);
    const double weight = mass * sea().gravity;
    EXPECT_NEAR(load[0].force.z(), weight, 1e-10 * weight);
    EXPECT_NEAR(load[0].torque.norm(), 0, 1e-9 * weight);
    EXPECT_EQ(found.trim > 0, offset.x() > -0.1) << found.trim;
  }
}

TEST(FloatingEquilibrium, WhatCannotFloatIsRefused) {
  const geometry::Shape box = geometry::box_shape({1, 1, 1});
  EXPECT_THROW(hydro::floating_equilibrium(box, 1026, Quat::Identity(), sea()), InputError);
  EXPECT_THROW(hydro::floating_equilibrium(box, 0, Quat::Identity(), sea()), InputError);
  EXPECT_THROW(hydro::floating_equilibrium(geometry::plane_shape(), 1, Quat::Identity(), sea()), InputError);
  EXPECT_THROW(hydro::floating_equilibrium(geometry::sphere_shape(0.5), 600, Quat::Identity(), sea()), InputError);
}

}  // namespace equilibrium_test

}  // namespace nilas::water_test
