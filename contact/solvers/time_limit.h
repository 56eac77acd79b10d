#pragma once
/// The wall time that a solve may take.
#include <chrono>

#include "contact/solver.h"

namespace nilas {

class TimeLimit {
 public:
  explicit TimeLimit(const SolverSettings& shared) : seconds_(shared.max_seconds), start_(Clock::now()) {}
  /// False for ever where there is no limit.
  bool over() const { return seconds_ > 0 && std::chrono::duration<double>(Clock::now() - start_).count() > seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  double seconds_;
  Clock::time_point start_;
};

}  // namespace nilas
