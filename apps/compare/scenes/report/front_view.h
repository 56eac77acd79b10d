#pragma once
/// What the script of the page draws fronts from.
#include <nlohmann/json.hpp>

#include "apps/compare/scenes/report/scene_report.h"

namespace nilas::compare {

/// A list of fronts; apps/view/page/src/compare draws each. `figures`: for each setting of the plan the names and
/// values that are shown at its mark.
nlohmann::ordered_json fronts_view(const SceneReport& report,
                                   const std::vector<std::vector<std::pair<std::string, std::string>>>& figures);

}  // namespace nilas::compare
