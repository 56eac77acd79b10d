#pragma once
/// The cost of a scene, measured on the first seconds of a run that has the machine for itself.
#include <limits>
#include <optional>

#include "apps/compare/scenes/plan/make_plan.h"
#include "apps/compare/scenes/run/scene_run.h"

namespace nilas::compare {

struct Probe {
  std::size_t steps = 0;  ///< number of steps that it made
  double length = 0;      ///< simulated time [s]
  double window_from =
      std::numeric_limits<double>::quiet_NaN();  ///< start of its mean load's window [s]; NaN: no ice touched
  double setup_s = 0;                            ///< wall time of reading, packing ice and starting [s]
  std::vector<double> time_s, ms, solver_ms;     ///< end [s], time and solver time [ms] of each step
  std::vector<double> output_ms;                 ///< time of writing after each step [ms]
  std::string trouble;                           ///< why it made no step, or ended by itself before its end
  int exit_code = 0;

  double total_ms() const;
  /// The part of the time of its process [s] that is neither a step nor writing after one: the set-up [s].
  double outside_steps_s(double process_s) const;
  /// The time of the solver in the steps up to a simulated time [s], in milliseconds.
  double solver_ms_until(double t) const;
};

/// Makes a run for `limit_s` of wall time, with `beside` more of the same at once, each on a core of its own. `start`:
/// start time of the scene [s].
Probe probe(const SceneRun& run, double start, double limit_s, int beside, const std::function<bool()>& stop);

/// The cost model from the probe of the first setting. `start`: start time of the scene [s].
CostModel cost_model(const Probe& first, double start);
/// The ratio of the time of a step's solve of the reference to the first setting's, over the simulated time that both
/// reached. Nothing if there is no such time, or no solver time in it.
std::optional<double> reference_weight(const Probe& first, const Probe& reference, double first_step,
                                       double reference_step, double start);

}  // namespace nilas::compare
