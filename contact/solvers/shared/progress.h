#pragma once
/// When an iteration is worth measuring, and when it goes on in vain.
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/problem/solution.h"

namespace nilas {

class Progress {
 public:
  /// `patience`: iterations without a fall of the residual by 0.1 % that count as stalled.
  Progress(const SolverSettings& shared, int patience)
      : shared_(shared.started()), patience_(patience), enough_(shared.tolerance) {}

  /// An iteration's largest change in m/s predicts the residual; those that change much are measured now and then.
  bool measurement_due(int iteration, double change) const {
    if (shared_.tolerance <= 0) return false;
    return !(change > enough_) || iteration >= next_ || iteration >= shared_.max_iterations;
  }

  /// Takes the residual measured after an iteration with this largest change: the status to go on or end with.
  SolveStatus judge(int iteration, double change, double law_map) {
    const bool fixed = change == 0 && last_change_ == 0;
    last_change_ = change;
    next_ = iteration + std::max(k_first, iteration / 2);
    enough_ = std::min(enough_, change * shared_.tolerance / law_map);
    improved_ = law_map < best_;
    if (improved_) best_ = law_map;
    if (law_map < (1 - k_fall) * mark_) {
      mark_ = law_map;
      mark_iteration_ = iteration;
    }
    if (!std::isfinite(law_map)) return SolveStatus::numerical_error;
    if (law_map <= shared_.tolerance) return SolveStatus::converged;
    return fixed || iteration - mark_iteration_ >= patience_ ? SolveStatus::stalled : SolveStatus::iteration_limit;
  }

  bool out_of_budget(int iteration) const { return iteration >= shared_.max_iterations || shared_.out_of_time(); }

  bool improved() const { return improved_; }  ///< the last one judged is the best so far
  double best() const { return best_; }

 private:
  static constexpr int k_first = 20;      ///< iterations before the first measurement that no small change called for
  static constexpr double k_fall = 1e-3;  ///< the least that counts as progress

  SolverSettings shared_;
  int patience_;
  double enough_;
  int next_ = k_first;
  double last_change_ = 1;
  double best_ = std::numeric_limits<double>::infinity();
  bool improved_ = false;
  double mark_ = std::numeric_limits<double>::infinity();
  int mark_iteration_ = 0;
};

}  // namespace nilas
