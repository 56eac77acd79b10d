#pragma once
/// Choice of a substep's end: the end of the step, or the first impact of fast bodies.
#include "core/sim/step/substep.h"
#include "core/sim/world/world_state.h"

namespace nilas::sim {

/// The substep from `t` of at most `longest` [s]. `may_cut`: it may end with the first impact of a fast pair. The
/// velocities depend on the substep's length through loads and contacts, so the length is a fixed point. Trials move no
/// body. They change only what the detector and the modules remember of the poses at the start of the substep.
Substep choose_substep(World& world, const Loads& loads, double t, double longest, bool may_cut);

}  // namespace nilas::sim
