#pragma once
/// Shares the budget of a comparison among its runs while they are made. It decides which run begins and how long it
/// may take, and shortens the simulated time over which all are compared if the machine is slower than expected.
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "apps/compare/scenes/plan/plan.h"
#include "apps/compare/scenes/run/pace.h"

namespace nilas::compare {

/// How a run begins.
struct RunStart {
  bool begins = true;
  bool too_slow = false;  ///< it does not begin, because another realisation of its setting was ended as too slow
  double limit_s = 0;     ///< wall time after which it is ended [s]; 0: none
  double expected_s = 0;  ///< expected wall time of a run that does not begin for the budget [s]
  double left_s = 0;      ///< time that the budget has left for that run [s]

  /// Whether it does not begin, although time is left, because it is expected to take more than that.
  bool too_long() const { return !begins && !too_slow && left_s > 0; }
};

/// How a run ended.
struct RunEnd {
  double wall_s = 0;  ///< wall time [s]
  bool done = false, timed_out = false;
  double reached_s = 0;  ///< simulated time that it reached [s]
  double window_from_s =
      std::numeric_limits<double>::quiet_NaN();  ///< start of its mean load's window [s]; NaN: no load yet
};

/// The end of a run from its result. `start`: start time of the scene [s].
RunEnd run_end(const RunResult& result, double start);

/// The wall time [s] that a new comparison needs for the first setting and one other, with a reserve and in two digits.
/// It is for the shortest simulated time that gives a mean, or for the plan's whole time if no ice was met yet.
/// `measuring_s`: wall time before the runs [s]. Nothing if the run did not advance.
std::optional<double> needed_budget(const Plan& plan, const RunEnd& first, double measuring_s, int jobs);

enum class RunVerdict {
  as_it_ended,
  far_enough,  ///< ended at its limit, but all runs are compared over no more than it reached
  too_slow     ///< ended long before the budget, because it took far more time than expected
};

class Allotment {
 public:
  /// `budget_s`: wall time [s]; 0: no limit. `stated_budget_s`: the budget that messages name [s]. `first_pace`: ratio
  /// of the time of runs to their estimates, before any is done. May make the plan's end earlier and add an omission
  /// for it.
  Allotment(Plan& plan, double budget_s, double stated_budget_s, int jobs, double first_pace);
  /// Takes notice of the runs of an earlier session.
  void took(const std::map<std::string, RunResult>& results);

  /// Decides how a run begins; called in the plan's order. The runs with which all others are compared, and the first
  /// other setting, may take all time that is left, but leave room for each other.
  RunStart begin(const PlannedRun& run, double elapsed_s);
  RunVerdict ended(const PlannedRun& run, const RunEnd& end);

  /// The time that runs are expected to take up to the planned end of the simulated time.
  const Pace& pace() const { return pace_; }
  /// The wall time that a run was expected to take when it was ended as too slow [s].
  double expected_of(const std::string& id) const { return patient_.at(id); }
  double left_s(double elapsed_s) const;
  /// The share of the planned simulated time over which runs are made.
  double share() const;

 private:
  /// The expected wall time of some runs, and the part of it that does not grow with the simulated time [s].
  struct Need {
    double wall_s = 0, setup_s = 0;
  };
  bool essential(const PlannedRun& run) const;
  double expected_s(const PlannedRun& run) const { return pace_.expected_s(run, share()); }
  /// The need of those runs of the first realisation that have not begun and that `counts` selects.
  Need missing(const std::function<bool(const PlannedRun&)>& counts) const;
  /// The earliest end of the simulated time that gives a mean load [s]; infinite if it is not known.
  double least_end() const;
  bool worth_telling(double reached_s) const;
  void shorten(double elapsed_s);
  void end_at(double t);

  Plan& plan_;
  double budget_s_, stated_budget_s_;
  int jobs_;
  double planned_end_;  ///< end of the simulated time as planned [s]
  double window_from_ =
      std::numeric_limits<double>::quiet_NaN();  ///< start of the first setting's window [s]; NaN: not known
  bool pace_known_ = false;                      ///< the first setting has run once
  bool beside_done_ = false;                     ///< another setting is done in the first realisation
  Pace pace_;                                    ///< times as if every run went to the planned end
  std::map<std::string, double> patient_;        ///< expected times of runs that have a limit below the budget [s]
  std::map<std::string, double> begun_end_;      ///< the plan's end at the time when each run began [s]
  std::set<std::size_t> slow_;                   ///< settings with a run that was too slow
};

}  // namespace nilas::compare
