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
  /// `processor_ms`: processor time of the step on all threads, with that of outputs, checkpoints and perturbed runs.
  void add(const sim::StepRecord& record, double processor_ms);
  /// Whole sentences about why the last quarter of the steps from `first` on takes longer than the first quarter. Empty
  /// where it takes less than 1.5 times as long, or the run is short. Where the steps waited for the processor, they
  /// name other work on the machine, and what grew in the scene only where the processor time grew as much too.
  std::string slowdown(std::size_t first) const;

  void save(StateWriter out) const;
  void restore(const StateReader& in, std::size_t steps);

 private:
  /// What grew in the scene, in sentences.
  std::string causes(std::size_t first) const;

  std::vector<double> ms_, processor_ms_, contacts_, iterations_, solver_ms_, fracture_ms_;
};

}  // namespace nilas::output
