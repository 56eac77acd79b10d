#pragma once
/// The result of one run of a comparison, reduced to the figures that are compared.
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "apps/compare/workshop/child.h"
#include "core/output/run/run_summary.h"

namespace nilas::compare {

struct RunResult {
  std::string status = "not run";  ///< done, failed, crashed, too slow, budget, interrupted, not run
  std::string cause;               ///< one line about why it is not done
  double cpu_s = 0, wall_s = 0;
  double stabilisation_J =
      std::numeric_limits<double>::quiet_NaN();  ///< energy that the correction of penetration removed [J]
  double penetration_mean_m = std::numeric_limits<double>::quiet_NaN();  ///< mean penetration over the steps [m]
  double first_steps_ms = 0;  ///< time of the steps that the probe made too [ms]; 0: not measured
  output::RunSummary summary;

  bool done() const { return status == "done"; }
  /// Whether it failed, crashed or was too slow. A run that the budget or the user ended has not failed.
  bool failed() const { return status == "failed" || status == "crashed" || status == "too slow"; }
  /// Processor time per simulated second, without reading, packing ice and output [s/s].
  double compute_per_second() const;
  /// Processor time of one step, without reading, packing ice and output [ms].
  double ms_per_step() const;
};

nlohmann::ordered_json to_json(const RunResult& result);
RunResult run_result_from(const nlohmann::ordered_json& json);

/// Reads the result of a run from its folder, with its exit code and processor time.
RunResult read_run(const std::filesystem::path& folder, const std::filesystem::path& log, const ChildResult& ended);

/// Puts on the disk what a comparison reads again from the folder of a run that is done, so that its result is not
/// there alone after a loss of power. Throws FileError.
void put_on_disk(const std::filesystem::path& folder);
/// Removes from a run folder what is large and no longer needed: all but the scene with its inputs, the log,
/// summary.json, bodies.csv and ice_load.csv.
void thin_out(const std::filesystem::path& folder);

/// The end of each step and its times; empty if the run made no step.
struct StepTimes {
  std::vector<double> time_s, solver_ms, ms;  ///< ends [s], solver times and step times without output [ms]
  std::vector<double> output_ms;              ///< times of writing [ms]
};
StepTimes read_step_times(const std::filesystem::path& folder);

}  // namespace nilas::compare
