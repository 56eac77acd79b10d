#include <gtest/gtest.h>

#include "core/base/random.h"
#include "hydro/modules.h"
#include "tests/hydro/solids.h"
#include "tests/support/random_vectors.h"

namespace nilas::water_test {

namespace drag_in_flows_test {

constexpr double k_deep = -50;  // A depth at which bodies are wholly under water [m].

/// Water that moves as a whole by U cos(t).
class Uniform : public hydro::Flow {
 public:
  explicit Uniform(const Vec3& U) : U_(U) {}
  Vec3 velocity(const Vec3& /*p_G*/, double t) const override { return std::cos(t) * U_; }

 private:
  Vec3 U_;
};

/// Shear: u = k z.
class Shear : public hydro::Flow {
 public:
  explicit Shear(double k) : k_(k) {}
  Vec3 velocity(const Vec3& p_G, double /*t*/) const override { return {k_ * p_G.z(), 0, 0}; }

 private:
  double k_;
};

/// A flow that the vessel does not feel.
class Wash : public Uniform {
 public:
  using Uniform::Uniform;
  bool acts_on_vessel() const override { return false; }
};

hydro::Water water_with(const Vec3& current, const hydro::Flows& flows) {
  hydro::Water water;
  water.current = current;
  water.flows = flows;
  return water;
}

bodies::Wrenches drag(const bodies::Bodies& bodies, const hydro::Water& water, double t = 0, int threads = 1,
                      bool order_free = false) {
  bodies::Wrenches out(static_cast<std::size_t>(bodies.size()));
  hydro::make_drag(water, {}, threads, order_free)->add_forces(bodies, t, out);
  return out;
}

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

std::vector<Vec2> square(double side) {
  const double x = 0.5 * side;
  return {{-x, -x}, {x, -x}, {x, x}, {-x, x}};
}

/// Parts of the flow that are uniform add up to a current, at the time for which loads are asked.
TEST(DragInFlows, UniformPartsAreACurrent) {
  const Vec3 U(0.3, -0.7, 0.1), c(0.2, 0.1, 0);
  const bodies::Bodies bodies = random_bodies("uniform", 5);
  const double t = 0.4;
  for (const bool order_free : {false, true}) {
    const hydro::Water water =
        water_with(c, {std::make_shared<Uniform>(0.25 * U), std::make_shared<Uniform>(0.75 * U)});
    const bodies::Wrenches a = drag(bodies, water_with(c + std::cos(t) * U, {}), t, 1, order_free),
                           b = drag(bodies, water, t, 1, order_free);
    for (std::size_t k = 0; k < a.size(); ++k) {
      const double scale = a[k].force.norm() + a[k].torque.norm();
      EXPECT_LT((a[k].force - b[k].force).norm(), 1e-13 * scale);
      EXPECT_LT((a[k].torque - b[k].torque).norm(), 1e-13 * scale);
    }
  }
}

/// The limit of an explicit step is the same, too, as that in a current.
TEST(DragInFlows, LimitInAUniformFlowIsThatInACurrent) {
  const Vec3 U(30, -20, 0);
  bodies::Bodies bodies = random_bodies("limit", 5);
  for (int b = 0; b < bodies.size(); ++b) bodies.w_GB[static_cast<std::size_t>(b)] *= 30;
  const double h = 0.5;
  int limited = 0;
  const auto load = [&](const hydro::Water& water) {
    bodies::Wrenches out(static_cast<std::size_t>(bodies.size()));
    const auto module = hydro::make_drag(water, {}, 2);
    module->add_forces(bodies, 0, out);
    const bodies::Wrenches whole = out;
    module->limit(bodies, h, out);
    for (std::size_t b = 0; b < out.size(); ++b) limited += out[b].force == whole[b].force ? 0 : 1;
    return out;
  };
  const bodies::Wrenches a = load(water_with(U, {})),
                         b = load(water_with(Vec3::Zero(), {std::make_shared<Uniform>(U)}));
  EXPECT_GT(limited, 10);
  for (std::size_t k = 0; k < a.size(); ++k)
    EXPECT_LT((a[k].force - b[k].force).norm(), 1e-11 * (a[k].force.norm() + 1));
}

/// A cube of side s in u = k z, its centre at depth d: the form drag on the face that meets the flow is that at its
/// centroid, 0.5 rho C_f s^2 (k d)^2. The skin drag on top and bottom differs, (k (d -+ s/2))^2, which turns the cube.
TEST(DragInFlows, EveryFaceSeesTheFlowAtItsCentroid) {
  const double s = 2, d = 10, k = 0.05, q = 0.5 * 1025 * s * s * k * k;
  bodies::Bodies bodies;
  add_body(bodies, geometry::prism_shape(square(s), s), {Quat::Identity(), {0, 0, -d}});
  const Wrench out = drag(bodies, water_with(Vec3::Zero(), {std::make_shared<Shear>(k)}))[0];
  const hydro::DragCoefficients c;
  const double top = q * c.skin * (d - 0.5 * s) * (d - 0.5 * s), bottom = q * c.skin * (d + 0.5 * s) * (d + 0.5 * s);
  const double sides = 2 * q * c.skin * d * d, form = q * c.form * d * d;
  EXPECT_NEAR(out.force.x(), -(top + bottom + sides + form), 1e-12 * form);
  EXPECT_NEAR(out.torque.y(), 0.5 * s * (bottom - top), 1e-12 * form);
}

/// A step in the edge of a flow is not taken for one without power: a floe that moves as fast as the water at its
/// centre still gets the drag of its bottom.
TEST(DragInFlows, FloeAtTheSpeedOfItsCentreKeepsItsLoad) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::prism_shape(square(2), 2), {Quat::Identity(), {0, 0, -10}});
  bodies.v_GB[0] = {-0.05 * 10 + 1e-9, 0, 0};
  const auto module = hydro::make_drag(water_with(Vec3::Zero(), {std::make_shared<Shear>(0.05)}), {}, 1);
  bodies::Wrenches out(1);
  module->add_forces(bodies, 0, out);
  const Wrench whole = out[0];
  module->limit(bodies, 0.01, out);
  EXPECT_GT(whole.torque.norm(), 1e-3);
  EXPECT_EQ(out[0].force, whole.force);
  EXPECT_EQ(out[0].torque, whole.torque);
}

/// What the vessel's own propeller moves acts on floes only. The bits of the vessel are those without it.
TEST(DragInFlows, VesselLeavesOutWhatDoesNotActOnIt) {
  const geometry::Shape box = geometry::box_shape({2, 1, 1});
  bodies::Bodies bodies;
  add_body(bodies, box, {Quat::Identity(), {0, 0, k_deep}}, 900, bodies::BodyKind::vessel, bodies::Motion::articulated);
  add_body(bodies, box, {Quat::Identity(), {5, 0, k_deep}}, 900, bodies::BodyKind::floe);
  for (auto& v : bodies.v_GB) v = {0.3, 0.2, 0.1};
  const Vec3 c(0.1, 0, 0);
  const auto wash = std::make_shared<Wash>(Vec3(1, 0, 0));
  const bodies::Wrenches without = drag(bodies, water_with(c, {})), with = drag(bodies, water_with(c, {wash}));
  EXPECT_EQ(with[0].force, without[0].force);
  EXPECT_EQ(with[0].torque, without[0].torque);
  EXPECT_GT((with[1].force - without[1].force).norm(), 10);
}

TEST(DragInFlows, SameBitsForAnyThreadCount) {
  const bodies::Bodies bodies = random_bodies("threads", 30);
  const hydro::Water water = water_with({0.1, 0, 0}, {std::make_shared<Shear>(0.3)});
  const bodies::Wrenches one = drag(bodies, water, 0, 1), three = drag(bodies, water, 0, 3);
  for (std::size_t b = 0; b < one.size(); ++b) {
    EXPECT_EQ(one[b].force, three[b].force);
    EXPECT_EQ(one[b].torque, three[b].torque);
  }
}

}  // namespace drag_in_flows_test

}  // namespace nilas::water_test
