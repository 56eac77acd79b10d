#pragma once
/// Wall time of a step's phases.
#include <array>
#include <chrono>

#include "core/sim/account/step_record.h"

namespace nilas::sim {

class Stopwatch {
 public:
  explicit Stopwatch(std::array<double, k_num_phases>& ms) : ms_(ms), last_(Clock::now()) {}
  /// Adds the time since the last call to a phase.
  void lap(Phase phase) {
    const auto now = Clock::now();
    ms_[static_cast<std::size_t>(phase)] += std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::array<double, k_num_phases>& ms_;
  Clock::time_point last_;
};

}  // namespace nilas::sim
