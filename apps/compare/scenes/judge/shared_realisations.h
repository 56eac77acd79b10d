#pragma once
/// Which realisations the settings of a comparison have in common.
#include <vector>

#include "apps/compare/scenes/judge/run_table.h"

namespace nilas {

/// What is done of one setting.
struct DoneRuns {
  std::vector<bool> done;  ///< one per realisation
  bool failed = false;     ///< a run of it ended by itself, without its result
};

/// The realisations that means are taken over, in rising order: those that can be judged, have the first setting, and
/// have at least three quarters of all settings that ran (one that failed does not take a realisation from the others).
/// Where none has as many, the one with the most. `judged`: per realisation; where none is, all count, and so where the
/// first setting has no run.
std::vector<int> shared_realisations(const std::vector<DoneRuns>& settings, const std::vector<bool>& judged);

/// The same of a table whose judging runs are marked.
std::vector<int> shared_of(const Plan& plan, const RunTable& rows);

}  // namespace nilas
