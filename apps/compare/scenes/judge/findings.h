#pragma once
/// The findings of a comparison: the runs, the runs that judge them, how much of a difference is chance, and the error
/// and cost of each setting. Every struct is the result of one function of the structs before it; judge.cpp has the
/// order.
#include <optional>
#include <string>
#include <vector>

#include "apps/compare/scenes/judge/chance.h"
#include "apps/compare/scenes/judge/paired.h"
#include "apps/compare/scenes/judge/run_table.h"

namespace nilas::compare {

/// The runs by which the caller wants to judge.
enum class Judged {
  by_reference,     ///< the reference runs of the plan
  by_one_run,       ///< the reference runs, which are all the same run of the user
  by_first_setting  ///< the first setting, as in an ablation
};

/// The runs that all others are judged by.
struct Judges {
  RunKind kind = RunKind::reference;
  std::optional<std::size_t> setting;  ///< the setting whose runs judge, if they are of the grid
  std::string stand_in;                ///< name of the runs that replace the reference; empty: none do
  std::string trouble;                 ///< why a run of the reference is not done
  bool one_run = false;                ///< one run judges all realisations, so that its chance does not average out
  int realisations = 0;                ///< number of realisations that can be judged
};

/// The predictability horizon: the time until which the first setting and its perturbed run stay close.
struct Horizon {
  bool known = false;      ///< a perturbed run is done
  bool ends = false;       ///< it lies before the end of the runs
  double until_s = 0;      ///< time until which they are close in every realisation [s]
  double threshold_m = 0;  ///< distance from which the two count as apart [m]
};

/// The quantity whose error ranks the settings.
struct Measure {
  std::string name = "distance";  ///< load, distance or turn
  std::string unit = "m";
  double scale = 0;  ///< value of which errors in percent are shares, in the unit

  bool is_load() const { return name == "load"; }
};

/// A mean over realisations.
struct Estimate {
  double mean = 0;
  double standard_error = 0;  ///< NaN for fewer than two values
  int count = 0;
};

/// The headline channel in the judging runs, over the shared realisations [N].
struct JudgingLoads {
  Estimate mean, std, max, p99;
};

/// How much the headline channel's mean differs by chance between two runs of one realisation.
struct Chance {
  PooledVariance variance;     ///< variance of the difference [N^2]
  double run_N = 0;            ///< standard deviation of one run's mean [N]; NaN: not measured
  double difference_95_N = 0;  ///< 95 % limit of the difference [N]; NaN: not measured
};

/// How far the reference moves when its step is doubled, in the measure's unit.
struct StepCheck {
  std::optional<double> moves;  ///< change of the reference; nothing: the run that shows it is not done
  double chance = 0;            ///< two standard deviations of such a change by chance alone
  bool coarse = false;          ///< the change is larger than chance and than the smallest significant error
};

/// The figures of one setting.
struct Merit {
  std::size_t setting = 0;
  int planned = 0, done = 0, failed = 0;      ///< runs; one that the budget ended is neither done nor failed
  bool judges = false;                        ///< its runs judge the others
  std::string trouble;                        ///< the first cause why a run is not done
  std::vector<int> realisations;              ///< realisations of its means: those done and shared with others
  bool partial = false;                       ///< it lacks some of the shared realisations and is not ranked
  Estimate load;                              ///< mean of the headline channel [N]
  Estimate load_difference;                   ///< difference from the judging run in the same realisation [N]
  PairedDifference from_reference, from_own;  ///< differences of the headline channel's mean
  Estimate load_std, load_max, load_p99;      ///< standard deviation, largest and 99 % load of it [N]
  Estimate motion, turn;                      ///< largest rms distance [m] and turn [rad] from the judging run
  double penetration_max_m = 0, penetration_mean_m = 0, law_map_m_s = 0, natural_map_m_s = 0;
  double step_load_median = 0, step_load_p95 = 0;  ///< errors of the ice load of one step, the largest of all runs
  double energy_error = 0, momentum_error = 0;     ///< relative, the worst of all steps and runs
  double unconverged_share = 0;                    ///< share of steps that missed the tolerance
  double time = 0, time_spread = 0;  ///< processor time per simulated second, and the spread of such a time [s/s]
  double ms_per_step = 0;
  double error = 0, floor = 0;  ///< error and floor in the measure's unit; an error below the floor may be chance
  bool significant = false;     ///< the error lies above the floor
  bool dominated = false;       ///< another setting is no slower and no worse
  std::optional<std::size_t> faulty_part;  ///< setting with a part of its changes that is too far off
};

/// How fast an error falls with the step, the rest being the same.
struct Order {
  std::string rest;  ///< label without the step
  double order = 0;  ///< order; 0: the error does not fall
  int steps = 0;
};

/// How well estimates of errors agree with errors that were measured.
struct Coverage {
  int runs = 0;
  double share = 0;  ///< share of runs whose measured error lies within the estimate
  double width = 0;  ///< median of the ratio of estimate to measured error
};

/// The recommended setting, and faster ones that are not recommended.
struct Choice {
  std::optional<std::size_t> chosen;   ///< fastest setting within k_target of the reference, or within the floor
  std::optional<std::size_t> faster;   ///< fastest of those as accurate, but not significantly faster than `chosen`
  std::optional<std::size_t> deeper;   ///< faster still and as accurate, but with far deeper penetration
  std::optional<std::size_t> by_luck;  ///< the fastest of those as accurate, but with a faulty part
};

struct Findings {
  RunTable rows;
  Judges judges;
  std::string headline;     ///< channel; empty without a vessel
  std::vector<int> shared;  ///< realisations over which the settings' means are taken
  bool same_ice = false;    ///< all shared realisations begin with bodies in the same places
  std::vector<std::optional<output::LoadSpan>> windows;  ///< one per realisation; nothing if no run of it is done
  Horizon horizon;
  Measure measure;
  JudgingLoads reference;
  Chance chance;
  StepCheck check;
  double common_floor = 0;    ///< floor of a setting that scatters as the others do; infinite: not measured
  double time_spread = 0;     ///< relative standard deviation of the times of similar runs; NaN: not measured
  std::vector<Merit> merits;  ///< one per setting of the plan
  std::vector<Order> orders;
  std::optional<Coverage> coverage,
      coverage_alone;  ///< coverage of the load-error estimates: all parts, and each run alone
  Choice choice;
};

/// The share of the scale up to which an error is small enough.
constexpr double k_target = 0.02;
/// The share of the scale that rounding alone can make.
constexpr double k_rounding_share = 1e-12;

/// The mean and standard error of independent values; the mean of none is NaN.
Estimate estimate_of(const std::vector<double>& values);

}  // namespace nilas::compare
