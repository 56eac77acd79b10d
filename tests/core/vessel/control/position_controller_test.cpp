#include "core/vessel/control/position_controller.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>

namespace position_controller_test {

using namespace nilas;
using vessel::ControllerSettings;
using vessel::PositionController;

/// The reference vessel of Fossen's toolbox: M = m (1.1274, 1.8902, 0.1278 L^2), D by Bis scaling with sqrt(g / L).
ControllerSettings supply_vessel() {
  constexpr double k_m = 6e6, k_length = 76.2;
  const double rate = std::sqrt(9.81 / k_length);
  return {.mass = k_m * Vec3(1.1274, 1.8902, 0.1278 * k_length * k_length),
          .damping = k_m * rate * Vec3(0.0358, 0.1183, 0.0308 * k_length * k_length),
          .bandwidth = Vec3(0.1, 0.1, 0.2),
          .damping_ratio = std::sqrt(0.5)};
}

// Without the integral M e'' + (D + K_d) e' + K_p e = 0 has the poles w (-zeta +- i sqrt(1 - zeta^2)); with it
// s^3 + 2 zeta w s^2 + w^2 s + w^3 / 10 = 0.
TEST(PositionController, PlacesThePolesOfTheClosedLoop) {
  const ControllerSettings plant = supply_vessel();
  const PositionController controller(plant);
  for (int k = 0; k < 3; ++k) {
    const double m = plant.mass[k], w = plant.bandwidth[k];
    Eigen::Matrix2d loop;
    loop << 0, 1, -controller.proportional()[k] / m, -(plant.damping[k] + controller.derivative()[k]) / m;
    const auto poles = loop.eigenvalues();
    for (int p = 0; p < 2; ++p) {
      EXPECT_NEAR(poles[p].real(), -w * std::sqrt(0.5), 1e-12);
      EXPECT_NEAR(std::abs(poles[p].imag()), w * std::sqrt(0.5), 1e-12);
    }
    Mat3 full;
    full << 0, 1, 0, 0, 0, 1, -controller.integral()[k] / m, -controller.proportional()[k] / m,
        -(plant.damping[k] + controller.derivative()[k]) / m;
    for (const std::complex<double>& s : full.eigenvalues()) {
      EXPECT_LT(std::abs(s * s * s + 2 * std::sqrt(0.5) * w * s * s + w * w * s + w * w * w / 10), 1e-12);
      EXPECT_LT(s.real(), 0);
    }
  }
}

/// One vessel under perfect measurements and thrusters that give what is asked, up to `most` in surge.
struct Loop {
  ControllerSettings plant = supply_vessel();
  PositionController controller{plant};
  vessel::ReferenceFilter reference{Vec3(0.1, 0.1, 0.2), Vec3(0, 0, 0.7)};
  Vec3 position{0, 0, 0.7}, velocity = Vec3::Zero();

  void step(const Vec3& target, const Vec3& bias_G, double most, double h) {
    const vessel::PassiveObserver estimate({}, position, velocity);
    reference.advance(target, Vec3::Zero(), h);
    const Vec3 wanted = controller.load(estimate, reference);
    Vec3 given = wanted;
    given.x() = std::clamp(given.x(), -most, most);
    controller.integrate(estimate, reference, wanted - given, h);
    const Mat3 R = vessel::plane_rotation(position.z());
    velocity += h * (given + R.transpose() * bias_G - plant.damping.cwiseProduct(velocity)).cwiseQuotient(plant.mass);
    position += h * (vessel::plane_rotation(position.z()) * velocity);
  }
};

// Feed-forward of acceleration and damping makes the vessel follow the filter: the error is that of the step.
TEST(PositionController, FollowsTheReferenceByFeedForward) {
  Loop loop;
  double most = 0;
  for (int k = 0; k < 4000; ++k) {
    loop.step(Vec3(20, -10, 0.7), Vec3::Zero(), 1e12, 0.05);
    most = std::max(most, (loop.position - loop.reference.position()).norm());
  }
  EXPECT_LT(most, 0.05) << "of a jump of 22 m";
  EXPECT_LT((loop.position - Vec3(20, -10, 0.7)).norm(), 1e-3);
}

TEST(PositionController, TakesASteadyLoadAwayByItsIntegral) {
  Loop loop;
  for (int k = 0; k < 20000; ++k) loop.step(Vec3(0, 0, 0.7), Vec3(2e5, -1e5, 3e6), 1e12, 0.1);
  EXPECT_LT((loop.position - Vec3(0, 0, 0.7)).norm(), 1e-4);
}

// For 300 s the thrusters cannot hold 500 kN; afterwards the load falls to 100 kN. Without back-calculation the
// integral of the lost position would drive the vessel far to the other side.
TEST(PositionController, DoesNotWindUp) {
  Loop loop;
  for (int k = 0; k < 3000; ++k) loop.step(Vec3(0, 0, 0), Vec3(5e5, 0, 0), 4e5, 0.1);
  const double lost = loop.position.x();
  EXPECT_GT(lost, 10);
  double overshoot = 0;
  for (int k = 0; k < 20000; ++k) {
    loop.step(Vec3(0, 0, 0), Vec3(1e5, 0, 0), 4e5, 0.1);
    overshoot = std::min(overshoot, loop.position.x());
  }
  EXPECT_GT(overshoot, -0.25 * lost);
  EXPECT_LT(std::abs(loop.position.x()), 1e-2);
}

}  // namespace position_controller_test
