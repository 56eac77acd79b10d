#pragma once
/// The result of a comparison in words.
#include <string>
#include <vector>

#include "apps/compare/scenes/report/scene_report.h"

namespace nilas {

/// The answer: which setting gives the measured quantity within its stated error, and at what cost; of an ablation what
/// each simplification changes. Why nothing can be compared, where that is so.
std::vector<std::string> answer_lines(const SceneReport& report);
/// What else the runs show: accuracy of peaks, significant differences, horizon, error estimates, orders.
std::vector<std::string> detail_lines(const SceneReport& report);
/// What limits the result, and what is not done and why.
std::vector<std::string> caveat_lines(const SceneReport& report);
/// All of it for a terminal, a line per sentence; commands begin with two blanks.
std::string report_text(const SceneReport& report);

}  // namespace nilas
