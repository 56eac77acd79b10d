#pragma once
/// The runs of a comparison as a table: a row per run of the plan, with what was measured of it.
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "apps/compare/scenes/plan/plan.h"
#include "apps/compare/scenes/run/load_series.h"
#include "apps/compare/scenes/run/run_result.h"

namespace nilas {

/// Largest difference of one run's motion from that of the reference of its realisation, until the horizon.
struct MotionError {
  double rms_m = 0;            ///< root of the mean squared distance over the bodies
  double largest_m = 0;        ///< distance of a body
  Vec3 axes_m = Vec3::Zero();  ///< distance of a body, per axis
  double turn_rad = 0;         ///< angle between attitudes
};

/// Parts of the estimated error of a run's mean load in the headline channel, about 95 %; NaN: not known [N]. `alone`
/// is what the run states by itself; the parts also use other runs of the comparison. Method: docs/theory/compare.md.
struct LoadErrorParts {
  double alone = 0;
  double solver = 0, law = 0, chaos = 0, step = 0;

  /// Root of chaos squared and (solver + law + step) squared, as far as they are known [N].
  double total() const;
};

struct RunRow {
  PlannedRun run;
  RunResult result;
  bool judges = false;  ///< the other runs of its realisation are judged by it
  /// Of k_course_channels over the window of its realisation; nothing where the run left no series of its load.
  std::optional<std::array<LoadStatistics, k_course_channels.size()>> loads{};
  std::optional<double> load_difference{};  ///< of the headline channel's mean from the judging run's [N]
  std::optional<double> own_difference{};   ///< from the first setting's in the same realisation [N]
  std::optional<MotionError> motion{};
  std::optional<LoadErrorParts> load_error{};

  bool is_grid(std::size_t setting) const { return run.kind == RunKind::grid && run.setting == setting; }
};

/// Sorted by kind, setting and realisation, whatever order the runs were made in.
using RunTable = std::vector<RunRow>;

RunTable run_table(const Plan& plan, const std::map<std::string, RunResult>& results);

/// A run that is done, by what it is; null where it is not.
const RunRow* done_run(const RunTable& rows, RunKind kind, std::size_t setting, int realisation);
/// The run that a realisation is judged by; null where none is done.
const RunRow* judge_of(const RunTable& rows, int realisation);

/// Statistics of a load channel: of a course channel over the window of the realisation, of others over that of the run
/// itself; all NaN where they are not known [N or N m].
const LoadStatistics& load_statistics_of(const RunRow& row, const std::string& channel);
double mean_load(const RunRow& row, const std::string& channel);

/// The channel whose mean ranks the settings: the load along the course, as `nilas run` announces it; empty where no
/// run that is done has it.
std::string headline_of(const RunTable& rows);

}  // namespace nilas
