#pragma once
/// Changes in the time per step over a run, and their causes.
#include <string>
#include <vector>

#include "core/base/state.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

/// One value per step.
class StepCosts {
 public:
  void add(const sim::StepRecord& record);
  /// Whole sentences about why the last quarter of the steps from `first` on takes longer than the first quarter. Empty
  /// where it takes less than 1.5 times as long, or the run is short.
  std::string slowdown(std::size_t first) const;

  void save(StateWriter out) const;
  void restore(const StateReader& in, std::size_t steps);

 private:
  std::vector<double> ms_, contacts_, iterations_, solver_ms_, fracture_ms_;
};

}  // namespace nilas::output
