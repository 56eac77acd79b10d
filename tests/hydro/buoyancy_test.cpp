#include <gtest/gtest.h>

#include "hydro/modules.h"
#include "hydro/wetted.h"
#include "tests/hydro/solids.h"
#include "tests/support/random_vectors.h"

namespace nilas::water_test {

namespace buoyancy_test {

hydro::Water sea() {
  hydro::Water water;
  water.level = 0.4;
  return water;
}

Wrench buoyancy_on(const bodies::Bodies& bodies, int b) {
  bodies::Wrenches out(static_cast<std::size_t>(bodies.size()));
  hydro::make_buoyancy(sea(), 1)->add_forces(bodies, 0, out);
  return out[b];
}

/// Potential energy after a turn by `turn` (rotation vector) and a shift.
double potential_near(const bodies::Bodies& bodies, const Vec3& shift, const Vec3& turn) {
  bodies::Bodies moved = bodies;
  const double angle = turn.norm();
  const Quat q = angle > 0 ? Quat(Eigen::AngleAxisd(angle, turn / angle)) : Quat::Identity();
  moved.set_pose(0, bodies.p_GB[0] + shift, q * bodies.q_GB[0]);
  return hydro::make_buoyancy(sea(), 1)->potential_energy(moved);
}

/// Force and torque are minus the gradient of the potential, by central differences of 1e-4 m and rad (error of order
/// 1e-8).
TEST(Buoyancy, IsMinusTheGradientOfItsPotential) {
  constexpr double k_step = 1e-4;
  for (const geometry::Shape& shape : shapes()) {
    RandomStream random(9, std::to_string(static_cast<int>(shape.kind)));
    for (int k = 0; k < 30; ++k) {
      bodies::Bodies bodies;
      add_body(bodies, shape, {test::random_attitude(random), Vec3(3, 4, 0.4 + 0.5 * random.uniform(-1, 1))});
      const Wrench wrench = buoyancy_on(bodies, 0);
      const double scale = bodies.mass[0] * sea().gravity;
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3 d = k_step * Vec3::Unit(axis), none = Vec3::Zero();
        const double force = -(potential_near(bodies, d, none) - potential_near(bodies, -d, none)) / (2 * k_step);
        const double torque = -(potential_near(bodies, none, d) - potential_near(bodies, none, -d)) / (2 * k_step);
        EXPECT_NEAR(wrench.force[axis], force, 1e-7 * scale);
        EXPECT_NEAR(wrench.torque[axis], torque, 1e-7 * scale * shape.bounding_radius);
      }
    }
  }
}

/// The force is rho g V, straight up through the centre of buoyancy.
TEST(Buoyancy, ForceAndMomentArm) {
  const geometry::Shape shape = geometry::box_shape({2, 1, 0.5});
  bodies::Bodies bodies;
  const Pose pose{Quat(Eigen::AngleAxisd(1.1, Vec3(1, 2, 2).normalized())), {5, 6, 0.5}};
  add_body(bodies, shape, pose);
  const hydro::Submerged wet = hydro::submerged_mesh(shape.surface, bodies.R_GB[0], pose.p, 0.4);
  const Wrench wrench = buoyancy_on(bodies, 0);
  const Vec3 force(0, 0, 1025 * 9.81 * wet.volume);
  EXPECT_LT((wrench.force - force).norm(), 1e-10 * force.norm());
  EXPECT_LT((wrench.torque - (wet.centre - pose.p).cross(force)).norm(), 1e-10 * force.norm());
}

/// Box L B T at draught d, uniform: KB = d/2, BM = (L B^3/12)/(L B d), KG = T/2.
double metacentric_height(double B, double T, double d) { return 0.5 * d + B * B / (12 * d) - 0.5 * T; }

/// Wall-sided formula: restoring torque = rho g V sin(phi) (GM + BM/2 tan^2(phi)) at unchanged displacement, exact
/// while only the sides are cut; for small angles rho g V GM sin(phi).
TEST(Buoyancy, RightingMomentOfABox) {
  const double L = 3, B = 1.2, T = 0.5, d = 0.35, V = L * B * d;
  const double gm = metacentric_height(B, T, d), bm = B * B / (12 * d);
  const std::vector<Vec2> outline{{-L / 2, -B / 2}, {L / 2, -B / 2}, {L / 2, B / 2}, {-L / 2, B / 2}};
  for (const geometry::Shape& shape : {geometry::box_shape({L, B, T}), geometry::prism_shape(outline, T)})
    for (const double phi : {1e-4, 1e-3, 0.05, 0.1}) {
      bodies::Bodies bodies;
      // The mean wet length of the vertical edges stays d.
      add_body(bodies, shape,
               {Quat(Eigen::AngleAxisd(phi, Vec3::UnitX())), {0, 0, 0.4 + (0.5 * T - d) * std::cos(phi)}});
      const Wrench wrench = buoyancy_on(bodies, 0);
      const double weight = 1025 * 9.81 * V, tangent = std::tan(phi);
      EXPECT_NEAR(wrench.force.z(), weight, 1e-10 * weight);
      const double exact = weight * std::sin(phi) * (gm + 0.5 * bm * tangent * tangent);
      EXPECT_NEAR(-wrench.torque.x(), exact, 1e-10 * weight);
      const double small_angle = weight * gm * std::sin(phi);
      if (phi < 1e-3) {
        EXPECT_NEAR(-wrench.torque.x(), small_angle, 1e-6 * small_angle);
      }
    }
}

/// m z'' = -rho g A_w (z - z0): T = 2 pi sqrt(m / (rho g A_w)). Semi-implicit Euler at 2000 steps per period errs by
/// (2 pi / 2000)^2 / 24 = 4e-7; the period is the mean of five between upward crossings.
TEST(Buoyancy, HeavePeriodOfABox) {
  const double A = 6, thickness = 0.8;
  const hydro::Water water = sea();
  bodies::Bodies bodies;
  add_body(bodies, geometry::box_shape({3, 2, thickness}), {Quat::Identity(), {0, 0, 0}});
  const double m = bodies.mass[0], draught = m / (water.density * A), rest = water.level + 0.5 * thickness - draught;
  const double expected = 2 * k_pi * std::sqrt(m / (water.density * water.gravity * A)), h = expected / 2000;
  bodies.set_pose(0, {0, 0, rest - 0.05}, Quat::Identity());
  const auto module = hydro::make_buoyancy(water, 1);
  std::vector<double> crossings;
  for (int k = 0; crossings.size() < 6 && k < 20000; ++k) {
    bodies::Wrenches out(1);
    module->add_forces(bodies, 0, out);
    bodies.v_GB[0].z() += h * (out[0].force.z() / m - water.gravity);
    const double before = bodies.p_GB[0].z() - rest, after = before + h * bodies.v_GB[0].z();
    bodies.set_pose(0, {0, 0, rest + after}, Quat::Identity());
    if (before < 0 && after >= 0) crossings.push_back(h * (k + before / (before - after)));
  }
  ASSERT_EQ(crossings.size(), 6u);
  EXPECT_NEAR((crossings[5] - crossings[0]) / 5, expected, 1e-4 * expected);
}

/// Buoyancy acts on free floes, rigid bodies and the vessel, but on no wall, fixed body or plane.
TEST(Buoyancy, ActsOnWhatFloatsOnly) {
  const geometry::Shape box = geometry::box_shape({1, 1, 1});
  bodies::Bodies bodies;
  const Pose pose;
  add_body(bodies, box, pose, 900, bodies::BodyKind::rigid, bodies::Motion::free);
  add_body(bodies, box, pose, 900, bodies::BodyKind::floe, bodies::Motion::free);
  add_body(bodies, box, pose, 900, bodies::BodyKind::vessel, bodies::Motion::articulated);
  add_body(bodies, box, pose, 900, bodies::BodyKind::vessel, bodies::Motion::fixed);
  add_body(bodies, box, pose, 900, bodies::BodyKind::rigid, bodies::Motion::fixed);
  add_body(bodies, box, pose, 900, bodies::BodyKind::floe, bodies::Motion::fixed);
  add_body(bodies, box, pose, 900, bodies::BodyKind::wall, bodies::Motion::fixed);
  bodies.shape.back() = std::make_shared<const geometry::Shape>(geometry::plane_shape());
  for (int b = 0; b < bodies.size(); ++b) EXPECT_EQ(buoyancy_on(bodies, b).force.z() > 0, b < 4) << b;
}

/// The energy right after the forces equals that of a new module, also when one body moves, one changes its shape, and
/// the list grows and shrinks.
TEST(Buoyancy, RemembersNothingWrong) {
  const auto module = hydro::make_buoyancy(sea(), 1);
  bodies::Bodies bodies;
  RandomStream random(10, "memory");
  const auto check = [&] {
    bodies::Wrenches out(static_cast<std::size_t>(bodies.size()));
    module->add_forces(bodies, 0, out);
    EXPECT_EQ(module->potential_energy(bodies), hydro::make_buoyancy(sea(), 1)->potential_energy(bodies));
    for (int b = 0; b < bodies.size(); ++b) EXPECT_EQ(out[b].force, buoyancy_on(bodies, b).force);
  };
  for (const geometry::Shape& shape : shapes()) {
    add_body(bodies, shape, {test::random_attitude(random), Vec3(0, 0, 0.3)});
    check();
  }
  bodies.set_pose(1, {0, 0, 0.1}, bodies.q_GB[1]);
  check();
  bodies.set_pose(2, bodies.p_GB[2], test::random_attitude(random));
  check();
  bodies.shape[0] = std::make_shared<const geometry::Shape>(geometry::box_shape({1, 1, 1}));
  check();
  bodies::Bodies fewer;
  add_body(fewer, shapes()[1], {Quat::Identity(), Vec3(0, 0, 0.2)});
  bodies = fewer;
  check();
}

TEST(Buoyancy, SameBitsForAnyThreadCount) {
  bodies::Bodies bodies;
  RandomStream random(11, "threads");
  for (int k = 0; k < 40; ++k)
    for (const geometry::Shape& shape : shapes())
      add_body(bodies, shape, {test::random_attitude(random), Vec3(0, 0, random.uniform())});
  bodies::Wrenches one(static_cast<std::size_t>(bodies.size())), three = one;
  const auto single = hydro::make_buoyancy(sea(), 1), triple = hydro::make_buoyancy(sea(), 3);
  single->add_forces(bodies, 0, one);
  triple->add_forces(bodies, 0, three);
  for (std::size_t b = 0; b < one.size(); ++b) {
    EXPECT_EQ(one[b].force, three[b].force);
    EXPECT_EQ(one[b].torque, three[b].torque);
  }
  EXPECT_EQ(single->potential_energy(bodies), triple->potential_energy(bodies));
}

}  // namespace buoyancy_test

}  // namespace nilas::water_test
