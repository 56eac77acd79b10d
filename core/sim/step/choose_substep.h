#pragma once
/// Choice of a substep's end: the end of the step, or the first impact of fast bodies.
#include "core/sim/step/substep.h"
#include "core/sim/world/world_state.h"

namespace nilas {

/// The substep from `t` of at most `longest` [s]. `may_cut`: it may end with the first impact of a fast pair. The
/// velocities depend on the substep's length through loads and contacts, so the length is a fixed point. Trials change
/// nothing but the detector's caches.
Substep choose_substep(World& world, const Loads& loads, double t, double longest, bool may_cut);

}  // namespace nilas
