#include "core/output/tables/attitude.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace nilas::output {
namespace attitude_test {

Quat from_angles(double yaw, double pitch, double roll) {
  return Eigen::AngleAxisd(yaw, Vec3::UnitZ()) * Eigen::AngleAxisd(pitch, Vec3::UnitY()) *
         Eigen::AngleAxisd(roll, Vec3::UnitX());
}

const std::array<Vec3, 6> k_angles{Vec3(0.3, 0.2, -0.1), Vec3(-3.0, 1.2, 2.5),   Vec3(1.0, -1.5, 0.4),
                                   Vec3(3.1, 0, -3.1),   Vec3(-0.5, 0.01, 0.02), Vec3(2.0, 1.57, 1.0)};

TEST(Attitude, RecoversTheAnglesOfARotation) {
  for (const Vec3& a : k_angles) {
    const EulerAngles angles = euler_angles(from_angles(a[0], a[1], a[2]));
    // Near 90 degrees of pitch a rounding error of the quaternion turns yaw and roll by 1 / cos pitch of it.
    const double tolerance = 1e-15 * 4 / std::cos(a[1]);
    EXPECT_NEAR(angles.yaw, a[0], tolerance);
    EXPECT_NEAR(angles.pitch, a[1], 2e-15);
    EXPECT_NEAR(angles.roll, a[2], tolerance);
    EXPECT_FALSE(angles.gimbal_lock);
  }
}

TEST(Attitude, AgreesWithTheQuaternionFormulas) {
  const Quat q = Quat(0.4, -0.3, 0.2, 0.8).normalized();
  const double w = q.w(), x = q.x(), y = q.y(), z = q.z();
  const EulerAngles angles = euler_angles(q);
  EXPECT_NEAR(angles.yaw, std::atan2(2 * (x * y + w * z), w * w + x * x - y * y - z * z), 1e-15);
  EXPECT_NEAR(angles.pitch, std::asin(2 * (w * y - x * z)), 1e-15);
  EXPECT_NEAR(angles.roll, std::atan2(2 * (y * z + w * x), w * w - x * x - y * y + z * z), 1e-15);
}

TEST(Attitude, RatesAreTheDerivativesOfTheAngles) {
  const Vec3 w(0.7, -1.1, 0.5);
  const double h = 1e-5;
  const auto turned = [&](const Quat& q, double t) {
    return Quat(Eigen::AngleAxisd(w.norm() * t, w.normalized())) * q;
  };
  for (const Vec3& a : {k_angles[0], k_angles[1], k_angles[2], k_angles[4]}) {
    const Quat q = from_angles(a[0], a[1], a[2]);
    const EulerRates rates = euler_rates(q, w);
    const EulerAngles before = euler_angles(turned(q, -h)), after = euler_angles(turned(q, h));
    // The central difference is wrong by h^2/6 times the third derivative, which grows with 1 / cos^3 pitch.
    const double tolerance = 1e-9 / std::pow(std::cos(a[1]), 3);
    EXPECT_NEAR(rates.yaw, (after.yaw - before.yaw) / (2 * h), tolerance);
    EXPECT_NEAR(rates.pitch, (after.pitch - before.pitch) / (2 * h), tolerance);
    EXPECT_NEAR(rates.roll, (after.roll - before.roll) / (2 * h), tolerance);
  }
}

TEST(Attitude, LevelRatesAreTheAngularVelocity) {
  const EulerRates rates = euler_rates(Quat::Identity(), Vec3(1, 2, 3));
  EXPECT_EQ(rates.roll, 1);
  EXPECT_EQ(rates.pitch, 2);
  EXPECT_EQ(rates.yaw, 3);
}

TEST(Attitude, AtGimbalLockTheRatesAreZeroAndTheAnglesStillGiveTheRotation) {
  for (const double pitch : {0.5 * k_pi, -0.5 * k_pi}) {
    const Quat q = from_angles(0.8, pitch, 0.3);
    const EulerAngles angles = euler_angles(q);
    EXPECT_TRUE(angles.gimbal_lock);
    EXPECT_NEAR(angles.pitch, pitch, 1e-15);
    EXPECT_EQ(angles.roll, 0);
    EXPECT_NEAR((from_angles(angles.yaw, angles.pitch, angles.roll).toRotationMatrix() - q.toRotationMatrix()).norm(),
                0, 1e-15);
    const EulerRates rates = euler_rates(q, Vec3(1, 2, 3));
    EXPECT_EQ(rates.roll, 0);
    EXPECT_EQ(rates.pitch, 0);
    EXPECT_EQ(rates.yaw, 0);
  }
}

TEST(Attitude, GimbalLockBeginsAtItsThreshold) {
  EXPECT_TRUE(euler_angles(from_angles(0, 0.5 * k_pi - 0.5e-9, 0)).gimbal_lock);
  EXPECT_FALSE(euler_angles(from_angles(0, 0.5 * k_pi - 2e-9, 0)).gimbal_lock);
}

}  // namespace attitude_test
}  // namespace nilas::output
