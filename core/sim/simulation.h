#pragma once
/// Runs a scene: builds its contents and advances it step by step.
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

namespace nilas::sim {

struct World;

class Simulation {
 public:
  /// Builds only what the scene names. Throws InputError or FileError for content that cannot run (an open hull,
  /// overlapping floes, ...).
  Simulation(const scene::Scene& scene, int threads, WarningCounts& warnings);
  /// The same with another list of modules in place of scene_modules().
  Simulation(const scene::Scene& scene, int threads, WarningCounts& warnings, const ModuleList& modules);
  ~Simulation();

  /// Advances by the scene's step. Throws SimulationError as take_step() and take_reference_step() do.
  StepRecord step();

  /// The reason why the run must end before the next step although nothing failed: the carriage's path has ended, or
  /// the carriage would drive the hull into a wall of the tank. Empty where the run can continue.
  std::string end_of_course() const;

  double time() const;
  const bodies::Bodies& bodies() const;
  const RunInfo& info() const;
  /// Energies at the start before the first step; afterwards those of the last step.
  const Ledger& initial_ledger() const;
  /// The contact problem of the last step; in a step with several substeps, that of the last one with contacts. Empty
  /// before the first step.
  const contact::SolvedProblem& last_problem() const;
  /// The problems of all substeps of the last step, in the order of time.
  const std::vector<contact::SolvedProblem>& solved_substeps() const;
  int vessel_index() const;  ///< index in bodies(), -1 without a vessel
  long steps() const;        ///< number of steps since the start
  /// A sum since the start over the modules that know this name. It is 0 where none does, if the name is one of
  /// bodies::k_run_sums. Throws ContractError for any other name.
  double total(std::string_view name) const;
  /// The figures that modules give of the run so far, with the name of each module that gives any.
  std::vector<std::pair<std::string, std::vector<bodies::RunFigure>>> figures() const;
  /// What pictures show of the modules beside the bodies, at the present poses.
  std::vector<bodies::DrawnLine> drawn() const;
  /// The same for one body, by its id; the name that may be unknown to all modules is bodies::k_damage.
  double of_body(std::string_view name, std::int64_t id) const;

  /// Saves everything that the next steps depend on and that does not follow from the scene alone. Call between steps.
  void save(StateWriter out) const;
  /// Continues from the saved state of a simulation of the same scene. The next steps are bitwise the same, whatever
  /// the number of threads. last_problem() stays empty until the next step. Throws InputError when the state belongs to
  /// another scene.
  void restore(const StateReader& in);

 private:
  std::unique_ptr<World> world_;
  std::function<StepRecord(World&)> step_;  ///< time stepping, or the reference integrator
};

}  // namespace nilas::sim
