#pragma once
/// The motion of free rigid bodies: velocities without contact, and the poses that velocities lead to.
#include "core/bodies/bodies.h"
#include "core/sim/step_motion.h"

namespace nilas {

/// Velocity step of the free bodies without contact: v + h F/m, and with L = I w the angular momentum, I w' = L + h T.
/// (The gyroscopic term is in advance(), through the conservation of L while the attitude changes.)
void free_velocities(const Bodies& bodies, const std::vector<Wrench>& loads, double h, Velocities& out);

/// Moves every free body over h with the velocities given. `gyroscopic`: angular momentum and energy of rotation are
/// kept to rounding, the attitude turns about the mean, in body axes, of the angular velocities at both ends [Simo,
/// Wong 1991, ALGO-C1]; else the angular velocity is kept. Larger turns than half a radian are made in parts.
void advance(Bodies& bodies, const Velocities& velocities, double h, bool gyroscopic, int threads);

/// Moves free bodies by pseudo velocities over h without touching their velocities.
void displace(Bodies& bodies, const Velocities& pseudo, double h);

/// Rotation by the vector `turn` [rad] as a quaternion (exponential map).
Quat exponential(const Vec3& turn);

}  // namespace nilas
