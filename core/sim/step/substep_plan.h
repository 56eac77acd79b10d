#pragma once
/// Division of a step into substeps.
#include <algorithm>

namespace nilas::sim {

/// Length below which substeps are not halved [share of the step].
constexpr double k_shortest_half = 1.0 / 65536;

class SubstepPlan {
 public:
  /// Plans a step from `t` to `end` of length `step` [s], which impacts cut into at most `most` substeps. `end` is the
  /// start of the next step to the last bit, which t + step need not be.
  SubstepPlan(double t, double end, double step, int most)
      : t_(t), end_(end), step_(step), longest_(step), most_(most) {}

  bool is_done() const { return elapsed_ >= step_; }
  bool is_at_start() const { return elapsed_ == 0; }
  double step() const { return step_; }
  double now() const { return is_done() ? end_ : t_ + elapsed_; }
  /// The rest of the step, or less after halving [s].
  double longest() const { return std::min(step_ - elapsed_, longest_); }
  bool may_cut() const { return cuts_ < most_; }
  bool can_halve(double h) const { return h > k_shortest_half * step_; }

  /// Notes that a substep of length h was taken back: the next one is at most half as long.
  void halve(double h) { longest_ = h / 2; }
  /// Notes that a substep of length h was taken that could have lasted `allowed` [s]. The next may be twice that.
  void take(double h, double allowed) {
    cuts_ += h < allowed ? 1 : 0;
    elapsed_ = h < step_ - elapsed_ ? elapsed_ + h : step_;
    longest_ = 2 * allowed;
  }

 private:
  double t_, end_, step_, elapsed_ = 0, longest_;
  int most_, cuts_ = 1;
};

}  // namespace nilas::sim
