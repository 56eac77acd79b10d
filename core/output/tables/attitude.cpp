#include "core/output/tables/attitude.h"

#include <cmath>

namespace nilas::output {

namespace {

/// |cos pitch| of a rotation matrix. sqrt(R00^2 + R10^2) keeps full precision near 90 degrees, where asin and acos lose
/// half of the digits.
double cosine_of_pitch(const Mat3& R) { return std::hypot(R(0, 0), R(1, 0)); }

}  // namespace

EulerAngles euler_angles(const Quat& q_GB) {
  const Mat3 R = q_GB.normalized().toRotationMatrix();
  const double cos_pitch = cosine_of_pitch(R);
  EulerAngles angles;
  angles.pitch = std::atan2(-R(2, 0), cos_pitch);
  angles.gimbal_lock = cos_pitch < k_gimbal_lock;
  if (angles.gimbal_lock) {
    angles.yaw = std::atan2(-R(0, 1), R(1, 1));
    return angles;
  }
  angles.yaw = std::atan2(R(1, 0), R(0, 0));
  angles.roll = std::atan2(R(2, 1), R(2, 2));
  return angles;
}

EulerRates euler_rates(const Quat& q_GB, const Vec3& w_GB) {
  const Mat3 R = q_GB.normalized().toRotationMatrix();
  const double cos_pitch = cosine_of_pitch(R);
  if (cos_pitch < k_gimbal_lock) return {};
  const Vec3 w_B = R.transpose() * w_GB;
  const double sin_roll = R(2, 1) / cos_pitch, cos_roll = R(2, 2) / cos_pitch;
  EulerRates rates;
  rates.yaw = (w_B.y() * sin_roll + w_B.z() * cos_roll) / cos_pitch;
  rates.pitch = w_B.y() * cos_roll - w_B.z() * sin_roll;
  rates.roll = w_B.x() - R(2, 0) * rates.yaw;  // sin pitch = -R20
  return rates;
}

}  // namespace nilas::output
