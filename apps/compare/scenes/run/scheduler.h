#pragma once
/// Makes the runs of a comparison, several at a time, within its budget.
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "apps/compare/scenes/run/allotment.h"
#include "apps/compare/scenes/run/scene_store.h"
#include "apps/compare/workshop/narrator.h"

namespace nilas::compare {

/// The results of a session of runs.
struct SessionEnd {
  std::map<std::string, RunResult> results;  ///< results of all sessions, by run
  std::vector<std::string> late;             ///< runs for which the budget had no time
  std::vector<std::string> too_long;         ///< those of them that were expected to take more than was left
  std::string file_error;                    ///< the file error that ended the session; empty: none
  double runs_begun_s = 0;                   ///< time from the start of the budget to the first run [s]
  double busy_s = 0, pool_s = 0;             ///< sum of the runs' wall times, and wall time of the session's runs [s]
  double left_s = 0;                         ///< expected wall time of the planned runs that are missing [s]
  double realisation_s = 0;                  ///< expected wall time of one realisation of all settings [s]
};

/// Texts of the report that the scheduler needs while runs are made.
struct RunWords {
  std::function<std::string(const PlannedRun&)> label;
  /// States that all runs are compared over less simulated time than until `before`.
  std::function<std::string(const Plan&, double before, double factor)> shorter;
};

/// Makes the runs of the plan that `done` lacks. May make the plan's end earlier, which is written to the store.
/// `started_s`: start of the budget, on the clock of steady_seconds() [s].
SessionEnd make_runs(SceneStudy& study, const SceneStore& store, std::map<std::string, RunResult> done,
                     double started_s, const Narrator& narrator, const RunWords& words,
                     const std::function<bool()>& stop);

/// Removes the results of runs that an earlier session ended as too slow, so that they are made again.
void forget_slow_runs(const SceneStudy& study, const SceneStore& store);

}  // namespace nilas::compare
