#pragma once
/// What one run of a comparison left, reduced to the figures that are compared.
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "apps/compare/workshop/child.h"
#include "core/output/run/run_summary.h"

namespace nilas {

struct RunResult {
  std::string status = "not run";  ///< done, failed, crashed, too slow, budget, interrupted, not run
  std::string cause;               ///< one line where it is not done
  double cpu_s = 0, wall_s = 0;
  double stabilisation_J =
      std::numeric_limits<double>::quiet_NaN();  ///< energy that the correction of penetration took out
  double penetration_mean_m = std::numeric_limits<double>::quiet_NaN();  ///< over the steps
  double first_steps_ms = 0;  ///< of the steps that the probe made too [ms]; 0: not looked at
  RunSummary summary;

  bool done() const { return status == "done"; }
  /// By itself, not because the budget or the user ended it.
  bool failed() const { return status == "failed" || status == "crashed" || status == "too slow"; }
  /// Processor time per simulated second, without reading, packing ice and output [s/s].
  double compute_per_second() const;
  /// Of one step, the same way [ms].
  double ms_per_step() const;
};

nlohmann::ordered_json to_json(const RunResult& result);
RunResult run_result_from(const nlohmann::ordered_json& json);

/// Reads what a run left in its folder, with its exit code and processor time.
RunResult read_run(const std::filesystem::path& folder, const std::filesystem::path& log, const ChildResult& ended);

/// Removes from a run folder what is large and no longer needed: all but the scene, log, summary, bodies.csv
/// and ice_load.csv.
void thin_out(const std::filesystem::path& folder);

/// When each step ended and what it took but for output; empty where the run made none.
struct StepTimes {
  std::vector<double> time_s, solver_ms, ms;  ///< one per step
};
StepTimes read_step_times(const std::filesystem::path& folder);

}  // namespace nilas
