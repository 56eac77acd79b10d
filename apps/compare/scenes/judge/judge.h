#pragma once
/// Judges the settings of a comparison by its runs.
#include <filesystem>
#include <map>
#include <string>

#include "apps/compare/scenes/judge/findings.h"

namespace nilas::compare {

/// The findings from the runs that are done. `folder`: folder of the comparison, in which runs/<id>/ hold motions
/// (bodies.csv) and load series (ice_load.csv). Throws FileError.
Findings judge_runs(const Plan& plan, const std::map<std::string, RunResult>& results,
                    const std::filesystem::path& folder, Judged judged);

}  // namespace nilas::compare
