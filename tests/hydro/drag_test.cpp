#include <gtest/gtest.h>

#include "hydro/modules.h"
#include "tests/hydro/solids.h"
#include "tests/support/random_vectors.h"

namespace nilas::water_test {

namespace drag_test {

constexpr double k_deep = -50;  // A depth at which bodies are wholly under water [m].

hydro::Water still() { return {}; }

hydro::Water with_current(const Vec3& current) {
  hydro::Water water;
  water.current = current;
  return water;
}

bodies::Wrenches drag(const bodies::Bodies& bodies, const hydro::DragCoefficients& coefficients,
                      const hydro::Water& water = still(), int threads = 1) {
  bodies::Wrenches out(static_cast<std::size_t>(bodies.size()));
  hydro::make_drag(water, coefficients, threads)->add_forces(bodies, 0, out);
  return out;
}

std::vector<Vec2> rectangle(double length, double width) {
  const double x = 0.5 * length, y = 0.5 * width;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

/// All shapes at random poses near the surface with random motion.
bodies::Bodies random_bodies(const std::string& stream, int rounds) {
  bodies::Bodies bodies;
  RandomStream random(20, stream);
  for (int k = 0; k < rounds; ++k)
    for (const geometry::Shape& shape : shapes()) {
      const Vec3 p(random.uniform(-5, 5), random.uniform(-5, 5), 0.7 * random.uniform(-1, 1));
      const int b = add_body(bodies, shape, {test::random_attitude(random), p});
      bodies.v_GB[b] = test::random_vector(random);
      bodies.w_GB[b] = test::random_vector(random);
    }
  return bodies;
}

double energy_in(const bodies::Bodies& bodies, const Vec3& current) {
  const Vec3 v = bodies.v_GB[0] - current, &w = bodies.w_GB[0];
  return 0.5 * bodies.mass[0] * v.squaredNorm() + 0.5 * w.dot(bodies.inertia_G(0) * w);
}

/// A sliver that flies and spins takes explicit steps. Drag reduces its energy relative to the water in each, however
/// long the step; without the limit the first step multiplies it. A slow sliver keeps its load to the bit.
TEST(Drag, ASliverIsBrakedByAnyStep) {
  const Vec3 current(0.3, -0.2, 0);
  const hydro::DragCoefficients coefficients{1.0, 0.005};
  const auto sliver = [](double speed) {
    bodies::Bodies bodies;
    add_body(bodies, geometry::prism_shape(rectangle(0.15, 0.01), 0.04),
             {Quat(0.9, 0.1, 0.3, -0.3).normalized(), {0, 0, k_deep}});
    bodies.v_GB[0] = speed * Vec3(1, -2, 0.5);
    bodies.w_GB[0] = 100 * speed * Vec3(3, 1, -2);
    return bodies;
  };
  for (const double h : {1e-4, 1e-2, 1.0})
    for (const double speed : {1.0, 20.0, 1000.0}) {
      bodies::Bodies bodies = sliver(speed);
      const auto module = hydro::make_drag(with_current(current), coefficients, 1);
      double before = energy_in(bodies, current);
      bool limited = false;
      for (int step = 0; step < 50; ++step) {
        bodies::Wrenches out(1);
        module->add_forces(bodies, 0, out);
        const Vec3 whole = out[0].force;
        module->limit(bodies, h, out);
        limited = limited || whole != out[0].force;
        bodies.v_GB[0] += h / bodies.mass[0] * out[0].force;
        bodies.w_GB[0] += h * bodies.inertia_G(0).ldlt().solve(out[0].torque);
        const double after = energy_in(bodies, current);
        EXPECT_LE(after, before * (1 + 1e-12)) << h << " " << speed << " " << step;
        before = after;
      }
      EXPECT_TRUE(limited || h * speed < 0.1);
    }
  const bodies::Bodies slow = sliver(0.01);
  const auto module = hydro::make_drag(with_current(Vec3::Zero()), coefficients, 1);
  bodies::Wrenches out(1);
  module->add_forces(slow, 0, out);
  const Wrench whole = out[0];
  module->limit(slow, 1e-2, out);
  EXPECT_EQ(out[0].force, whole.force);
  EXPECT_EQ(out[0].torque, whole.torque);
}

/// m v' = F - k v^2 with k = 0.5 rho C_f A: v = v_t tanh(F t / (m v_t)), v_t = sqrt(F / k). A plate on edge, pushed
/// broadside; no skin drag on its rims. Runge-Kutta of fourth order, 400 steps over 8 time constants.
TEST(Drag, PlatePushedBroadsideReachesItsTerminalVelocity) {
  const double A = 3.0 * 2.0, push = 700, form = 1.2;
  const double k = 0.5 * still().density * form * A, terminal = std::sqrt(push / k);
  bodies::Bodies bodies;
  add_body(bodies, geometry::prism_shape(rectangle(3, 2), 0.05),
           {Quat(Eigen::AngleAxisd(k_pi / 2, Vec3::UnitY())), {0, 0, k_deep}});
  const double m = bodies.mass[0], constant = m * terminal / push, h = constant / 50;
  const auto module = hydro::make_drag(still(), {form, 0}, 1);
  const auto acceleration = [&](double v) {
    bodies.v_GB[0] = {v, 0, 0};
    bodies::Wrenches out(1);
    module->add_forces(bodies, 0, out);
    return (push + out[0].force.x()) / m;
  };
  double v = 0;
  for (int step = 1; step <= 2000; ++step) {
    const double a = acceleration(v), b = acceleration(v + 0.5 * h * a), c = acceleration(v + 0.5 * h * b),
                 d = acceleration(v + h * c);
    v += h / 6 * (a + 2 * b + 2 * c + d);
    if (step <= 400) {
      ASSERT_NEAR(v, terminal * std::tanh(step * h / constant), 1e-8 * terminal);
    }
  }
  EXPECT_NEAR(v, terminal, 1e-12 * terminal);
}

/// A level floe sinking at v: its bottom meets the flow, its deck does not, 0.5 rho C_f A v^2 at the centroid; its
/// sides take skin drag upwards, each at its middle.
TEST(Drag, SinkingFloe) {
  const double T = 0.4, form = 1.1, skin = 0.01, q = 0.5 * 1025 * 0.09;
  const geometry::Shape shape = geometry::prism_shape(concave_outline(), T);
  Wrench expected;
  expected.force = {0, 0, q * form * geometry::polygon_moments(shape.outline).area};
  for (std::size_t i = 0; i < shape.outline.size(); ++i) {
    const Vec2 a = shape.outline[i], b = shape.outline[(i + 1) % shape.outline.size()], middle = 0.5 * (a + b);
    const Vec3 lift(0, 0, q * skin * T * (b - a).norm());
    expected += {lift, Vec3(middle.x(), middle.y(), 0).cross(lift)};
  }
  bodies::Bodies bodies;
  add_body(bodies, shape, {Quat::Identity(), {0, 0, k_deep}});
  bodies.v_GB[0] = {0, 0, -0.3};
  const Wrench wrench = drag(bodies, {form, skin})[0];
  EXPECT_LT((wrench.force - expected.force).norm(), 1e-12 * expected.force.norm());
  EXPECT_LT((wrench.torque - expected.torque).norm(), 1e-12 * expected.force.norm());
}

/// A plate slides along itself: 0.5 rho C_s A v^2 over both faces and the two rims parallel to the motion.
TEST(Drag, SkinOfASlidingPlate) {
  const double L = 3, B = 2, T = 0.05, v = 0.8, skin = 0.004;
  const geometry::Shape prism = geometry::prism_shape(rectangle(L, B), T), box = geometry::box_shape({L, B, T});
  for (const geometry::Shape& shape : {prism, box}) {
    bodies::Bodies bodies;
    add_body(bodies, shape, {Quat(Eigen::AngleAxisd(0.6, Vec3::UnitX())), {0, 0, k_deep}});
    bodies.v_GB[0] = {v, 0, 0};
    const Wrench wrench = drag(bodies, {0, skin})[0];
    const double expected = 0.5 * 1025 * skin * v * v * 2 * (L * B + L * T);
    EXPECT_LT((wrench.force + Vec3(expected, 0, 0)).norm(), 1e-12 * expected);
    EXPECT_LT(wrench.torque.norm(), 1e-12 * expected);
  }
}

/// A box afloat at draught d, towed: form 0.5 rho C_f B d v^2 at half the draught; skin on bottom and two sides.
TEST(Drag, TowedFloatingBox) {
  const double L = 3, B = 2, T = 0.8, d = 0.5, v = 1.3, form = 0.9, skin = 0.005, q = 0.5 * 1025 * v * v;
  for (const geometry::Shape& shape : {geometry::prism_shape(rectangle(L, B), T), geometry::box_shape({L, B, T})}) {
    bodies::Bodies bodies;
    add_body(bodies, shape, {Quat::Identity(), {0, 0, 0.5 * T - d}}, 500, bodies::BodyKind::vessel,
             bodies::Motion::articulated);
    bodies.v_GB[0] = {v, 0, 0};
    const Wrench wrench = drag(bodies, {form, skin})[0];
    const double pressure = q * form * B * d, bottom = q * skin * L * B, sides = q * skin * 2 * L * d;
    const double force = pressure + bottom + sides;
    EXPECT_LT((wrench.force + Vec3(force, 0, 0)).norm(), 1e-12 * force);
    // Lever arms below the centre of mass: wet sides and bow at their middle, the bottom at T/2.
    const double torque = (pressure + sides) * (0.5 * T - 0.5 * d) + bottom * 0.5 * T;
    EXPECT_LT((wrench.torque - Vec3(0, torque, 0)).norm(), 1e-12 * force);
  }
}

/// The flow meets half the sphere: integral of cos^2 cos dA = pi r^2 / 2, so C_f / 2 on the cross-section. Skin:
/// integral of sin^3 dA = 2 pi r^2 (3 pi / 8). 512 facets keep both within 0.5 %.
TEST(Drag, Sphere) {
  const double r = 0.8, q = 0.5 * 1025;
  bodies::Bodies bodies;
  add_body(bodies, geometry::sphere_shape(r), {Quat::Identity(), {0, 0, k_deep}});
  RandomStream random(21, "sphere");
  for (int k = 0; k < 20; ++k) {
    bodies.v_GB[0] = test::random_vector(random).normalized();
    const Vec3 form = drag(bodies, {1, 0})[0].force, skin = drag(bodies, {0, 1})[0].force;
    const double expected_form = q * k_pi * r * r / 2, expected_skin = q * 0.75 * k_pi * k_pi * r * r;
    EXPECT_LT((form + expected_form * bodies.v_GB[0]).norm(), 0.005 * expected_form);
    EXPECT_LT((skin + expected_skin * bodies.v_GB[0]).norm(), 0.005 * expected_skin);
  }
}

/// A body at rest in a current -U has the same bits as one that moves at U in still water. A common velocity changes
/// nothing.
TEST(Drag, DependsOnTheRelativeVelocityOnly) {
  const Vec3 U(0.7, -0.2, 0.1);
  bodies::Bodies moving = random_bodies("galilei", 5), resting = moving, carried = moving;
  for (std::size_t b = 0; b < moving.v_GB.size(); ++b) {
    moving.v_GB[b] = U;
    resting.v_GB[b].setZero();
    carried.v_GB[b] = U + Vec3(3, 4, 5);
  }
  const bodies::Wrenches a = drag(moving, {}), b = drag(resting, {}, with_current(-U)),
                         c = drag(carried, {}, with_current({3, 4, 5}));
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].force, b[k].force);
    EXPECT_EQ(a[k].torque, b[k].torque);
    EXPECT_LT((a[k].force - c[k].force).norm(), 1e-13 * a[k].force.norm() + 1e-13);
    EXPECT_LT((a[k].torque - c[k].torque).norm(), 1e-13 * a[k].torque.norm() + 1e-13 * a[k].force.norm());
  }
}

/// The wrench turns with body, motion and current about z.
TEST(Drag, TurnsWithTheFrame) {
  const Quat turn(Eigen::AngleAxisd(1.234, Vec3::UnitZ()));
  const Vec3 current(0.4, 0.3, 0);
  const bodies::Bodies bodies = random_bodies("frame", 5);
  bodies::Bodies turned = bodies;
  for (int k = 0; k < bodies.size(); ++k) {
    const auto b = static_cast<std::size_t>(k);
    turned.set_pose(k, turn * bodies.p_GB[b], turn * bodies.q_GB[b]);
    turned.v_GB[b] = turn * bodies.v_GB[b];
    turned.w_GB[b] = turn * bodies.w_GB[b];
  }
  const bodies::Wrenches a = drag(bodies, {}, with_current(current)),
                         b = drag(turned, {}, with_current(turn * current));
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double scale = a[k].force.norm() + a[k].torque.norm();
    EXPECT_LT((turn * a[k].force - b[k].force).norm(), 1e-13 * scale);
    EXPECT_LT((turn * a[k].torque - b[k].torque).norm(), 1e-13 * scale);
  }
}

/// Drag in still water only dissipates energy, face by face: F v + T w <= 0.
TEST(Drag, Dissipates) {
  const bodies::Bodies bodies = random_bodies("power", 30);
  for (const hydro::DragCoefficients& c : {hydro::DragCoefficients{1, 0}, hydro::DragCoefficients{0, 1}}) {
    const bodies::Wrenches out = drag(bodies, c);
    for (std::size_t b = 0; b < out.size(); ++b)
      EXPECT_LE(out[b].force.dot(bodies.v_GB[b]) + out[b].torque.dot(bodies.w_GB[b]), 0);
  }
}

/// The rule has one point per face. A square floe that spins or rocks about its centre has no flow at any face's
/// centroid, so there is no form drag. This limit of the rule is documented.
TEST(Drag, OnePointPerFaceSeesNoFormDragOnASpinningSquareFloe) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::prism_shape(rectangle(1, 1), 0.2), {Quat::Identity(), {0, 0, k_deep}});
  for (const Vec3& w : {Vec3(1, 0, 0), Vec3(0, 0, 1)}) {
    bodies.w_GB[0] = w;
    const Wrench form = drag(bodies, {1, 0})[0], skin = drag(bodies, {0, 1})[0];
    EXPECT_LT(form.torque.norm(), 1e-13);
    EXPECT_LT(skin.torque.dot(w), -1);
  }
}

TEST(Drag, NothingOnWhatIsDryFixedOrAWall) {
  const geometry::Shape box = geometry::box_shape({1, 1, 1});
  bodies::Bodies bodies;
  add_body(bodies, box, {Quat::Identity(), {0, 0, 5}});
  add_body(bodies, box, {}, 900, bodies::BodyKind::rigid, bodies::Motion::fixed);
  add_body(bodies, box, {}, 900, bodies::BodyKind::wall, bodies::Motion::fixed);
  add_body(bodies, box, {}, 900, bodies::BodyKind::vessel, bodies::Motion::fixed);
  const bodies::Wrenches out = drag(bodies, {}, with_current({1, 0, 0}));
  for (std::size_t b = 0; b < 3; ++b) {
    EXPECT_EQ(out[b].force, Vec3::Zero());
    EXPECT_EQ(out[b].torque, Vec3::Zero());
  }
  EXPECT_GT(out[3].force.x(), 0);
}

TEST(Drag, SameBitsForAnyThreadCount) {
  const bodies::Bodies bodies = random_bodies("threads", 30);
  const bodies::Wrenches one = drag(bodies, {}, still(), 1), three = drag(bodies, {}, still(), 3);
  for (std::size_t b = 0; b < one.size(); ++b) {
    EXPECT_EQ(one[b].force, three[b].force);
    EXPECT_EQ(one[b].torque, three[b].torque);
  }
}

/// The force F = coefficient (velocity - v) acts on free floes only.
TEST(VirtualDrag, PullsFloesTowardsItsVelocity) {
  const geometry::Shape shape = geometry::prism_shape(rectangle(1, 1), 0.1);
  bodies::Bodies bodies;
  add_body(bodies, shape, {}, 900, bodies::BodyKind::floe);
  add_body(bodies, shape, {}, 900, bodies::BodyKind::floe, bodies::Motion::fixed);
  add_body(bodies, shape, {}, 900, bodies::BodyKind::rigid);
  add_body(bodies, shape, {}, 900, bodies::BodyKind::vessel, bodies::Motion::articulated);
  for (auto& v : bodies.v_GB) v = {0.1, 0.2, -0.3};
  for (auto& w : bodies.w_GB) w = {1, 2, 3};
  const auto module = hydro::make_virtual_drag(0.1, {0.389, 0, 0});
  bodies::Wrenches out(4);
  module->add_forces(bodies, 0, out);
  EXPECT_LT((out[0].force - Vec3(0.0289, -0.02, 0.03)).norm(), 1e-16);
  EXPECT_EQ(out[0].torque, Vec3::Zero());
  for (std::size_t b = 1; b < 4; ++b) EXPECT_EQ(out[b].force, Vec3::Zero());
  EXPECT_FALSE(module->conservative());
  EXPECT_EQ(module->potential_energy(bodies), 0);
  module->limit(bodies, 900, out);
  EXPECT_LT((out[0].force - Vec3(0.0289, -0.02, 0.03)).norm(), 1e-16) << "h c is as small as the mass";
}

/// An explicit step would overshoot the velocity.
TEST(VirtualDrag, BringsAFloeToItsVelocityAtMost) {
  const geometry::Shape shape = geometry::prism_shape(rectangle(1, 1), 0.1);
  bodies::Bodies bodies;
  add_body(bodies, shape, {}, 900, bodies::BodyKind::floe);
  bodies.v_GB[0] = {0.1, 0.2, -0.3};
  const auto module = hydro::make_virtual_drag(1e5, {0.389, 0, 0});
  bodies::Wrenches out(1);
  module->add_forces(bodies, 0, out);
  module->limit(bodies, 0.05, out);
  EXPECT_LT((bodies.v_GB[0] + 0.05 / bodies.mass[0] * out[0].force - Vec3(0.389, 0, 0)).norm(), 1e-15);
}

}  // namespace drag_test

}  // namespace nilas::water_test
