#include "core/vessel/thrusters/rudder.h"

#include <gtest/gtest.h>

namespace rudder_test {

using namespace nilas;
using vessel::Rudder;

Rudder rudder() {
  return {.area = 9, .span = 4, .behind = 2, .diameter = 3.6, .most_angle = 35 * k_deg, .water_density = 1025};
}

// In the plane of the propeller the slipstream has the mean of both speeds (momentum theory); far behind it has V_inf,
// on the disc area times that mean over V_inf.
TEST(Rudder, StandsInTheSlipstreamOfMomentumTheory) {
  const double thrust = 4e5, advance = 3;
  const double disc = k_pi * 1.8 * 1.8;
  const double far = std::sqrt(advance * advance + 2 * thrust / (1025 * disc));
  Rudder at = rudder();
  at.behind = 0;
  EXPECT_NEAR(slipstream_at(at, thrust, advance).speed, 0.5 * (advance + far), 1e-12);
  EXPECT_NEAR(slipstream_at(at, thrust, advance).radius, 1.8, 1e-12);
  at.behind = 1e6;
  EXPECT_NEAR(slipstream_at(at, thrust, advance).speed, far, 1e-6);
  EXPECT_NEAR(slipstream_at(at, thrust, advance).radius, 1.8 * std::sqrt(0.5 * (1 + advance / far)), 1e-6);
}

// The flow through the slipstream is the same at every distance: r^2 V = r_inf^2 V_inf.
TEST(Rudder, KeepsTheFlowOfTheSlipstream) {
  Rudder at = rudder();
  double flow = 0;
  for (const double x : {0.0, 0.7, 2.0, 9.0}) {
    at.behind = x;
    const auto stream = slipstream_at(at, 2e5, 1.5);
    const double here = stream.radius * stream.radius * stream.speed;
    if (flow == 0) flow = here;
    EXPECT_NEAR(here, flow, 1e-12 * flow);
  }
}

// Aspect ratio 1.5, 20 degrees: slope 2 pi 1.5 2.2 / 3.2^2 = 2.02485; C_L = 0.69254 + 0.10992 = 0.80246;
// C_D = 0.64395 / 4.71239 + 0.04001 + 0.008 = 0.18466.
TEST(Rudder, HasTheCoefficientsOfItsSource) {
  const auto c = vessel::rudder_coefficients(1.5, 20 * k_deg);
  EXPECT_NEAR(c.lift, 0.80246, 1e-5);
  EXPECT_NEAR(c.drag, 0.18466, 1e-5);
}

TEST(Rudder, PushesToPortAtAPositiveAngleAndSlowsDown) {
  const Vec2 force = rudder_force(rudder(), 15 * k_deg, 3e5, 0, 0);
  EXPECT_GT(force.y(), 0);
  EXPECT_LT(force.x(), 0);
  const Vec2 mirrored = rudder_force(rudder(), -15 * k_deg, 3e5, 0, 0);
  EXPECT_DOUBLE_EQ(mirrored.y(), -force.y());
  EXPECT_DOUBLE_EQ(mirrored.x(), force.x());
}

TEST(Rudder, ResistsSidewaysMotionAheadAndDoesNothingAtRest) {
  EXPECT_LT(rudder_force(rudder(), 0, 0, 4, 0.5).y(), 0);
  EXPECT_TRUE(rudder_force(rudder(), 20 * k_deg, 0, 0, 0).isZero(0));
  EXPECT_TRUE(rudder_force(rudder(), 20 * k_deg, -1e5, -1, 0).isZero(0));
}

// Without advance V^2 goes with the thrust, so the force does too: allocation relies on it.
TEST(Rudder, IsProportionalToThrustWithoutAdvance) {
  const Vec2 one = rudder_force(rudder(), 25 * k_deg, 1, 0, 0), many = rudder_force(rudder(), 25 * k_deg, 5e5, 0, 0);
  EXPECT_LT((many - 5e5 * one).norm(), 1e-9 * many.norm());
}

}  // namespace rudder_test
