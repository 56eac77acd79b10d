#pragma once
/// Natural periods of a scene, as `nilas check` reports them.
#include <nlohmann/json.hpp>
#include <string>

#include "core/sim/world/world.h"

namespace nilas {

struct PeriodsReport {
  std::string text;             ///< for the console, lines with their ends; empty where there are none
  nlohmann::ordered_json json;  ///< a list: motion, held_by, period_s, steps
};

PeriodsReport natural_periods_report(const Scene& scene, const WorldParts& parts);

}  // namespace nilas
