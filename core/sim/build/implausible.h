#pragma once
/// Scenes that can be run but can hardly mean what they say, as far as the built world tells.
#include "core/sim/world/world.h"

namespace nilas {

/// Adds the scene's own warnings and those of the built world to RunInfo::warnings.
void note_implausible(const Scene& scene, WorldParts& parts);

}  // namespace nilas
