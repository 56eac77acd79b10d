#pragma once
/// What a comparison finds: the runs, what they are judged by, how much of a difference is chance, and per setting its
/// error and cost. Every struct is the result of one function of the tables before it; judge.h gives their order.
#include <optional>
#include <string>
#include <vector>

#include "apps/compare/scenes/judge/chance.h"
#include "apps/compare/scenes/judge/paired.h"
#include "apps/compare/scenes/judge/run_table.h"

namespace nilas {

/// What the caller asks to judge by.
enum class Judged {
  by_reference,     ///< the reference runs of the plan
  by_one_run,       ///< the same, which are all one run of the user's
  by_first_setting  ///< the first setting, as in an ablation
};

/// The runs that all others are judged by.
struct Judges {
  RunKind kind = RunKind::reference;
  std::optional<std::size_t> setting;  ///< whose runs judge, where they are of the grid
  std::string stand_in;                ///< what judges where no reference run is done; empty: what was asked for
  std::string trouble;                 ///< why a run of the reference is not done
  bool one_run = false;                ///< one run judges all realisations, so that its chance does not average out
  int realisations = 0;                ///< that can be judged
};

/// How long motions can be predicted: until the first setting and its perturbed run part.
struct Horizon {
  bool known = false;      ///< a perturbed run is done
  bool ends = false;       ///< before the runs do
  double until_s = 0;      ///< in every realisation [s]
  double threshold_m = 0;  ///< distance from which the two are called apart
};

/// The quantity whose error ranks the settings.
struct Measure {
  std::string name = "distance";  ///< load, distance or turn
  std::string unit = "m";
  double scale = 0;  ///< that errors in percent are shares of, in the unit

  bool is_load() const { return name == "load"; }
};

/// A mean over realisations.
struct Estimate {
  double mean = 0;
  double standard_error = 0;  ///< NaN of fewer than two
  int count = 0;
};

/// The headline channel in the judging runs, over the shared realisations [N].
struct ReferenceLoads {
  Estimate mean, std, max, p99;
};

/// How much the headline channel's mean differs by chance between two runs of one realisation.
struct Chance {
  PooledVariance variance;     ///< of the difference [N^2]
  double run_N = 0;            ///< standard deviation of one run's mean; NaN: not measured
  double difference_95_N = 0;  ///< limit of the difference, 95 %; NaN: not measured
};

/// How far the reference moves when its step is doubled, in the measure's unit.
struct StepCheck {
  std::optional<double> moves;  ///< nothing: the run that shows it is not done
  double chance = 0;            ///< what chance alone moves it by, two standard deviations
  bool coarse = false;          ///< it moves by more than the smallest significant error
};

/// One setting.
struct Merit {
  std::size_t setting = 0;
  int planned = 0, done = 0, failed = 0;      ///< runs; one that the budget ended counts as neither done nor failed
  bool judges = false;                        ///< the others are judged by it
  std::string trouble;                        ///< the first cause why a run is not done
  std::vector<int> realisations;              ///< that its figures are means over: done, and shared with others
  bool partial = false;                       ///< it lacks some of the shared realisations and is not ranked
  Estimate load;                              ///< mean of the headline channel [N]
  Estimate load_difference;                   ///< from the judging run, realisation by realisation [N]
  PairedDifference from_reference, from_own;  ///< of the headline channel's mean
  Estimate load_std, load_max, load_p99;      ///< of the same channel [N]
  Estimate motion, turn;                      ///< largest rms distance [m] and turn [rad] from the judging run
  double penetration_max_m = 0, penetration_mean_m = 0, law_map_m_s = 0, natural_map_m_s = 0;
  double energy_error = 0, momentum_error = 0;  ///< relative, the worst of all steps and runs
  double unconverged_share = 0;                 ///< of steps
  double time = 0, time_spread = 0;  ///< processor time per simulated second, and the spread of such a time [s/s]
  double ms_per_step = 0;
  double error = 0, floor = 0;  ///< of the measure; an error below the floor may be chance
  bool significant = false;     ///< the error lies above the floor
  bool dominated = false;       ///< another setting is no slower and no worse
};

/// How fast an error falls with the step, the rest being the same.
struct Order {
  std::string rest;  ///< label without the step
  double order = 0;  ///< 0: it does not
  int steps = 0;
};

/// How well estimates hold against errors that were measured.
struct Coverage {
  int runs = 0;
  double share = 0;  ///< of runs whose measured error lies within the estimate
  double width = 0;  ///< median of estimate over measured error
};

/// Settings that are worth their time.
struct Choice {
  std::optional<std::size_t> chosen;  ///< fastest setting within k_target of the reference, or within the floor
  std::optional<std::size_t> deeper;  ///< faster still and as accurate, but with far deeper penetration
};

struct Findings {
  RunTable rows;
  Judges judges;
  std::string headline;     ///< channel; empty without a vessel
  std::vector<int> shared;  ///< realisations that figures of settings are means over
  bool same_ice = false;    ///< all of them begin with bodies in the same places: the scene draws nothing
  std::vector<std::optional<LoadSpan>> windows;  ///< one per realisation; nothing where no run of it is done
  Horizon horizon;
  Measure measure;
  ReferenceLoads reference;
  Chance chance;
  StepCheck check;
  double common_floor = 0;    ///< of a setting that scatters as the others do; infinite: not measured
  double time_spread = 0;     ///< relative standard deviation of times of alike runs; NaN: not measured
  std::vector<Merit> merits;  ///< one per setting of the plan
  std::vector<Order> orders;
  std::optional<Coverage> coverage, coverage_alone;  ///< of load errors with all parts, and as each run states alone
  Choice choice;
};

/// An error up to this share of the scale is called close enough.
constexpr double k_target = 0.02;
/// Rounding alone can make this share of the scale.
constexpr double k_rounding_share = 1e-12;

/// Mean and standard error of independent values; the mean of none is NaN.
Estimate estimate_of(const std::vector<double>& values);

}  // namespace nilas
