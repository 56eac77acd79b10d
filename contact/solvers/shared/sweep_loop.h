#pragma once
/// The loop around all Gauss-Seidel sweeps, and the residual that stops it.
#include <algorithm>
#include <limits>

#include "contact/solvers/shared/measured_loop.h"
#include "contact/solvers/shared/row_islands.h"

namespace nilas::solvers {

struct SweepSettings {
  contact::SolverSettings shared;
  bool symmetric_sweeps = false;  ///< every second sweep runs backwards
  int stall_sweeps = 500;  ///< window of the stall rule (best_impulses.h), at least one sweep per contact; share 0.999
  bool has_momentum = false;  ///< sweeps of a problem with bodies by nsgs begin with momentum (sweep_momentum.h)
  int horizon = 0;  ///< sweeps end where they promise to take more than these (measured_loop.h); 0: they go on
};

/// An island of a problem with bodies, its impulses in the rows.
class RowSweeps {
 public:
  explicit RowSweeps(const RowIsland& whole);
  double law_map() const;  ///< [m/s]
  /// Removes the rounding that the sweeps have gathered; to be called after law_map.
  void correct() { residual_.correct(rows_, island_); }
  VecX impulses() const;
  void set_impulses(const VecX& r);

 protected:
  PgsRows& rows_;
  const PgsIsland& island_;
  RowResidual& residual_;
};

/// An island of a local problem, velocities gathered row by row.
class LocalSweeps {
 public:
  LocalSweeps(const contact::LocalProblem& problem, const VecX& guess);
  double law_map() const;  ///< [m/s]
  void correct() {}
  const VecX& impulses() const { return r_; }

 protected:
  Vec3 velocity(int c) const;  ///< (W r + q) of contact c

  const contact::LocalProblem& problem_;
  std::vector<contact::ContactScale> scales_;
  VecX r_;
};

/// Sweeps until the residual is small enough or falls no more. r: the best impulses that were measured. Sweeps:
/// RowSweeps or LocalSweeps with sweep(backward) -> largest change [m/s].
template <class Sweeps>
contact::ContactSolution sweep_to_tolerance(Sweeps& sweeps, int contacts, const SweepSettings& settings,
                                            const Budget& budget) {
  MeasuredLoop loop(settings.shared, budget, std::max(settings.stall_sweeps, contacts), settings.horizon);
  const auto measured = [&] {
    const double law_map = sweeps.law_map();
    sweeps.correct();
    return law_map;
  };
  const auto impulses = [&] { return sweeps.impulses(); };
  double change = std::numeric_limits<double>::infinity();
  while (loop.goes_on(change, measured, impulses)) {
    change = sweeps.sweep(settings.symmetric_sweeps && loop.iterations() % 2 == 0);
    if (settings.shared.keep_history) loop.note(sweeps.law_map());
  }
  return loop.solution(measured, impulses);
}

/// Solves a local problem with sweeps made by Sweeps(island, guess).
template <class Sweeps>
contact::ContactSolution solve_by_sweeps(const contact::LocalProblem& problem, const VecX& guess,
                                         const SweepSettings& settings, const Budget& budget) {
  return solve_islands(problem, guess, [&](const contact::LocalProblem& island, const VecX& start) {
    Sweeps sweeps(island, start);
    contact::ContactSolution solution = sweep_to_tolerance(sweeps, island.num_contacts(), settings, budget);
    const std::string culprit = find_culprit(island, solution.r, settings.shared.tolerance);
    if (!culprit.empty()) {
      solution.status = contact::SolveStatus::numerical_error;
      solution.message = culprit;
    }
    return solution;
  });
}

}  // namespace nilas::solvers
