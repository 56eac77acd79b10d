#pragma once
/// A scene in motion: builds what the scene names and advances it step by step.
#include <memory>
#include <string>

#include "core/base/log.h"
#include "core/base/state.h"
#include "core/bodies/bodies.h"
#include "core/scene/scene.h"
#include "core/sim/account/step_record.h"

namespace nilas {

class Simulation {
 public:
  /// Builds only what the scene names. Throws InputError or FileError for content that cannot run (open hull,
  /// overlapping floes ...).
  Simulation(const Scene& scene, int threads, WarningCounts& warnings);
  ~Simulation();

  /// Advances by the scene's step. Throws SimulationError when a body leaves finite numbers.
  StepRecord step();

  /// Why the next step cannot be taken, although nothing failed: the carriage's path has ended, or it would drive the
  /// hull into a wall of the tank. Empty where the run can go on.
  std::string end_of_course() const;

  double time() const;
  const Bodies& bodies() const;
  const RunInfo& info() const;
  /// Energies at the start, as long as no step was made; afterwards those of the last step.
  const Ledger& initial_ledger() const;
  /// Of the last step, where impacts cut it the last part with contacts; empty before the first.
  const SolvedProblem& last_problem() const;
  /// All parts of the last step, in the order of time.
  const std::vector<SolvedProblem>& solved_parts() const;
  int vessel_index() const;   ///< in bodies(), -1 without a vessel
  long steps() const;         ///< done since the start
  double brash_mass() const;  ///< of pieces too small to be bodies, since the start [kg]
  /// Of crushed ice that was cut out of its floes since the start [kg].
  double extruded_mass() const;
  double damage(std::int64_t floe) const;  ///< largest of the floe's places, 0 without <damage>
  double crushed_mass() const;             ///< of ice that the vessel and bodies crushed since the start [kg]

  /// All that the next steps depend on, between two steps. What follows from the scene alone is not in it.
  void save(StateWriter out) const;
  /// Goes on from what a simulation of the same scene saved: the next steps give the same bits, whatever the number of
  /// threads. last_problem() stays empty until the next step. Throws InputError when the state is one of another scene.
  void restore(const StateReader& in);

 private:
  struct World;
  std::unique_ptr<World> world_;
};

}  // namespace nilas
