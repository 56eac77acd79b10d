#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/vessel/vessel_system.h"
#include "tests/core/vessel/example_vessel.h"
#include "tests/support/mentions.h"
#include "tests/support/refusal.h"

namespace nilas::vessel {
namespace carriage_motion_test {

std::string fault(const std::string& text) {
  const example::TemporaryFile file(text);
  const std::string found = test::refusal([&] { CarriageMotion::path(Vec3::Zero(), 0, file.path()); });
  EXPECT_TRUE(test::mentions(found, file.path())) << found << ":\n" << text;
  return found;
}

TEST(CarriageMotion, StraightRampIsTheClosedForm) {
  const double direction = 30 * k_deg, speed = 0.6, ramp = 2;
  const auto motion = CarriageMotion::straight({1, 2, 3}, 0.4, speed, direction, ramp, 10);
  const Vec3 along(std::cos(direction), std::sin(direction), 0);
  EXPECT_EQ(motion.at(9).p, Vec3(1, 2, 3));
  EXPECT_EQ(motion.at(9).v, Vec3::Zero());
  EXPECT_LT((motion.at(11).p - (Vec3(1, 2, 3) + 0.15 * along)).norm(), 1e-15);
  EXPECT_LT((motion.at(11).v - 0.3 * along).norm(), 1e-15);
  EXPECT_LT((motion.at(12).p - (Vec3(1, 2, 3) + 0.6 * along)).norm(), 1e-15);
  EXPECT_LT((motion.at(15).p - (Vec3(1, 2, 3) + 2.4 * along)).norm(), 1e-15);
  EXPECT_LT((motion.at(15).v - speed * along).norm(), 1e-15);
  EXPECT_EQ(motion.at(15).yaw, 0.4);
  EXPECT_EQ(motion.at(15).yaw_rate, 0);
}

/// The same place and speed after the ramp as by the linear one; its acceleration begins and ends at zero.
TEST(CarriageMotion, SmoothRampIsTheClosedForm) {
  const double direction = 30 * k_deg, speed = 0.6, ramp = 2;
  const auto motion = CarriageMotion::straight({1, 2, 3}, 0.4, speed, direction, ramp, 10, RampShape::smooth);
  const auto linear = CarriageMotion::straight({1, 2, 3}, 0.4, speed, direction, ramp, 10);
  const Vec3 along(std::cos(direction), std::sin(direction), 0);
  for (const double t : {9.0, 10.0, 12.0, 15.0}) {
    EXPECT_LT((motion.at(t).p - linear.at(t).p).norm(), 1e-15) << t;
    EXPECT_LT((motion.at(t).v - linear.at(t).v).norm(), 1e-15) << t;
  }
  const double s = 0.3;
  EXPECT_LT((motion.at(10 + s * ramp).v - speed * s * s * (3 - 2 * s) * along).norm(), 1e-15);
  EXPECT_LT((motion.moment(11, 11).acceleration.v - 1.5 * speed / ramp * along).norm(), 1e-15);
  for (const double t : {10.0, 12.0}) EXPECT_LT(motion.moment(t, 11).acceleration.v.norm(), 1e-15) << t;
  EXPECT_EQ(motion.kinks(), (std::vector<double>{10, 12}));
}

/// Every stretch of every motion: v and the acceleration are the derivatives of p and v, also beyond its ends.
TEST(CarriageMotion, DerivativesAreThoseOfEachStretch) {
  const example::TemporaryFile file("t_s,x_m,y_m,yaw_deg\n0,0,0,0\n0.3,1,0.2,5\n2,0.4,-1,-40\n2.5,3,0,10\n6,1,1,0\n");
  const std::vector<CarriageMotion> motions{CarriageMotion::straight({1, 2, 3}, 0.4, 0.6, 0.5, 2, 1),
                                            CarriageMotion::straight({1, 2, 3}, 0.4, 0.6, 0.5, 2, 1, RampShape::smooth),
                                            CarriageMotion::path({1, 2, 3}, 0.4, file.path())};
  constexpr double k_step = 1e-5;
  for (const CarriageMotion& motion : motions) {
    std::vector<double> ends = motion.kinks();
    ends.insert(ends.begin(), ends.front() - 1);
    ends.push_back(ends.back() + 1);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const double within = 0.5 * (ends[i] + ends[i + 1]);
      for (double t = ends[i] - 0.1; t < ends[i + 1] + 0.1; t += 0.0371) {
        const auto now = motion.moment(t, within), before = motion.moment(t - k_step, within),
                   after = motion.moment(t + k_step, within);
        EXPECT_LT((now.now.v - (after.now.p - before.now.p) / (2 * k_step)).norm(), 1e-8) << t;
        EXPECT_LT((now.acceleration.v - (after.now.v - before.now.v) / (2 * k_step)).norm(), 1e-8) << t;
        EXPECT_NEAR(now.now.yaw_rate, (after.now.yaw - before.now.yaw) / (2 * k_step), 1e-8) << t;
        EXPECT_NEAR(now.acceleration.yaw_rate, (after.now.yaw_rate - before.now.yaw_rate) / (2 * k_step), 1e-8) << t;
      }
      EXPECT_EQ(motion.moment(within, within).now.p, motion.at(within).p);
    }
  }
}

TEST(CarriageMotion, WithoutRampMovesFromTheStart) {
  const auto motion = CarriageMotion::straight(Vec3::Zero(), 0, 0.6, 0, 0, 10);
  EXPECT_EQ(motion.at(10).v, Vec3(0.6, 0, 0));
  EXPECT_EQ(motion.at(10).p, Vec3::Zero());
  EXPECT_EQ(motion.at(9.99).v, Vec3::Zero());
}

/// A straight line at constant speed is in the spline's space, yaw beyond a turn included.
TEST(CarriageMotion, PathOfConstantSpeedIsExact) {
  const example::TemporaryFile file("t_s,x_m,y_m,yaw_deg\n1,5,1,90\n2,5.5,1,270\n4,6.5,1,630\n4.5,6.75,1,720\n");
  const auto motion = CarriageMotion::path({1, 2, 3}, 0.25, file.path());
  for (const double t : {1.0, 1.7, 2.0, 3.3, 4.5}) {
    EXPECT_LT((motion.at(t).p - Vec3(1 + 0.5 * (t - 1), 2, 3)).norm(), 1e-14) << t;
    EXPECT_LT((motion.at(t).v - Vec3(0.5, 0, 0)).norm(), 1e-14) << t;
    EXPECT_NEAR(motion.at(t).yaw, 0.25 + k_pi * (t - 1), 1e-13) << t;
    EXPECT_NEAR(motion.at(t).yaw_rate, k_pi, 1e-13) << t;
  }
  EXPECT_EQ(motion.at(0).p, Vec3(1, 2, 3));
  EXPECT_EQ(motion.at(0).v, Vec3::Zero());
  EXPECT_LT((motion.at(9).p - Vec3(2.75, 2, 3)).norm(), 1e-14);
  EXPECT_EQ(motion.at(9).v, Vec3::Zero());
}

/// Natural spline through 0, 1, 0, 1 at t = 0..3, second derivatives M0 = M3 = 0 and
/// 4 M1 + M2 = 6 (-1 - 1) = -12, M1 + 4 M2 = 6 (1 + 1) = 12, so M1 = -4, M2 = 4.
TEST(CarriageMotion, PathIsTheNaturalSpline) {
  const example::TemporaryFile file("t_s,x_m,y_m,yaw_deg\n0,0,0,0\n1,1,0,0\n2,0,0,0\n3,1,0,0\n");
  const auto motion = CarriageMotion::path(Vec3::Zero(), 0, file.path());
  EXPECT_NEAR(motion.at(1).p.x(), 1, 1e-15);
  EXPECT_NEAR(motion.at(0.5).p.x(), 0.5 + 4.0 / 16, 1e-15);  // chord less span^2/16 (M0 + M1)
  EXPECT_NEAR(motion.at(1.5).p.x(), 0.5, 1e-15);
  EXPECT_NEAR(motion.at(0).v.x(), 1 + 4.0 / 6, 1e-15);  // slope less span/6 (2 M0 + M1)
  EXPECT_NEAR(motion.at(1).v.x(), 1 - 8.0 / 6, 1e-14);  // slope plus span/6 (M0 + 2 M1)
}

/// v is the derivative of p, also across knots and with uneven rows.
TEST(CarriageMotion, PathSpeedIsTheDerivative) {
  const example::TemporaryFile file("t_s,x_m,y_m,yaw_deg\n0,0,0,0\n0.3,1,0.2,5\n2,0.4,-1,-40\n2.5,3,0,10\n6,1,1,0\n");
  const auto motion = CarriageMotion::path(Vec3::Zero(), 0, file.path());
  constexpr double k_step = 1e-5;
  for (double t = 0.01; t < 5.9; t += 0.0371) {
    const auto state = motion.at(t), before = motion.at(t - k_step), after = motion.at(t + k_step);
    EXPECT_LT((state.v - (after.p - before.p) / (2 * k_step)).norm(), 1e-8) << t;
    EXPECT_NEAR(state.yaw_rate, (after.yaw - before.yaw) / (2 * k_step), 1e-8) << t;
  }
}

TEST(CarriageMotion, RefusesWrongPaths) {
  EXPECT_NE(fault("t_s,x_m,y_m,yaw_deg\n0,0,0,0\n1,1,0,0\n1,2,0,0\n").find(":4: t_s must grow"), std::string::npos);
  EXPECT_NE(fault("t_s,x_m,y_m,yaw_deg\n0,0,0,0\n").find("at least 2 rows"), std::string::npos);
  EXPECT_NE(fault("t_s,x_m,y_m,yaw_dge\n0,0,0,0\n").find("did you mean 'yaw_deg'?"), std::string::npos);
  EXPECT_NE(fault("t_s,x_m,y_m,yaw_deg\n0,0,zero,0\n").find(":2:5: 'zero' is no finite number"), std::string::npos);
  EXPECT_THROW(CarriageMotion::path(Vec3::Zero(), 0, "/nonexistent/track.csv"), FileError);
}

}  // namespace carriage_motion_test
}  // namespace nilas::vessel
