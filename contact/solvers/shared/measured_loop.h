#pragma once
/// The loop around cheap iterations. Each of them estimates the residual, which is measured only when the estimate is
/// small or the last measurement is long ago.
#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/solvers/shared/best_impulses.h"

namespace nilas::solvers {

class MeasuredLoop {
 public:
  /// `window`: of the stall rule, whose share is 0.999. `horizon`: a loop that at its pace would take more iterations
  /// has stalled, 0: none. With tolerance 0 nothing is measured and nothing stalls.
  MeasuredLoop(const contact::SolverSettings& shared, const Budget& budget, int window, int horizon = 0)
      : tolerance_(shared.tolerance),
        last_(budget.iterations()),
        horizon_(horizon),
        first_(horizon > 0 ? k_first / 2 : k_first),
        next_(first_),
        enough_(shared.tolerance),
        best_(shared.tolerance, budget, {window, k_share}) {}

  /// Whether to do another iteration, which is then counted. `change`: what the last one says of the residual [m/s],
  /// infinite: nothing. `measure()`: the residual as `measure` finds it, `impulses()`: those that it holds for.
  template <class Measure, class Impulses>
  bool goes_on(double change, const Measure& measure, const Impulses& impulses) {
    is_measured_ = false;
    if (is_due(change)) judge(change, measure(), impulses());
    if (!best_.goes_on()) return false;
    best_.spend();
    return true;
  }

  int iterations() const { return best_.iterations(); }
  void note(double residual) { best_.note(residual); }

  /// The best impulses that were measured; with tolerance 0 the last ones. Zeros where none are finite.
  template <class Measure, class Impulses>
  contact::ContactSolution solution(const Measure& measure, const Impulses& impulses) {
    const VecX last = impulses();
    if (tolerance_ > 0 && !is_measured_) judge(1, measure(), last);
    if (!last.allFinite()) best_.fail(k_overflow);
    const bool keeps_last = !best_.has_any() && last.allFinite();
    contact::ContactSolution out = std::move(best_).solution();
    if (keeps_last) out.r = last;
    if (out.r.size() == 0) out.r = VecX::Zero(last.size());
    return out;
  }

 private:
  static constexpr int k_first = 20;           ///< first_ without a horizon
  static constexpr double k_share = 1 - 1e-3;  ///< less of a fall is no progress
  static constexpr double k_first_power = 0.85;
  static constexpr const char* k_overflow = "the impulses grew beyond all numbers";

  /// A small change predicts a small residual; while it is large the residual is measured now and then.
  bool is_due(double change) const {
    return tolerance_ > 0 && (!(change > enough_) || best_.iterations() >= next_ || best_.iterations() >= last_);
  }

  void judge(double change, double residual, const VecX& r) {
    const int done = best_.iterations();
    const bool is_fixed = change == 0 && last_change_ == 0;
    const bool is_scheduled = done >= next_;  // others follow a small change, and may be one iteration apart
    is_measured_ = true;
    last_change_ = change;
    next_ = done + std::max(first_, done / 2);
    enough_ = std::min(enough_, change * tolerance_ / residual);
    best_.offer(r, residual);
    if (!std::isfinite(residual))
      best_.fail(k_overflow);
    else if (is_fixed || (horizon_ > 0 && is_scheduled && is_slow(residual)))
      best_.stall();
  }

  /// Whether the tolerance lies beyond the horizon, if the residual goes on to fall with the same power of the number
  /// of iterations as since the last measurement. Sweeps of a jam do so; in looser contact they are quicker. After the
  /// first measurement the power is taken as one that jams hardly ever reach.
  bool is_slow(double residual) {
    const Mark now{best_.iterations(), std::log(residual / tolerance_)};
    const Mark before = std::exchange(marked_, now);
    if (before.iteration == now.iteration) return false;
    if (before.iteration < 0) return std::log(now.iteration) + now.above / k_first_power > std::log(horizon_);
    const double power = (before.above - now.above) / std::log(now.iteration / static_cast<double>(before.iteration));
    return !(power > 0 && std::log(now.iteration) + now.above / power <= std::log(horizon_));
  }

  /// A measurement: how far its residual lies above the tolerance, as a logarithm.
  struct Mark {
    int iteration = -1;
    double above = 0;
  };

  double tolerance_;
  int last_;
  int horizon_;
  int first_;  ///< iterations before the first measurement, and the fewest between scheduled ones
  int next_;
  Mark marked_;
  double enough_;
  double last_change_ = 1;
  bool is_measured_ = false;
  BestImpulses best_;
};

}  // namespace nilas::solvers
