#pragma once
/// The result of a comparison in words.
#include <string>
#include <vector>

#include "apps/compare/scenes/report/scene_report.h"

namespace nilas::compare {

/// The answer: which setting gives the measured quantity within the stated error, and at what cost; for an ablation,
/// what each simplification changes. If nothing can be compared, the answer is why.
std::vector<std::string> answer_lines(const SceneReport& report);
/// Further results: accuracy of peaks, significant differences, horizon, error estimates, orders.
std::vector<std::string> detail_lines(const SceneReport& report);
/// The limits of the result, and what is not done and why.
std::vector<std::string> caveat_lines(const SceneReport& report);
/// All of them and the outlook for a terminal, a line per sentence. Commands begin with two blanks.
std::string report_text(const SceneReport& report);

}  // namespace nilas::compare
