#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/math.h"
#include "core/vessel/tree/exponential_mode.h"

namespace nilas::vessel {
namespace vessel_exponential_mode_test {

constexpr double k_h = 0.01;

/// x'' + 2 zeta omega x' + omega^2 x = p by Runge-Kutta 4 with `substeps` per step of k_h: x, x', x'' at every substep.
struct Trajectory {
  std::vector<double> x, v, a;
};
Trajectory runge_kutta(double omega, double zeta, double p, double x, double v, int steps, int substeps) {
  const auto acceleration = [&](double position, double speed) {
    return p - 2 * zeta * omega * speed - omega * omega * position;
  };
  Trajectory out{{x}, {v}, {acceleration(x, v)}};
  const double t = k_h / substeps;
  for (int i = 0; i < steps * substeps; ++i) {
    const double a1 = acceleration(x, v);
    const double v2 = v + 0.5 * t * a1, a2 = acceleration(x + 0.5 * t * v, v2);
    const double v3 = v + 0.5 * t * a2, a3 = acceleration(x + 0.5 * t * v2, v3);
    const double v4 = v + t * a3, a4 = acceleration(x + t * v3, v4);
    x += t / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += t / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    out.x.push_back(x);
    out.v.push_back(v);
    out.a.push_back(acceleration(x, v));
  }
  return out;
}

ExponentialMode mode_of(double a, double zeta) {
  const double omega = a / k_h;
  return exponential_mode(omega, a > 0 ? 2 * zeta / omega : 0, k_h);
}

/// Largest and last reading (the load on the support) under a unit step of load from rest.
struct StepResponse {
  double largest = 0, last = 0;
};
StepResponse step_response(double a, double zeta, int steps) {
  const ExponentialMode mode = mode_of(a, zeta);
  const double stiffness = (a / k_h) * (a / k_h);
  double x = 0, v = 0;
  StepResponse response;
  for (int i = 0; i < steps; ++i) {
    const double before = v;
    v = mode.decay * v + mode.response * k_h * (1 - stiffness * x);
    x += k_h * v;
    response.last = 1 - (v - before) / k_h;
    response.largest = std::max(response.largest, std::abs(response.last));
  }
  return response;
}

/// Free motion about the loaded rest passes through the exact positions, in all three damping regimes, and the change
/// of speed is the exact acceleration averaged over both steps with the weights of a triangle.
TEST(VesselExponentialMode, IsExactForResolvedModes) {
  constexpr int k_steps = 60, k_substeps = 400;
  for (const double a : {0.045, 0.45, 1.2, 1.5})
    for (const double zeta : {0.0, 0.05, 0.7, 1.0, 1.8}) {
      const double omega = a / k_h, p = 3;
      const Trajectory exact = runge_kutta(omega, zeta, p, 2e-3, 0.1, k_steps, k_substeps);
      const ExponentialMode mode = mode_of(a, zeta);
      double x = exact.x[k_substeps], v = (exact.x[k_substeps] - exact.x[0]) / k_h;
      for (int i = 1; i < k_steps; ++i) {
        const double before = v;
        v = mode.decay * v + mode.response * k_h * (p - omega * omega * x);
        x += k_h * v;
        const auto now = static_cast<std::size_t>(i * k_substeps);
        ASSERT_NEAR(x, exact.x[now + k_substeps], 2e-10) << a << " " << zeta;
        double mean = 0;
        for (int s = -k_substeps; s <= k_substeps; ++s)
          mean += (k_substeps - std::abs(s)) * exact.a[now + static_cast<std::size_t>(s + k_substeps) - k_substeps];
        mean /= static_cast<double>(k_substeps) * k_substeps;
        const double scale = p + 2 * zeta * omega * 0.1 + omega * omega * 2e-3;
        ASSERT_NEAR((v - before) / k_h, mean, 1e-5 * scale) << a << " " << zeta;  // trapezoidal rule of the average
      }
    }
}

TEST(VesselExponentialMode, WithoutSpringIsTheStepOfAFreeBody) {
  const ExponentialMode mode = exponential_mode(0, 1e-3, k_h);
  EXPECT_EQ(mode.decay, 1);
  EXPECT_EQ(mode.response, 1);
}

/// response = 1 - zeta a + (8 zeta^2 - 1) a^2 / 12 + ..., without cancellation however soft the spring is.
TEST(VesselExponentialMode, SoftSpringsFollowTheSeries) {
  for (const double a : {1e-3, 1e-5, 1e-8, 1e-12, 1e-150})
    for (const double zeta : {0.0, 0.05, 0.999999, 1.0, 1.000001, 2.0}) {
      const ExponentialMode mode = mode_of(a, zeta);
      const double series = 1 - zeta * a + (8 * zeta * zeta - 1) * a * a / 12;
      EXPECT_NEAR(mode.response, series, 10 * a * a * a + 1e-15) << a << " " << zeta;
      EXPECT_NEAR(mode.decay, 1 - 2 * zeta * a + 2 * zeta * zeta * a * a, 12 * a * a * a + 1e-15) << a << " " << zeta;
    }
}

/// The characteristic polynomial s^2 - (1 + d - g a^2) s + d has its roots within the unit circle (Jury), and the
/// response that a contact sees is positive, for every stiffness and damping.
TEST(VesselExponentialMode, StaysPositiveAndStable) {
  for (double zeta = 0; zeta <= 2.0; zeta += 0.01)
    for (double a = 1e-6; a <= 1e6; a *= 1.03) {
      const ExponentialMode mode = mode_of(a, zeta);
      const double spring = mode.response * a * a;
      ASSERT_GT(mode.response, 0) << a << " " << zeta;
      ASSERT_GE(spring, std::min(0.2 * a * a, 0.2)) << a << " " << zeta;
      ASSERT_LE(mode.response, 1) << a << " " << zeta;
      ASSERT_GE(mode.decay, 0);
      ASSERT_LE(mode.decay, 1);
      ASSERT_LT(spring, 2 * (1 + mode.decay)) << a << " " << zeta;
    }
  for (int turns = 1; turns < 50; ++turns) EXPECT_GT(mode_of(2 * k_pi * turns, 0).response, 0);
}

/// Heavy dashpots: damping times up to seconds on the stiffest spring.
TEST(VesselExponentialMode, TakesAnyDampingTime) {
  for (double time = 1e-9; time < 1e4; time *= 10) {
    const ExponentialMode mode = exponential_mode(4500, time, k_h);
    EXPECT_GT(mode.response, 0) << time;
    EXPECT_TRUE(std::isfinite(mode.response));
  }
}

/// The step response never exceeds the undamped oscillator's doubled load by more than 8 %, also where the numerical
/// damping sets in, and settles on the load.
TEST(VesselExponentialMode, StepResponseNeverRunsAway) {
  for (double a = 0.01; a < 1e3; a *= 1.01) {
    EXPECT_LT(step_response(a, 0, 4000).largest, 2.15) << a;
    const bool settles = a * 4000 * 0.05 > 40;
    EXPECT_NEAR(step_response(a, 0.05, 4000).last, 1, settles ? 1e-12 : 1.1) << a;
  }
}

/// Largest load of spring and damper after a step of load, zeta 0.05, against the fine solution.
TEST(VesselExponentialMode, KeepsTheDynamicPeakOfResolvedModes) {
  const auto true_peak = [](double omega) {
    const Trajectory t = runge_kutta(omega, 0.05, 1, 0, 0, 100, 50);
    double peak = 0;
    for (const double a : t.a) peak = std::max(peak, 1 - a);
    return peak;
  };
  EXPECT_NEAR(true_peak(45), 1 + std::exp(-0.05 * k_pi), 5e-3);  // spring alone; the damper adds a little
  for (const double a : {0.1, 0.45, 0.8, 1.2, 1.5})
    EXPECT_NEAR(step_response(a, 0.05, 400).largest / true_peak(a / k_h), 1, a < 1 ? 0.02 : 0.1) << a;
}

TEST(VesselExponentialMode, NumericalDampingSetsInBelowFourStepsPerPeriod) {
  EXPECT_EQ(least_damping_ratio(0), 0);
  EXPECT_EQ(least_damping_ratio(0.5 * k_pi), 0);
  EXPECT_NEAR(least_damping_ratio(0.75 * k_pi), 0.25, 1e-15);
  EXPECT_EQ(least_damping_ratio(k_pi), 1);
  EXPECT_EQ(least_damping_ratio(1e6), 1);
}

}  // namespace vessel_exponential_mode_test
}  // namespace nilas::vessel
