#pragma once
/// Keeps the best impulses of a solve in progress, and decides when it has converged, stalled or spent its budget.
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "contact/solvers/shared/budget.h"

namespace nilas::solvers {

/// The one rule of all solvers: a solve has stalled when the residual did not fall to `share` of its last mark within
/// `window` iterations. A fall that far sets the next mark. Window and share are in each solver's header.
class StallRule {
 public:
  StallRule(int window, double share) : window_(window), share_(share) {}

  /// Takes the residual after so many iterations. True: stalled.
  bool has_stalled(double residual, int iteration) {
    if (residual < share_ * mark_) {
      mark_ = residual;
      marked_at_ = iteration;
    }
    return waited(iteration) >= window_;
  }
  /// Iterations since the last mark.
  int waited(int iteration) const { return iteration - marked_at_; }

 private:
  int window_;
  double share_;
  double mark_ = std::numeric_limits<double>::infinity();
  int marked_at_ = 0;
};

/// The window for solvers that detect a stall by themselves.
constexpr int k_no_window = std::numeric_limits<int>::max();

class BestImpulses {
 public:
  /// `tolerance`: on the residual [m/s].
  BestImpulses(double tolerance, const Budget& budget, const StallRule& rule)
      : tolerance_(tolerance), budget_(budget), rule_(rule) {
    out_.status = contact::SolveStatus::iteration_limit;
  }

  /// Keeps impulses whose residual as `measure` finds it is the least so far; one that is not a number never is.
  /// Converged where it is at most the tolerance. Returns whether it kept them.
  bool offer(const VecX& r, double residual) {
    const bool is_best = residual < residual_;
    if (is_best) {
      residual_ = residual;
      out_.r = r;
    }
    const bool stalled = rule_.has_stalled(residual, out_.iterations);
    if (residual <= tolerance_)
      out_.status = contact::SolveStatus::converged;
    else if (stalled && out_.status == contact::SolveStatus::iteration_limit)
      out_.status = contact::SolveStatus::stalled;
    return is_best;
  }

  void spend(int iterations = 1) { out_.iterations += iterations; }
  void note(double residual) { out_.history.push_back(residual); }
  /// These end the solve, unless it has converged.
  void stall() {
    if (is_running()) out_.status = contact::SolveStatus::stalled;
  }
  void fail(const std::string& why) {
    if (has_converged()) return;
    out_.status = contact::SolveStatus::numerical_error;
    out_.message = why;
  }

  bool is_running() const { return out_.status == contact::SolveStatus::iteration_limit; }
  bool has_budget() const { return budget_.allows(out_.iterations); }
  bool goes_on() const { return is_running() && has_budget(); }
  bool has_converged() const { return out_.status == contact::SolveStatus::converged; }
  bool has_any() const { return std::isfinite(residual_); }
  int iterations() const { return out_.iterations; }
  /// Returns the budget that the iterations so far leave.
  Budget left() const { return budget_.after(out_.iterations); }
  double residual() const { return residual_; }  ///< residual of the best impulses; infinite without any [m/s]
  const VecX& impulses() const { return out_.r; }

  contact::ContactSolution solution() && { return std::move(out_); }

 private:
  double tolerance_;
  Budget budget_;
  StallRule rule_;
  contact::ContactSolution out_;
  double residual_ = std::numeric_limits<double>::infinity();
};

}  // namespace nilas::solvers
