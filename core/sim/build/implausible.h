#pragma once
/// Warnings about scenes that can run but are probably not meant as written.
#include "core/sim/world/world.h"

namespace nilas::sim {

/// Adds the scene's own warnings and those of the built world to RunInfo::warnings.
void note_implausible(const scene::Scene& scene, WorldParts& parts);

}  // namespace nilas::sim
