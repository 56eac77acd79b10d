#pragma once
/// The runs of a comparison as a table: a row per run of the plan, with its measured figures.
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "apps/compare/scenes/plan/plan.h"
#include "apps/compare/scenes/run/load_series.h"
#include "apps/compare/scenes/run/run_result.h"

namespace nilas::compare {

/// The largest difference of a run's motion from that of the judging run of its realisation, until the horizon.
struct MotionError {
  double rms_m = 0;            ///< root mean square distance over the bodies
  double largest_m = 0;        ///< distance of a body
  Vec3 axes_m = Vec3::Zero();  ///< distance of a body, per axis
  double turn_rad = 0;         ///< angle between attitudes
};

/// The parts of the estimated error of a run's mean load in the headline channel, about 95 % [N]; NaN: not known.
/// `alone` is the estimate that the run states by itself; the parts also use other runs of the comparison. Method:
/// docs/theory/compare.md.
struct LoadErrorParts {
  double alone = 0;
  double solver = 0, law = 0, chaos = 0, step = 0;

  /// The square root of chaos^2 + (solver + law + step)^2, as far as they are known [N].
  double total() const;
};

struct RunRow {
  PlannedRun run;
  RunResult result;
  bool judges = false;  ///< it judges the other runs of its realisation
  /// Statistics of k_course_channels over the window of its realisation [N]; nothing if the run left no load series.
  std::optional<std::array<output::LoadStatistics, k_course_channels.size()>> loads{};
  std::optional<double> load_difference{};  ///< mean of the headline channel minus that of the judging run [N]
  std::optional<double> own_difference{};   ///< mean of the headline channel minus that of the first setting [N]
  std::optional<MotionError> motion{};
  std::optional<LoadErrorParts> load_error{};

  bool is_grid(std::size_t setting) const { return run.kind == RunKind::grid && run.setting == setting; }
};

/// The rows, sorted by kind, setting and realisation.
using RunTable = std::vector<RunRow>;

RunTable run_table(const Plan& plan, const std::map<std::string, RunResult>& results);

/// The run of this kind, setting and realisation if it is done; else null.
const RunRow* done_run(const RunTable& rows, RunKind kind, std::size_t setting, int realisation);
/// The run that judges a realisation; null if none is done.
const RunRow* judge_of(const RunTable& rows, int realisation);

/// The statistics of a load channel [N] or [N m]; NaN if they are not known. Those of a course channel are over the
/// window of the realisation, those of others over that of the run itself.
const output::LoadStatistics& load_statistics_of(const RunRow& row, const std::string& channel);
double mean_load(const RunRow& row, const std::string& channel);

/// The channel whose mean ranks the settings: the load along the course, which `nilas run` reports; empty if no run
/// that is done has it.
std::string headline_of(const RunTable& rows);

}  // namespace nilas::compare
