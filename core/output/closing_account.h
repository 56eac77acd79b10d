#pragma once
/// What a run says at its end.
#include <filesystem>
#include <string>

#include "core/output/run_statistics.h"

namespace nilas {

/// Wall-clock time, where it went per phase, the worst solver residual, penetration and energy imbalance, the path of
/// the outputs. Lines of at most 80 columns, the path's excepted. `wall_s`: of the whole run.
std::string closing_account(const RunStatistics& statistics, double wall_s, const std::filesystem::path& outputs);

}  // namespace nilas
