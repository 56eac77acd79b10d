#pragma once
/// What a scene costs, from the first seconds of a run that has the machine for itself.
#include <limits>
#include <optional>

#include "apps/compare/scenes/plan/make_plan.h"
#include "apps/compare/scenes/run/scene_run.h"

namespace nilas {

struct Probe {
  std::size_t steps = 0;                                          ///< that it made
  double length = 0;                                              ///< simulated [s]
  double window_from = std::numeric_limits<double>::quiet_NaN();  ///< of its mean load; NaN: no ice touched [s]
  double setup_s = 0;                         ///< wall time beside the steps: reading, packing ice, writing, starting
  std::vector<double> time_s, ms, solver_ms;  ///< per step
  std::string trouble;                        ///< why it made none, or ended by itself before its end
  int exit_code = 0;

  double total_ms() const;
  /// Of the solver in the steps up to a simulated time.
  double solver_ms_until(double t) const;
};

/// Runs until `limit_s` of wall time have gone, with `beside` more of the same at once, each on a core of its own.
/// `start`: of the scene [s].
Probe probe(const SceneRun& run, double start, double limit_s, int beside, const std::function<bool()>& stop);

/// From the probe of the first setting.
CostModel cost_model(const Probe& first, double start);
/// Time of a step's solve of the reference over the first setting's, over the simulated time that both reached; nothing
/// where that is none or without contact.
std::optional<double> reference_weight(const Probe& first, const Probe& reference, double first_step,
                                       double reference_step, double start);

}  // namespace nilas
