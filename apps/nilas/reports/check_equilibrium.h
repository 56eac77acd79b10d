#pragma once
/// The floating equilibrium of a scene's vessel, as `nilas check` reports it.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/sim/world/world.h"

namespace nilas::commands {

struct EquilibriumReport {
  std::string text;             ///< text for the console; each line has its line end
  nlohmann::ordered_json json;  ///< names with units
};

/// Empty for a scene without a vessel or without buoyancy. A vessel that cannot float is reported with the reason.
std::optional<EquilibriumReport> vessel_equilibrium(const scene::Scene& scene, const sim::WorldParts& parts);

}  // namespace nilas::commands
