#pragma once
/// The mooring of a scene's vessel at the start, as `nilas check` reports it.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/sim/world/world.h"

namespace nilas::commands {

struct MooringReport {
  std::string text;
  nlohmann::ordered_json json;
};

/// Tensions of all lines, the load on the vessel about its centre of mass and the stiffness there. Empty without a
/// mooring.
std::optional<MooringReport> mooring_report(const sim::WorldParts& parts);

}  // namespace nilas::commands
