/// The vessel of several bodies against closed forms: a double pendulum, springs and dampers, loads in the joints.
#include <cmath>

#include "core/numerics/event_ode.h"
#include "tests/core/vessel/tree/jointed_example.h"

namespace nilas::vessel {
namespace jointed_pendulum_test {

VecX state_of(const VesselSystem& system) {
  const auto& parts = system.parts();
  VecX y(4);
  y << parts[0].coordinates, parts[1].coordinates, parts[0].rates, parts[1].rates;
  return y;
}

/// The state at time t by CVODE, from the closed form of the rates.
VecX exact(const VesselModel& model, double t) {
  numerics::EventOde ode;
  ode.derivative = [&](double, const VecX& y, VecX& dy) { example::double_pendulum_rates(model, y, dy); };
  numerics::OdeSettings settings;
  settings.relative = 1e-13;
  settings.absolute = VecX::Constant(4, 1e-13);
  VecX y = state_of(VesselSystem(model, 0));
  numerics::OdeSolution solution(std::move(ode), settings, 0, y);
  solution.follow(t, y);
  return y;
}

/// Errors of angles and rates after `t` with steps h, h/2, h/4.
std::vector<double> errors(const VesselModel& model, double t, double h) {
  const VecX expected = exact(model, t);
  std::vector<double> found;
  for (int halving = 0; halving < 3; ++halving, h /= 2) {
    VesselSystem system(model, 0);
    for (int k = 0; k < std::lround(t / h); ++k) example::step(system, example::weights(model), h);
    found.push_back((state_of(system) - expected).norm());
  }
  return found;
}

TEST(DoublePendulum, ConvergesWithTheOrderOfTheScheme) {
  for (const auto& [theta, order] : {std::pair(std::optional<double>(), 1.0), std::pair(std::optional(0.5), 2.0)}) {
    for (const bool sprung : {false, true}) {
      VesselModel model = example::double_pendulum(theta);
      if (sprung) {
        model.parts[0].stiffness = 30;
        model.parts[0].damping = 1.5;
        model.parts[0].rest = 0.3;
        model.parts[1].stiffness = 12;
        model.parts[1].damping = 0.2;
      }
      const auto found = errors(model, 1, 1.0 / 400);
      EXPECT_NEAR(std::log2(found[1] / found[2]), order, 0.08) << sprung << " " << found[0] << " " << found[2];
      EXPECT_LT(found[2], order == 1 ? 0.02 : 1.5e-4);
    }
  }
}

TEST(DoublePendulum, JointLoadsAreThoseOfTheClosedForm) {
  // The force in the upper joint is all mass times its acceleration, less the weight.
  VesselModel model = example::double_pendulum(0.5);
  model.parts[1].stiffness = 12;
  double last = 0;
  for (const double h : {1e-3, 5e-4}) {
    VesselSystem system(model, 0);
    example::step(system, example::weights(model), h);
    const VecX y = exact(model, 0.5 * h);
    VecX dy;
    example::double_pendulum_rates(model, y, dy);
    const Mat3 R = model.pose_V.q.toRotationMatrix();
    const auto at = [&](double length, double angle, double rate, double acceleration) -> Vec3 {
      return length * (R * Vec3(-std::cos(angle) * acceleration + std::sin(angle) * rate * rate, 0,
                                std::sin(angle) * acceleration + std::cos(angle) * rate * rate));
    };
    const double a = y[0], b = y[0] + y[1];
    const Vec3 acceleration1 = at(0.4, a, y[2], dy[2]);
    const Vec3 acceleration2 = at(1, a, y[2], dy[2]) + at(0.3, b, y[2] + y[3], dy[2] + dy[3]);
    const Vec3 g(0, 0, -example::k_gravity);
    const Vec3 lower = 2 * (acceleration2 - g), upper = lower + 3 * (acceleration1 - g);
    const double error =
        std::max((system.parts()[0].joint.force - upper).norm(), (system.parts()[1].joint.force - lower).norm());
    EXPECT_LT(error, 3e-3 * upper.norm()) << upper.norm();
    if (last > 0) {
      EXPECT_NEAR(std::log2(last / error), 2, 0.3) << last << " " << error;
    }
    last = error;
    // along the axis the joint gives the spring's torque, and none where it has no spring
    const Vec3 axis = R * Vec3::UnitY();
    EXPECT_NEAR(system.parts()[0].joint.torque.dot(axis), 0, 1e-3);
    EXPECT_NEAR(system.parts()[1].joint.torque.dot(axis), -12 * y[1], 1e-2);
  }
}

TEST(DoublePendulum, AtRestItsJointsBearItsWeight) {
  VesselModel model = example::double_pendulum({});
  for (PartModel& part : model.parts) part.coordinate = part.rate = 0;
  VesselSystem system(model, 0);
  for (int k = 0; k < 10; ++k) example::step(system, example::weights(model), 0.01);
  const auto& parts = system.parts();
  EXPECT_LT((parts[0].joint.force - Vec3(0, 0, 5 * example::k_gravity)).norm(), 1e-12);
  EXPECT_LT((parts[1].joint.force - Vec3(0, 0, 2 * example::k_gravity)).norm(), 1e-12);
  EXPECT_LT(parts[0].joint.torque.norm() + parts[1].joint.torque.norm(), 1e-12);
}

TEST(JointSpring, IsStableAtAnyStiffness) {
  // a spring of a period far below the step keeps its part, and a damper far above it lets it creep
  for (const auto theta : {std::optional<double>(), std::optional(0.5)}) {
    VesselModel model = example::double_pendulum(theta);
    for (PartModel& part : model.parts) {
      part.stiffness = 1e9;
      part.damping = 1e7;
      part.coordinate = 0.2;
      part.rate = 0;
      part.rest = 0.2;
    }
    VesselSystem stiff(model, 0);
    for (int k = 0; k < 2000; ++k) example::step(stiff, example::weights(model), 0.01);
    EXPECT_NEAR(stiff.parts()[0].coordinates[0], 0.2, 1e-6);
    model.parts[0].stiffness = 0;
    model.parts[0].damping = 1e4;
    VesselSystem slow(model, 0);
    double angle = slow.parts()[0].coordinates[0];
    for (int k = 0; k < 100; ++k) example::step(slow, example::weights(model), 0.01);
    // both bars turn as one about the upper hinge
    const double moment = example::k_gravity * (3 * 0.4 * std::sin(0.2) + 2 * (std::sin(0.2) + 0.3 * std::sin(0.4)));
    EXPECT_NEAR(slow.parts()[0].coordinates[0] - angle, -moment / 1e4, 3e-3 * moment / 1e4);
  }
}

}  // namespace jointed_pendulum_test
}  // namespace nilas::vessel
