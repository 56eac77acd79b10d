#pragma once
/// The time that runs are expected to take, from the times of others.
#include <map>
#include <string>

#include "apps/compare/scenes/plan/plan.h"
#include "apps/compare/scenes/run/run_result.h"

namespace nilas::compare {

class Pace {
 public:
  /// `first`: ratio of the time of runs to their estimates, before any is done. `setup_s`: part of each estimate that
  /// does not grow with the simulated time [s].
  explicit Pace(double first = 1, double setup_s = 0) : first_(first), setup_s_(setup_s) {}
  /// Takes notice of a run that is done over a share of the planned simulated time.
  void took(const PlannedRun& run, double wall_s, double share = 1);
  /// Takes notice of all runs of a plan that are done. Some may have gone further than the plan now ends.
  void took(const Plan& plan, const std::map<std::string, RunResult>& results);

  /// The expected wall time of a run over a share of the planned simulated time [s]. For all of it, it is the mean time
  /// of runs of the same setting in other realisations, if there are any. Else it is the run's own estimate times the
  /// ratio of time to estimate of the runs of its kind (settings, or runs by which they are judged).
  double expected_s(const PlannedRun& run, double share = 1) const;
  /// The part of it that is the set-up [s], whatever the share.
  double expected_setup_s(const PlannedRun& run) const;
  /// The expected wall time of the runs that are neither done nor failed, `jobs` at a time [s].
  double left_s(const Plan& plan, const std::map<std::string, RunResult>& results, int jobs, double share = 1) const;
  /// The expected wall time of one more realisation of all settings, `jobs` at a time [s].
  double realisation_s(const Plan& plan, int jobs, double share = 1) const;
  /// The ratio of the time of all runs so far to their estimates.
  double factor() const;

 private:
  struct Sum {
    double took = 0, estimate = 0;
    int runs = 0;
  };
  /// The name of the family of a run: one setting with its perturbed runs, the reference, or its check.
  static std::string family(const PlannedRun& run);
  static bool judges(const PlannedRun& run) { return run.kind == RunKind::reference || run.kind == RunKind::check; }
  /// The estimate of a run over a share of the planned simulated time, divided by that over all of it.
  double part(const PlannedRun& run, double share) const;
  /// The expected wall time of a run over the whole planned simulated time [s].
  double whole_s(const PlannedRun& run) const;

  double first_, setup_s_;
  std::map<std::string, Sum> families_;  ///< sums of times as if every run went over the whole planned time
  std::map<bool, Sum> kinds_;            ///< sums over the runs that judge others (true) and over the others
};

}  // namespace nilas::compare
