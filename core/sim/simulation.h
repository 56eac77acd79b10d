#pragma once
/// A scene in motion: builds what the scene names and advances it step by step.
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/log.h"
#include "core/base/state.h"
#include "core/bodies/bodies.h"
#include "core/scene/scene.h"
#include "core/sim/account/step_record.h"
#include "core/sim/build/module_list.h"

namespace nilas {

struct World;

class Simulation {
 public:
  /// Builds only what the scene names. Throws InputError or FileError for content that cannot run (open hull,
  /// overlapping floes ...).
  Simulation(const Scene& scene, int threads, WarningCounts& warnings);
  /// The same with a list of modules of one's own in place of scene_modules().
  Simulation(const Scene& scene, int threads, WarningCounts& warnings, const ModuleList& modules);
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
  /// The contact problem of the last step; where it was divided into substeps, that of the last one with contacts.
  /// Empty before the first step.
  const SolvedProblem& last_problem() const;
  /// The problems of all substeps of the last step, in the order of time.
  const std::vector<SolvedProblem>& solved_substeps() const;
  int vessel_index() const;  ///< in bodies(), -1 without a vessel
  long steps() const;        ///< done since the start
  /// A sum since the start, over the modules that know it by this name; 0 where none does:
  ///   "crushed_mass"   of ice that the vessel and bodies crushed [kg]
  ///   "brash_mass"     of pieces too small to be bodies [kg]
  ///   "extruded_mass"  of crushed ice that was cut out of its floes [kg]
  double total(std::string_view name) const;
  /// The same of one body, by its id:
  ///   "damage"         largest of a floe's places [-]
  double of_body(std::string_view name, std::int64_t id) const;

  /// All that the next steps depend on, between two steps. What follows from the scene alone is not in it.
  void save(StateWriter out) const;
  /// Continues from what a simulation of the same scene saved: the next steps give the same bits, whatever the number
  /// of threads. last_problem() stays empty until the next step. Throws InputError when the state is one of another
  /// scene.
  void restore(const StateReader& in);

 private:
  std::unique_ptr<World> world_;
  std::function<StepRecord(World&)> step_;  ///< time stepping, or the reference integrator
};

}  // namespace nilas
