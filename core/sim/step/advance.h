#pragma once
/// Motion of free rigid bodies: velocities without contact, and poses after a motion with given velocities.
#include "contact/step_motion.h"
#include "core/bodies/bodies.h"

namespace nilas::sim {

/// Velocity step of the free bodies without contact: v + h F/m and, with L = I w, I w' = L + h T. (The gyroscopic term
/// is in advance(), which conserves L while the attitude changes.) Added mass joins m and I.
void free_velocities(const bodies::Bodies& bodies, const std::vector<Wrench>& loads, double h,
                     contact::Velocities& out);

/// Moves every free body over h [s] with the given velocities. `gyroscopic`: by turn_freely() of core/bodies, which
/// keeps angular momentum and energy of rotation, or with added mass by move_freely(); else the velocities are kept.
void advance(bodies::Bodies& bodies, const contact::Velocities& velocities, double h, bool gyroscopic, int threads);

/// Moves free bodies by pseudo velocities over h [s]; their own velocities do not change.
void displace(bodies::Bodies& bodies, const contact::Velocities& pseudo, double h);

}  // namespace nilas::sim
