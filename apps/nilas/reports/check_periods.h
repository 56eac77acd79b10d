#pragma once
/// The natural periods of a scene, as `nilas check` reports them.
#include <nlohmann/json.hpp>
#include <string>

#include "core/sim/world/world.h"

namespace nilas::commands {

struct PeriodsReport {
  std::string text;             ///< text for the console; each line has its line end; empty without periods
  nlohmann::ordered_json json;  ///< a list with the keys motion, held_by, period_s and steps
};

PeriodsReport natural_periods_report(const scene::Scene& scene, const sim::WorldParts& parts);

}  // namespace nilas::commands
