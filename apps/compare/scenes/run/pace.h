#pragma once
/// What runs are expected to take, from what others took.
#include <map>
#include <string>

#include "apps/compare/scenes/plan/plan.h"
#include "apps/compare/scenes/run/run_result.h"

namespace nilas {

class Pace {
 public:
  /// `first`: what runs take over their estimates before any is done.
  explicit Pace(double first = 1) : first_(first) {}
  /// Takes notice of a run that is done.
  void took(const PlannedRun& run, double wall_s);
  /// Of all runs of a plan that are done.
  void took(const Plan& plan, const std::map<std::string, RunResult>& results);

  /// Wall time [s]: what runs of the same setting took in other realisations, on average; else the run's own estimate,
  /// times what runs of its kind (settings, or those that they are judged by) took over theirs so far.
  double expected_s(const PlannedRun& run) const;
  /// Wall time that is left to runs which are neither done nor failed, `jobs` at a time [s].
  double left_s(const Plan& plan, const std::map<std::string, RunResult>& results, int jobs) const;
  /// Wall time of one more realisation of all settings, `jobs` at a time [s].
  double realisation_s(const Plan& plan, int jobs) const;
  /// What runs took over their estimates, over all.
  double factor() const;

 private:
  struct Sum {
    double took = 0, estimate = 0;
    int runs = 0;
  };
  /// Runs of one setting, its twins among them, or of the reference, or of its check.
  static std::string family(const PlannedRun& run);
  static bool judges(const PlannedRun& run) { return run.kind == RunKind::reference || run.kind == RunKind::check; }

  double first_;
  std::map<std::string, Sum> families_;
  std::map<bool, Sum> kinds_;  ///< by whether others are judged by them
};

}  // namespace nilas
