#pragma once
/// One step of the reference integrator, with all impacts and other events in it.
#include "core/sim/account/step_record.h"
#include "core/sim/reference/reference.h"
#include "core/sim/world/world_state.h"

namespace nilas::sim {

/// Advances the world by its step with `reference`, which moves the bodies of this world. Throws SimulationError.
StepRecord take_reference_step(World& world, ReferenceIntegrator& reference);

}  // namespace nilas::sim
