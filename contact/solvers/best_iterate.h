#pragma once
/// The stop of methods that know their residual up to rounding in every iteration: measures when that is small enough,
/// keeps the best impulses measured, and writes the solution.
#include "contact/solvers/island_operator.h"
#include "contact/solvers/shared/progress.h"

namespace nilas {

class BestIterate {
 public:
  BestIterate(IslandOperator& island, const SolverSettings& shared, int patience)
      : island_(island), shared_(shared), progress_(shared, patience) {
    out_.status = SolveStatus::iteration_limit;
  }

  /// False: stop with these impulses. `estimate`: their residual [m/s].
  bool go_on(const VecX& r, double estimate) {
    const int done = out_.iterations;
    if (shared_.keep_history && done > 0) out_.history.push_back(estimate);
    current_ = false;
    if (progress_.measurement_due(done, estimate)) judge(r, estimate);
    if (out_.status != SolveStatus::iteration_limit || progress_.out_of_budget(done)) return false;
    ++out_.iterations;
    return true;
  }

  /// After the last iteration, with its impulses.
  ContactSolution solution(const VecX& r) {
    if (shared_.tolerance > 0 && !current_) judge(r, 1);
    out_.r = shared_.tolerance > 0 && best_.size() > 0 ? best_ : r;
    if (!out_.r.allFinite()) {
      out_.r.setZero();
      out_.status = SolveStatus::numerical_error;
    }
    if (out_.status == SolveStatus::numerical_error) out_.message = "the impulses grew beyond all numbers";
    return std::move(out_);
  }

 private:
  void judge(const VecX& r, double estimate) {
    const SolveStatus status = progress_.judge(out_.iterations, estimate, island_.law_map(r));
    if (progress_.improved()) best_ = r;
    if (out_.status == SolveStatus::iteration_limit || status == SolveStatus::converged) out_.status = status;
    current_ = true;
  }

  IslandOperator& island_;
  SolverSettings shared_;
  Progress progress_;
  ContactSolution out_;
  VecX best_;
  bool current_ = false;
};

}  // namespace nilas
