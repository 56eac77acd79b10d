#pragma once
/// How a comparison was measured, in words.
#include <string>
#include <vector>

#include "apps/compare/scenes/report/scene_report.h"

namespace nilas {

/// What judged the settings, over which ice and time, how chance and times were measured, and what was left out.
std::vector<std::string> method_lines(const SceneReport& report);

/// "setting", "perturbed run", "reference", "reference at twice its step".
const char* plain_name_of(RunKind kind);

}  // namespace nilas
