#pragma once
/// One time step.
#include "core/sim/account/step_record.h"
#include "core/sim/world/world_state.h"

namespace nilas::sim {

/// Advances the world by its step. Throws SimulationError when a body's values are no longer finite, when a body would
/// pass through another or, where the scene asks to stop, when the contact solver does not converge.
StepRecord take_step(World& world);

}  // namespace nilas::sim
