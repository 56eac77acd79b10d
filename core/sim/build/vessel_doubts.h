#pragma once
/// Whether the hull of a scene's vessel can be meant as it is.
#include <string>
#include <vector>

#include "core/sim/world/world.h"

namespace nilas {

/// Sentences of hull_doubts() about the built vessel as the scene places it; empty for a scene without one.
std::vector<std::string> vessel_doubts(const Scene& scene, const WorldParts& parts);

}  // namespace nilas
