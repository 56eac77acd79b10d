#pragma once
/// The figures of summary.json that a program reads back to compare or continue runs.
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contact/measure/measure.h"
#include "core/output/loads/load_statistics.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

/// The time over which mean loads are taken.
struct LoadSpan {
  double from = 0, to = 0;  ///< [s]
  std::string reason;       ///< reason for its begin, as the end of a sentence
  bool operator==(const LoadSpan&) const = default;
};

/// The run's own estimate of the error of a channel's mean load, about 95 %; NaN: not known [N or N m].
struct LoadErrorFigures {
  double estimate = std::numeric_limits<double>::quiet_NaN();  ///< all errors combined
  double solver = estimate, law = estimate, chaos = estimate;
};

/// Figures of a run's summary. A missing figure is NaN, 0 or empty, as stated.
struct RunSummary {
  static constexpr double k_none = std::numeric_limits<double>::quiet_NaN();

  std::string scene;                                  ///< name of the scene
  std::string status;                                 ///< done, failed, interrupted; empty: there is no summary
  std::string ended_early;                            ///< reason why a completed run did not reach its end time
  std::optional<std::uint64_t> seed;                  ///< seed of the scene
  double time_end_s = k_none, steps = k_none;         ///< simulated time [s] and number of steps
  double wall_s = k_none, real_time_factor = k_none;  ///< wall time and speed of the whole run
  double floes_end = k_none;                          ///< number of free floes at the end
  double unconverged_steps = k_none;                  ///< steps whose solution missed its tolerance
  double penetration_max_m = k_none;                  ///< worst of all steps, like the four below
  double imbalance_relative = k_none;                 ///< energy error over the energy put in
  double momentum_imbalance_relative = k_none;
  double step_load_median = k_none, step_load_p95 = k_none;  ///< errors of the ice load of one step, as shares of it
  contact::Residuals residuals = no_residuals();
  std::array<double, sim::k_num_phases> phase_ms =
      no_phases();                 ///< mean over the steps, 0 for a phase without work [ms]
  std::optional<LoadSpan> window;  ///< window of the vessel's loads
  std::optional<bool> touched;     ///< whether ice touched the vessel; empty without a vessel
  std::vector<std::pair<std::string, LoadStatistics>> loads;  ///< by channel, in the order of vessel.csv [N or N m]
  std::map<std::string, LoadErrorFigures> load_errors;        ///< error estimates by channel

  bool exists() const { return !status.empty(); }
  /// Statistics of a channel; null where the run has no such channel.
  const LoadStatistics* load(const std::string& channel) const;

 private:
  static contact::Residuals no_residuals();
  static std::array<double, sim::k_num_phases> no_phases();
};

/// Figures of a summary by summary_json(), or of an excerpt. Missing figures and those of another type are not known.
RunSummary run_summary_from(const nlohmann::ordered_json& summary);
/// The excerpt of summary.json that holds these figures, under the same keys.
nlohmann::ordered_json to_json(const RunSummary& summary);

/// Reads summary.json of a run folder. `status` is empty where the file is missing or no JSON.
RunSummary read_run_summary(const std::filesystem::path& run_folder);

}  // namespace nilas::output
