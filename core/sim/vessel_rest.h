#pragma once
/// The vessel at rest on its carriage before the run: where it starts, and what its balance reads there.
#include "core/sim/world.h"

namespace nilas {

/// Puts parts.vessel, whose body is `spec`, in static equilibrium under its weight and, where the scene has it, its
/// buoyancy, unless the scene wants it as placed; notes the tare in parts.info. Nothing without a carriage, and nothing
/// for a vessel with parts on joints, which starts as placed. Throws
/// InputError when a vessel that is to start in equilibrium finds none.
void settle_vessel(const Scene& scene, const BodySpec& spec, WorldParts& parts);

}  // namespace nilas
