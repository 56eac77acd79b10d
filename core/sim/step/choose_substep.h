#pragma once
/// Where a substep ends: with the step, or with the first impact of fast bodies.
#include "core/sim/step/substep.h"
#include "core/sim/world/world_state.h"

namespace nilas {

/// The substep from `t` of at most `longest` [s]; `may_cut`: it may end with the first impact of a fast pair. Loads and
/// contacts change velocities by the substep's length, so that the length is a fixed point. Trials leave no trace but
/// in the detector's caches.
Substep choose_substep(World& world, const Loads& loads, double t, double longest, bool may_cut);

}  // namespace nilas
