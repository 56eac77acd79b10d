#pragma once
/// Yaw, pitch and roll in the nautical convention, from quaternions and angular velocities.
#include "core/base/math.h"

namespace nilas::output {

/// Angles of R_GB = Rz(yaw) Ry(pitch) Rx(roll) [rad]; yaw and roll in (-pi, pi], pitch in [-pi/2, pi/2].
struct EulerAngles {
  double yaw = 0, pitch = 0, roll = 0;
  /// True if |cos pitch| < k_gimbal_lock: yaw and roll are then not defined separately. Roll is 0 and yaw is the whole
  /// rotation.
  bool gimbal_lock = false;
};
EulerAngles euler_angles(const Quat& q_GB);

/// Time derivatives of the angles [rad/s]; all zero at gimbal lock.
struct EulerRates {
  double roll = 0, pitch = 0, yaw = 0;
};
EulerRates euler_rates(const Quat& q_GB, const Vec3& w_GB);

/// Limit of |cos pitch| below which the rates would exceed the angular velocity a billion times.
constexpr double k_gimbal_lock = 1e-9;

}  // namespace nilas::output
