#pragma once
/// How a comparison's budget goes to its runs while they are made: what begins, how long it may take, and how much
/// simulated time all of them are told over where the machine is slower than it was thought.
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "apps/compare/scenes/plan/plan.h"
#include "apps/compare/scenes/run/pace.h"

namespace nilas {

/// How a run begins.
struct RunStart {
  bool begins = true;
  bool too_slow = false;  ///< why it does not: another realisation of its setting was ended for its time
  double limit_s = 0;     ///< wall time after which it is ended; 0: none [s]
};

/// How a run ended.
struct RunEnd {
  double wall_s = 0;  ///< [s]
  bool done = false, timed_out = false;
  double reached_s = 0;                                             ///< simulated [s]
  double window_from_s = std::numeric_limits<double>::quiet_NaN();  ///< of its mean load; NaN: no load yet [s]
};

/// `start`: of the scene [s].
RunEnd run_end(const RunResult& result, double start);

/// Wall time that a new comparison needs for the first setting and one beside it over the least that a mean can be told
/// over, or over the plan's whole time where no ice was met yet; with a reserve, in two digits. `measuring_s`: what
/// went before the runs. Nothing where the run made no way.
std::optional<double> needed_budget(const Plan& plan, const RunEnd& first, double measuring_s, int jobs);

enum class RunVerdict {
  as_it_ended,
  far_enough,  ///< ended at its limit, but all are told over no more than it reached
  too_slow     ///< ended long before the budget, as it took far more than was expected of it
};

class Allotment {
 public:
  /// `budget_s`: wall time; 0: no limit. `first_pace`: what runs take over their estimates before any is done. May move
  /// the plan's end forward and add the omission that says so.
  Allotment(Plan& plan, double budget_s, double stated_budget_s, int jobs, double first_pace);
  /// Of runs of an earlier session.
  void took(const std::map<std::string, RunResult>& results);

  /// Called in the plan's order. The runs that all others are set against, and the first beside them, may take what
  /// there is, but leave room for each other.
  RunStart begin(const PlannedRun& run, double elapsed_s);
  RunVerdict ended(const PlannedRun& run, const RunEnd& end);

  /// What runs are expected to take over what remains of the simulated time.
  const Pace& pace() const { return pace_; }
  /// Wall time that a run was expected to take when it was ended as too slow [s].
  double expected_of(const std::string& id) const { return patient_.at(id); }
  double left_s(double elapsed_s) const;

 private:
  bool essential(const PlannedRun& run) const;
  double share() const;
  double expected_s(const PlannedRun& run) const { return share() * pace_.expected_s(run); }
  /// Wall time of those runs of the first realisation that have not begun.
  double missing_s(const std::function<bool(const PlannedRun&)>& counts) const;
  /// Below it no mean can be told; infinite where that is not known [s].
  double least_end() const;
  bool worth_telling(double reached_s) const;
  void shorten(double elapsed_s);
  void end_at(double t);

  Plan& plan_;
  double budget_s_, stated_budget_s_;
  int jobs_;
  double planned_end_;                                             ///< [s]
  double window_from_ = std::numeric_limits<double>::quiet_NaN();  ///< of the first setting; NaN: not known [s]
  bool pace_known_ = false;                                        ///< the first setting ran once
  bool beside_done_ = false;                                       ///< another setting is done in the first realisation
  Pace pace_;                                                      ///< as if every run went on to the planned end
  std::map<std::string, double> patient_;    ///< runs that end before the budget does, and what they should take [s]
  std::map<std::string, double> begun_end_;  ///< of runs that began, the plan's end then [s]
  std::set<std::size_t> slow_;               ///< settings that had a run which was too slow
};

}  // namespace nilas
