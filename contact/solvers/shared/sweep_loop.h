#pragma once
/// What all Gauss-Seidel sweeps share: the loop around them, the residual that stops it, and the impulses kept.
#include <algorithm>

#include "contact/solvers/shared/progress.h"
#include "contact/solvers/shared/row_islands.h"

namespace nilas {

struct SweepSettings {
  SolverSettings shared;
  bool symmetric_sweeps = false;  ///< every second sweep runs backwards
  int stall_sweeps = 500;  ///< stalled: law_map fell by less than 0.1 % in this many sweeps (and one per contact)
};

/// An island of a problem with bodies, its impulses in the rows.
class RowSweeps {
 public:
  explicit RowSweeps(const RowIsland& whole);
  double law_map() const;  ///< [m/s]
  /// After law_map: drops the rounding that the sweeps have gathered.
  void correct() { residual_.correct(rows_, island_); }
  void save();
  void restore();
  bool finite() const;  ///< the impulses

 protected:
  PgsRows& rows_;
  const PgsIsland& island_;
  RowResidual& residual_;

 private:
  double* saved_at(int k) { return saved_.data() + 3 * static_cast<std::ptrdiff_t>(k - island_.first); }
  std::vector<double> saved_;
};

/// An island of a local problem, velocities gathered row by row.
class LocalSweeps {
 public:
  LocalSweeps(const LocalProblem& problem, const VecX& guess);
  double law_map() const;  ///< [m/s]
  void correct() {}
  void save() { saved_ = r_; }
  void restore() { r_ = saved_; }
  bool finite() const { return r_.allFinite(); }
  const VecX& impulses() const { return r_; }

 protected:
  Vec3 velocity(int c) const;  ///< (W r + q) of contact c

  const LocalProblem& problem_;
  std::vector<ContactScale> scales_;
  VecX r_;

 private:
  VecX saved_;
};

/// Sweeps until the residual is small enough or falls no more; ends with the best impulses that were measured. With
/// tolerance 0 nothing is measured. Sweeps: RowSweeps or LocalSweeps with sweep(backward) -> largest change [m/s].
template <class Sweeps>
ContactSolution sweep_to_tolerance(Sweeps& sweeps, int contacts, const SweepSettings& settings) {
  const SolverSettings& shared = settings.shared;
  ContactSolution outcome;
  outcome.status = SolveStatus::iteration_limit;
  Progress progress(shared, std::max(settings.stall_sweeps, contacts));
  bool saved_is_current = false;
  while (outcome.status == SolveStatus::iteration_limit && !progress.out_of_budget(outcome.iterations)) {
    const bool backward = settings.symmetric_sweeps && outcome.iterations % 2 == 1;
    const double change = sweeps.sweep(backward);
    ++outcome.iterations;
    saved_is_current = false;
    if (shared.keep_history) outcome.history.push_back(sweeps.law_map());
    if (!progress.measurement_due(outcome.iterations, change)) continue;
    outcome.status = progress.judge(outcome.iterations, change, sweeps.law_map());
    sweeps.correct();
    saved_is_current = progress.improved();
    if (saved_is_current) sweeps.save();
  }
  if (shared.tolerance > 0 && !saved_is_current) {
    const double last = sweeps.law_map();
    if (!(last <= progress.best())) sweeps.restore();
    if (last <= shared.tolerance) outcome.status = SolveStatus::converged;
  }
  if (!sweeps.finite()) {  // with tolerance 0 nobody looked
    sweeps.restore();
    outcome.status = SolveStatus::numerical_error;
  }
  if (outcome.status == SolveStatus::numerical_error) outcome.message = "the impulses grew beyond all numbers";
  return outcome;
}

/// Solves a local problem with sweeps made by Sweeps(island, guess).
template <class Sweeps>
ContactSolution solve_by_sweeps(const LocalProblem& problem, const VecX& guess, const SweepSettings& settings) {
  SweepSettings running = settings;
  running.shared = settings.shared.started();
  return solve_islands(problem, guess, [&](const LocalProblem& island, const VecX& start) {
    Sweeps sweeps(island, start);
    ContactSolution solution = sweep_to_tolerance(sweeps, island.num_contacts(), running);
    solution.r = sweeps.impulses();
    const std::string culprit = find_culprit(island, solution.r, settings.shared.tolerance);
    if (!culprit.empty()) {
      solution.status = SolveStatus::numerical_error;
      solution.message = culprit;
    }
    return solution;
  });
}

}  // namespace nilas
