#pragma once
/// The motion of free rigid bodies: velocities without contact, and the poses that velocities lead to.
#include "contact/step_motion.h"
#include "core/bodies/bodies.h"

namespace nilas {

/// Velocity step of the free bodies without contact: v + h F/m, and with L = I w the angular momentum, I w' = L + h T.
/// (The gyroscopic term is in advance(), through the conservation of L while the attitude changes.)
void free_velocities(const Bodies& bodies, const std::vector<Wrench>& loads, double h, Velocities& out);

/// Moves every free body over h with the velocities given. `gyroscopic`: by turn_freely() of core/bodies, which keeps
/// angular momentum and energy of rotation; else the angular velocity is kept.
void advance(Bodies& bodies, const Velocities& velocities, double h, bool gyroscopic, int threads);

/// Moves free bodies by pseudo velocities over h without touching their velocities.
void displace(Bodies& bodies, const Velocities& pseudo, double h);

}  // namespace nilas
