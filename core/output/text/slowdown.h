#pragma once
/// Changes in the time per step over a run, and their causes.
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/base/state.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

/// The costs of all steps, as sums over at most 1024 stretches of equally many steps. Where there would be more, each
/// two become one, so that memory does not grow with the steps.
class StepCosts {
 public:
  /// `processor_ms`: processor time of the step on all threads, with that of outputs, checkpoints and perturbed runs.
  void add(const sim::StepRecord& record, double processor_ms);
  /// Whole sentences about why the last quarter of the steps from `first` on takes longer than the first quarter. Empty
  /// where it takes less than 1.5 times as long, where the run is short, or where these steps are less than four
  /// stretches. Where the steps waited for the processor, they name other work on the machine, and what grew in the
  /// scene only where the processor time grew as much too. Quarters end where stretches do.
  std::string slowdown(std::size_t first) const;

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  enum Cost : std::size_t { k_ms, k_processor_ms, k_solver_ms, k_fracture_ms, k_contacts, k_iterations, k_costs };
  using Sums = std::array<double, k_costs>;
  /// Means over the first and the last quarter of the stretches from `first` on.
  struct Ends {
    double early = 0, late = 0;
    double ratio() const { return early > 0 ? late / early : 0; }
  };

  Ends ends(Cost cost, std::size_t first) const;
  /// What grew in the scene from that stretch on, in sentences.
  std::string causes(std::size_t first) const;

  std::vector<Sums> stretches_;
  std::size_t length_ = 1;  ///< steps of a stretch; the last one may have fewer
  std::size_t steps_ = 0;
};

}  // namespace nilas::output
