#pragma once
/// Rotation of a rigid body that no torque acts on.
#include "core/base/math.h"

namespace nilas::bodies {

/// Rotation by the vector `turn` [rad] as a quaternion (exponential map).
Quat exponential(const Vec3& turn);

/// Turns a body freely over h [s]: angular momentum and energy of rotation are kept to rounding, the attitude turns
/// about the mean, in body axes, of the angular velocities at both ends [Simo, Wong 1991, ALGO-C1]. Larger turns than
/// half a radian are made in parts. q: unit, body B in G; w: angular velocity in G [rad/s]; inertia_B about the centre
/// of mass [kg m^2] with its inverse.
void turn_freely(Quat& q, Vec3& w, const Mat3& inertia_B, const Mat3& inertia_inverse_B, double h);

}  // namespace nilas::bodies
