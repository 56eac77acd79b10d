#pragma once
/// The method of a comparison in words.
#include <string>
#include <vector>

#include "apps/compare/scenes/report/scene_report.h"

namespace nilas::compare {

/// The reference, the ice and the time of the comparison, how chance and times were measured, and what was left out.
std::vector<std::string> method_lines(const SceneReport& report);

/// The name of a kind of run in the table of all runs: "setting", "reference", "reference at twice its step" or
/// "perturbed run of the scene's own setting".
const char* plain_name_of(RunKind kind);

}  // namespace nilas::compare
