#pragma once
/// Motion of a rigid body that no load acts on, alone or with the water that it carries.
#include "core/base/math.h"

namespace nilas::bodies {

/// Rotation by the vector `turn` [rad] as a quaternion (exponential map).
Quat exponential(const Vec3& turn);

/// Turns a body freely over h [s]: angular momentum and energy of rotation are kept to rounding, the attitude turns
/// about the mean, in body axes, of the angular velocities at both ends [Simo, Wong 1991, ALGO-C1]. Larger turns than
/// half a radian are made in parts. q: unit, body B in G; w: angular velocity in G [rad/s]; inertia_B about the centre
/// of mass [kg m^2] with its inverse.
void turn_freely(Quat& q, Vec3& w, const Mat3& inertia_B, const Mat3& inertia_inverse_B, double h);

/// Moves a body freely over h [s] with the water that it carries. `p`: centre of mass [m]; `v`: its velocity [m/s];
/// `mass_B`: the whole 6 x 6 mass of body and water about the centre of mass, in body axes, with its inverse; `flow`:
/// velocity of the undisturbed water, to which the water's part refers [m/s]. Momenta and kinetic energy obey
/// Kirchhoff's equations [Lamb, Hydrodynamics, 124]: seen from the flow, the momentum, the angular momentum about a
/// fixed point and the energy are kept to rounding. Both momenta are carried along the motion by the mean of the twists
/// at both ends, in body axes.
void move_freely(Vec3& p, Quat& q, Vec3& v, Vec3& w, const Mat6& mass_B, const Mat6& mass_inverse_B, const Vec3& flow,
                 double h);

}  // namespace nilas::bodies
