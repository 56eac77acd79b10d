#pragma once
/// Doubts about the water around a vessel, its database and its mooring.
#include <string>
#include <vector>

#include "core/sim/world/world.h"

namespace nilas::sim {

/// A doubt and the element of the scene that it is about.
struct WaterDoubt {
  std::string path;  ///< as warning_at() takes it
  std::string message;
};

/// Doubts about a vessel as it was built: added mass without effect, linear hydrostatics about an attitude that is not
/// that of rest, damping of mooring lines that the step does not bear, and a file of MoorDyn for other water.
std::vector<WaterDoubt> water_doubts(const scene::Scene& scene, const WorldParts& parts);

}  // namespace nilas::sim
