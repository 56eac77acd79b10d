#pragma once
/// Checks whether the hull of a scene's vessel is plausible as placed.
#include <string>
#include <vector>

#include "core/sim/world/world.h"

namespace nilas::sim {

/// The sentences of hull_doubts() about the vessel as the scene places it; empty without a vessel.
std::vector<std::string> vessel_doubts(const scene::Scene& scene, const WorldParts& parts);

}  // namespace nilas::sim
