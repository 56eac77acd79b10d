#pragma once
/// Which figures of a load depend on the time step, as far as one run can tell:
/// docs/theory/load-error.md#which-figures-to-use
#include <string>
#include <vector>

namespace nilas::output {

/// By how much figures of a load fall where its steps are averaged in pairs, as shares of the figures over single
/// steps. A figure that has converged with the time step hardly changes.
struct StepDependence {
  double p99 = 0;        ///< 99th percentile of the absolute values
  double filtered = 0;   ///< filtered peak
  double raw = 0;        ///< raw peak
  bool rigid = false;    ///< some ice meets the hull as a rigid body, so the raw peak never converges
  bool doubted = false;  ///< second solutions do not bear out the load of single steps, such as the raw peak

  static constexpr double k_converged = 0.05;  ///< a figure that falls by less counts as converged
};

/// The dependence of a load from its means over steps of `h` [s]; `filter`: averaging time of filtered peaks [s]. All 0
/// for fewer than two steps. `rigid`: as in the result.
StepDependence step_dependence(const std::vector<double>& series, double h, double filter, bool rigid);

/// Whole sentences that name the figures of a load to be used, and those not to be used. `at_least`: the interval of
/// the mean is a lower bound, by the solver or by the law of contact.
std::string figures_to_use(const StepDependence& dependence, bool at_least);

}  // namespace nilas::output
