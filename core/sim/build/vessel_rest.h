#pragma once
/// The vessel at rest on its carriage before the run: where it starts, and what its balance reads there.
#include "core/sim/world/world.h"

namespace nilas {

/// Puts parts.vessel, whose bodies are `specs`, hull first, in static equilibrium under weight and, where the scene has
/// it, buoyancy, unless the scene wants it as placed; notes the tare in parts.info, or in parts.restless the part that
/// finds no rest. Nothing without a carriage. Throws InputError when a vessel that is to start in equilibrium finds
/// none.
void settle_vessel(const Scene& scene, const std::vector<BodySpec>& specs, WorldParts& parts);

}  // namespace nilas
