#pragma once
/// The vessel at rest on its carriage before the run: its initial pose, and the reading of its balance there.
#include "core/sim/world/world.h"

namespace nilas::sim {

/// Moves parts.vessel into static equilibrium under weight and, where the scene has it, buoyancy, unless the scene
/// wants it as placed. `specs` are its bodies, hull first. Notes the tare in parts.info or, if no rest is found, the
/// part at fault in parts.restless. Does nothing without a carriage. Throws InputError when a vessel that is to start
/// in equilibrium finds none.
void settle_vessel(const scene::Scene& scene, const std::vector<bodies::BodySpec>& specs, WorldParts& parts);

}  // namespace nilas::sim
