#pragma once
/// The budget of a solve in progress.
#include <algorithm>
#include <chrono>
#include <optional>

#include "contact/problem/solution.h"

namespace nilas::solvers {

/// Iterations, and wall time that runs from the start of the whole solve: its islands and stages share the clock.
class Budget {
 public:
  /// Starts the clock.
  explicit Budget(const contact::SolverSettings& settings) : iterations_(settings.max_iterations) {
    if (settings.max_seconds > 0)
      end_ = Clock::now() +
             std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(settings.max_seconds));
  }

  int iterations() const { return iterations_; }
  bool is_out_of_time() const { return end_ && Clock::now() >= *end_; }
  /// Whether another iteration may follow `done` ones.
  bool allows(int done) const { return done < iterations_ && !is_out_of_time(); }

  /// Returns the budget of a stage: the same clock, and at most so many iterations.
  Budget capped(int iterations) const {
    Budget stage = *this;
    stage.iterations_ = std::min(iterations, iterations_);
    return stage;
  }
  /// Returns the budget that `done` iterations leave.
  Budget after(int done) const { return capped(iterations_ - done); }

 private:
  using Clock = std::chrono::steady_clock;

  int iterations_;
  std::optional<Clock::time_point> end_;
};

}  // namespace nilas::solvers
