#pragma once
/// What the runs of a comparison say of each setting: errors that mean something, and what they cost.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "apps/compare/scenes/judge/chance.h"
#include "apps/compare/scenes/judge/paired.h"
#include "apps/compare/scenes/plan/plan.h"
#include "apps/compare/scenes/run/load_series.h"
#include "apps/compare/scenes/run/run_result.h"

namespace nilas {

/// Of one run against the reference of its realisation, over what can be predicted.
struct MotionError {
  double rms_m = 0, largest_m = 0;  ///< largest of all samples
  Vec3 axes_m = Vec3::Zero();       ///< largest per axis
  double turn_rad = 0;
};

/// What a run is said to be off in the headline channel's mean, about 95 % [N]; docs/theory/compare.md. `alone` are the
/// run's own words; the parts hold besides what other runs of the comparison tell. NaN: not known.
struct LoadErrorParts {
  double alone = 0;  ///< as the run says by itself
  double solver = 0, law = 0, chaos = 0, step = 0;

  /// Root of chaos squared and (solver + law + step) squared, as far as they are known.
  double total() const;
};

/// How well estimates hold against errors that were measured.
struct Coverage {
  int runs = 0;
  double share = 0;  ///< of runs whose measured error lies within the estimate
  double width = 0;  ///< median of estimate over measured error
};

/// One run with all that is told of it.
struct RunRow {
  PlannedRun run;
  RunResult result;
  bool judges = false;  ///< the other runs of its realisation are judged by it
  std::optional<MotionError> motion{};
  std::optional<LoadErrorParts> load_error{};
  std::optional<double> load_difference{};  ///< of the headline channel's mean from the reference's [N]
  std::optional<double> own_difference{};   ///< from the first setting's in the same realisation [N]
  /// Of k_course_channels over the window of its realisation; nothing where the run left no course of its load.
  std::optional<std::array<LoadStatistics, k_course_channels.size()>> loads{};
};

/// Over which all runs of a realisation are summed up.
struct LoadSpan {
  double from = 0, to = 0;  ///< [s]
  std::string reason;       ///< why it begins where it does, as the end of a sentence
};

/// A mean over realisations.
struct Estimate {
  double mean = 0;
  double standard_error = 0;  ///< NaN of fewer than two
  int count = 0;
};

struct Merit {
  std::size_t setting = 0;
  int planned = 0, done = 0, failed = 0;      ///< runs; what did not begin or was ended by the budget is neither
  bool judges = false;                        ///< the others are judged by it
  std::string trouble;                        ///< the first cause why a run is not done
  std::vector<int> realisations;              ///< that its figures are means over: done, and shared with others
  bool partial = false;                       ///< it has some of the shared realisations, not all: not to be ranked
  Estimate load;                              ///< mean of the headline channel [N]
  Estimate load_difference;                   ///< from the reference, realisation by realisation [N]
  PairedDifference from_reference, from_own;  ///< of the headline channel's mean
  Estimate load_std, load_max, load_p99;      ///< of the same channel [N]
  Estimate motion, turn;                      ///< largest rms distance [m] and turn [rad] from the reference
  double penetration_max_m = 0, penetration_mean_m = 0, law_map_m_s = 0, natural_map_m_s = 0;
  double energy_error = 0, momentum_error = 0;  ///< relative, the worst of all steps and runs
  double unconverged_share = 0;                 ///< of steps
  double time = 0, time_spread = 0;  ///< processor time per simulated second, and the spread of such a time [s/s]
  double ms_per_step = 0;
  double error = 0, floor = 0;  ///< of the primary measure; differences below the floor are not called errors
  bool told = false;            ///< the error lies above the floor
  bool dominated = false;       ///< another setting is no slower and no worse
};

/// How fast an error falls with the step, the rest being the same.
struct Order {
  std::string rest;  ///< label without the step
  double order = 0;  ///< 0: it does not
  int steps = 0;
};

struct Findings {
  std::string headline;     ///< channel; empty without a vessel
  std::vector<int> shared;  ///< realisations that figures of settings are means over
  bool same_ice = false;    ///< all of them begin with bodies in the same places: the scene draws nothing
  std::vector<std::optional<LoadSpan>> windows;  ///< one per realisation; nothing where no run of it is done
  std::string measure, unit;                     ///< of the primary error: load, distance or turn
  double scale = 0;                              ///< that errors in percent are shares of
  double reference_load = 0;                     ///< [N]
  Estimate reference_mean, reference_std, reference_max, reference_p99;  ///< of the runs that judge [N]
  int references_done = 0;                                               ///< realisations that can be judged
  double chaos = 0;            ///< standard deviation of a run's mean load by chance; NaN: not measured [N]
  PooledVariance chance;       ///< of the difference of two runs of one realisation [N^2]
  bool one_reference = false;  ///< all realisations are judged by one run, whose chance does not average out
  double horizon_s = 0;        ///< until which every realisation can be predicted
  bool horizon_known = false;  ///< a twin is done; else nothing is told from chaos
  bool horizon_ends = false;   ///< before the runs do
  double horizon_threshold_m = 0;
  std::optional<double> reference_moves;  ///< when its step is doubled, in the primary measure
  double reference_chance = 0;            ///< what chaos alone moves it by, two standard deviations
  std::string stand_in;                   ///< what is judged by where no reference run is done; empty: the reference
  std::string reference_trouble;          ///< why a run of the reference is not done
  double common_floor = 0;                ///< of a setting that scatters as the others do; infinite: not measured
  bool reference_coarse = false;          ///< it moves by more than the smallest error told
  double time_spread = 0;                 ///< relative standard deviation of times of alike runs
  double slowdown = 1;                    ///< of a run by its neighbours, same steps; NaN: not measured
  std::vector<RunRow> rows;
  std::vector<Merit> merits;  ///< one per setting of the plan
  std::vector<Order> orders;
  std::optional<Coverage> coverage, coverage_alone;  ///< of load errors with all parts, and as runs say by themselves
  std::optional<std::size_t> chosen;  ///< fastest setting within k_target of the reference or what can be told
  std::optional<std::size_t> deeper;  ///< faster still and as accurate, but lets bodies too deep into each other
};

/// Standard error: of as many independent values; NaN of fewer than two, and the mean of none.
Estimate estimate_of(const std::vector<double>& values);

/// The run that a realisation is judged by; null where none is done.
const RunRow* reference_of(const Findings& found, int realisation);

/// A run that is done, by what it is; null where it is not.
const RunRow* done_run(const Findings& found, RunKind kind, std::size_t setting, int realisation);

/// mean, std, max or p99 of a load channel: of a course channel over the window of the realisation, of others over that
/// of the run itself; NaN where it is not known [N or N m].
double load_statistic(const RunRow& row, const std::string& channel, const std::string& statistic);

/// Limit below which a difference from the reference over so many realisations is not told, with 95 % [N]; infinite
/// without degrees of freedom. `reference`: the part of the variance that does not average out [N^2].
double floor_of(double variance, double degrees, int realisations, double reference);

/// What is called close enough, of the scale.
constexpr double k_target = 0.02;
/// What rounding alone can be, of the scale.
constexpr double k_rounding_share = 1e-12;

/// What runs are judged by.
enum class Judged { by_reference, by_one_run, by_first_setting };

/// Judges by the runs that are done. `folder`: where their motions lie, runs/<id>/bodies.csv. `by_one_run`: the
/// reference runs are all the same one.
Findings find(const Plan& plan, const std::map<std::string, RunResult>& results, const std::filesystem::path& folder,
              Judged judged);

}  // namespace nilas
