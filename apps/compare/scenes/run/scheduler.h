#pragma once
/// Makes the runs of a comparison, several at a time, within its budget.
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "apps/compare/scenes/run/allotment.h"
#include "apps/compare/scenes/run/scene_store.h"
#include "apps/compare/workshop/narrator.h"

namespace nilas {

/// What a session of runs left.
struct SessionEnd {
  std::map<std::string, RunResult> results;  ///< of all sessions, by run
  std::vector<std::string> late;             ///< runs that the budget left no time to begin or to end
  std::string file_error;                    ///< what could not be written, which ended the session
  double runs_begun_s = 0;                   ///< since the budget began [s]
  double busy_s = 0, pool_s = 0;             ///< wall time of the runs, and of all of them together [s]
  double left_s = 0;                         ///< expected wall time of the planned runs that are missing [s]
  double realisation_s = 0;                  ///< expected wall time of one realisation of all settings [s]
};

/// Words of the report that the scheduler needs while runs are made.
struct RunWords {
  std::function<std::string(const PlannedRun&)> label;
  /// States that all runs are compared over less simulated time than until `before`.
  std::function<std::string(const Plan&, double before, double factor)> shorter;
};

/// Makes the runs of the plan that `done` lacks. May move the plan's end forward, which is written to the store.
/// `started_s`: when the budget began, by steady_seconds().
SessionEnd make_runs(SceneStudy& study, const SceneStore& store, std::map<std::string, RunResult> done,
                     double started_s, const Narrator& narrator, const RunWords& words,
                     const std::function<bool()>& stop);

/// Makes runs that an earlier session ended as too slow possible again.
void forget_slow_runs(const SceneStudy& study, const SceneStore& store);

}  // namespace nilas
