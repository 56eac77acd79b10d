/// Pose updates of free bodies: closed forms and conservation.
#include "core/sim/step/advance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace advance_test {

using namespace nilas;
using namespace nilas::sim;

bodies::Bodies one_body(const Vec3& moments, const Vec3& w) {
  bodies::Bodies bodies;
  bodies::BodySpec spec;
  spec.shape = std::make_shared<const geometry::Shape>(geometry::box_shape({1, 1, 1}));
  spec.mass = 2;
  spec.inertia_B = moments.asDiagonal();
  spec.pose.q = Quat(0.5, 0.5, -0.5, 0.5);
  spec.w = w;
  bodies.add(spec);
  return bodies;
}

contact::Velocities velocities_of(const bodies::Bodies& bodies) { return {bodies.v_GB, bodies.w_GB}; }

TEST(Advance, AboutAPrincipalAxisIsExact) {
  bodies::Bodies bodies = one_body({1, 2, 3}, Vec3::Zero());
  bodies.w_GB[0] = bodies.R_GB[0] * Vec3(0, 0, 1.7);
  const Mat3 start = bodies.R_GB[0];
  const double h = 0.01;
  for (int k = 0; k < 100; ++k) advance(bodies, velocities_of(bodies), h, true, 1);
  const Mat3 expected = start * Eigen::AngleAxisd(1.7, Vec3::UnitZ()).toRotationMatrix();
  EXPECT_LT((bodies.R_GB[0] - expected).norm(), 1e-13);
}

/// The torque-free asymmetric top keeps angular momentum and energy to rounding, at any speed; its attitude is of
/// second order.
TEST(Advance, AnAsymmetricTopKeepsItsAngularMomentumAndEnergy) {
  for (const double speed : {1.0, 30.0, 1000.0}) {
    bodies::Bodies bodies = one_body({1, 2, 2.5}, speed * Vec3(0.4, 1, 0.3).normalized());
    const Vec3 L0 = bodies.inertia_G(0) * bodies.w_GB[0];
    const double E0 = 0.5 * bodies.w_GB[0].dot(L0);
    const int steps = speed > 100 ? 2000 : 100000;
    for (int k = 0; k < steps; ++k) advance(bodies, velocities_of(bodies), 0.01, true, 1);
    const Vec3 L = bodies.inertia_G(0) * bodies.w_GB[0];
    EXPECT_LT((L - L0).norm(), 2e-11 * L0.norm()) << speed;
    EXPECT_LT(std::abs(0.5 * bodies.w_GB[0].dot(L) / E0 - 1), 1e-11) << speed;
    EXPECT_NEAR(bodies.q_GB[0].norm(), 1, 1e-15);
  }
}

TEST(Advance, AnAsymmetricTopsAttitudeIsOfSecondOrder) {
  const auto attitude = [](double h) {
    bodies::Bodies bodies = one_body({1, 2, 3}, {0.4, 2, 0.3});
    for (int k = 0; k < static_cast<int>(std::lround(4 / h)); ++k) advance(bodies, velocities_of(bodies), h, true, 1);
    return bodies.q_GB[0];
  };
  const Quat exact = attitude(1e-4);
  double last = 0;
  for (const double h : {0.04, 0.02, 0.01, 0.005}) {
    const double error = exact.angularDistance(attitude(h));
    if (last > 0) {
      EXPECT_NEAR(std::log2(last / error), 2, 0.1);
    }
    last = error;
  }
}

TEST(Advance, WithoutTheGyroscopicTermTheAngularVelocityIsKept) {
  bodies::Bodies bodies = one_body({1, 2, 3}, {0.4, 2, 0.3});
  const Vec3 w = bodies.w_GB[0];
  for (int k = 0; k < 100; ++k) advance(bodies, velocities_of(bodies), 0.01, false, 1);
  EXPECT_EQ(bodies.w_GB[0], w);
}

TEST(FreeVelocities, ObeyNewtonAndEuler) {
  const bodies::Bodies bodies = one_body({1, 2, 3}, {0.1, 0.2, 0.3});
  const std::vector<Wrench> loads{{{3, -1, 2}, {0.5, 0.1, -0.7}}};
  contact::Velocities out;
  free_velocities(bodies, loads, 0.1, out);
  EXPECT_LT((bodies.mass[0] * (out.v[0] - bodies.v_GB[0]) - 0.1 * loads[0].force).norm(), 1e-15);
  EXPECT_LT((bodies.inertia_G(0) * (out.w[0] - bodies.w_GB[0]) - 0.1 * loads[0].torque).norm(), 1e-15);
}

TEST(Displace, LeavesVelocitiesAlone) {
  bodies::Bodies bodies = one_body({1, 2, 3}, {0.1, 0.2, 0.3});
  const Vec3 v = bodies.v_GB[0], w = bodies.w_GB[0];
  displace(bodies, {{Vec3(1, 0, 0)}, {Vec3(0, 0, 1)}}, 0.01);
  EXPECT_EQ(bodies.v_GB[0], v);
  EXPECT_EQ(bodies.w_GB[0], w);
  EXPECT_NEAR(bodies.p_GB[0].x(), 0.01, 1e-16);
}

}  // namespace advance_test
