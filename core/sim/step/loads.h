#pragma once
/// Loads other than contact.
#include "core/sim/step/substep.h"
#include "core/sim/world/world_state.h"

namespace nilas::sim {

/// Weight and the modules' loads at the present poses, for a substep that begins at `t` and lasts at most `h` [s].
/// Throws SimulationError naming a body whose loads are not finite.
Loads evaluate_loads(World& world, double t, double h);

}  // namespace nilas::sim
