#pragma once
/// The tables and the JSON object of a comparison; columns and keys are in docs/reference/outputs.md.
#include <nlohmann/json.hpp>
#include <string>

#include "apps/compare/scenes/report/scene_report.h"

namespace nilas::compare {

/// The text of compare.csv: a row per run.
std::string runs_csv(const SceneReport& report);
/// The text of settings.csv: a row per setting.
std::string settings_csv(const SceneReport& report);
/// The text of loads.csv: a row per setting, load channel and statistic.
std::string loads_csv(const SceneReport& report);
/// The JSON object of compare.json.
nlohmann::ordered_json report_json(const SceneReport& report);

}  // namespace nilas::compare
