#pragma once
/// The realisations that the settings of a comparison have in common.
#include <vector>

#include "apps/compare/scenes/judge/run_table.h"

namespace nilas::compare {

/// The runs of one setting that are done.
struct DoneRuns {
  std::vector<bool> done;  ///< one per realisation
  bool failed = false;     ///< a run of it failed
};

/// The realisations over which means are taken, in rising order. They can be judged, have the first setting, and have
/// at least three quarters of the settings that ran; settings with a failed run do not count. If none has so many, it
/// is the one with the most. `judged`: whether each realisation can be judged. The first condition is dropped if none
/// can, and the second if the first setting has no run there.
std::vector<int> shared_realisations(const std::vector<DoneRuns>& settings, const std::vector<bool>& judged);

/// The same of a table whose judging runs are marked.
std::vector<int> shared_of(const Plan& plan, const RunTable& rows);

}  // namespace nilas::compare
