#include "core/sim/simulation.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/bodies/module.h"
#include "core/sim/build/build_world.h"
#include "core/sim/reference/reference_step.h"
#include "core/sim/step/step_book.h"
#include "core/sim/step/take_step.h"
#include "core/sim/world/course.h"
#include "core/sim/world/drawn_rods.h"

namespace nilas::sim {

Simulation::Simulation(const scene::Scene& scene, int threads, WarningCounts& warnings, const ModuleList& modules)
    : world_(std::make_unique<World>(scene, threads, warnings, build_world(scene, threads, warnings, modules))) {
  step_ = take_step;
  if (scene.contact.integrator != Integrator::reference) return;
  const auto reference = std::make_shared<ReferenceIntegrator>(scene, threads, world_->parts, world_->model);
  step_ = [reference](World& world) { return take_reference_step(world, *reference); };
}
Simulation::Simulation(const scene::Scene& scene, int threads, WarningCounts& warnings)
    : Simulation(scene, threads, warnings, scene_modules()) {}
Simulation::~Simulation() = default;

StepRecord Simulation::step() { return step_(*world_); }

std::string Simulation::end_of_course() const {
  return nilas::sim::end_of_course(world_->parts, world_->time(), world_->step);
}
double Simulation::time() const { return world_->time(); }
const bodies::Bodies& Simulation::bodies() const { return world_->parts.bodies; }
const RunInfo& Simulation::info() const { return world_->parts.info; }
const Ledger& Simulation::initial_ledger() const { return world_->energy.ledger(); }
const contact::SolvedProblem& Simulation::last_problem() const {
  static const contact::SolvedProblem none;
  const contact::SolvedProblem* last = nilas::sim::last_problem(*world_);
  return last ? *last : none;
}
const std::vector<contact::SolvedProblem>& Simulation::solved_substeps() const { return world_->solved; }
int Simulation::vessel_index() const { return world_->parts.vessel_index; }
long Simulation::steps() const { return world_->steps; }
double Simulation::total(std::string_view name) const {
  bool known = std::find(bodies::k_run_sums.begin(), bodies::k_run_sums.end(), name) != bodies::k_run_sums.end();
  double sum = 0;
  for (const auto& module : world_->parts.modules)
    if (const std::optional<double> own = module->total(name)) {
      sum += *own;
      known = true;
    }
  NILAS_DEMAND(known);
  return sum;
}
std::vector<std::pair<std::string, std::vector<bodies::RunFigure>>> Simulation::figures() const {
  std::vector<std::pair<std::string, std::vector<bodies::RunFigure>>> all;
  for (const auto& module : world_->parts.modules)
    if (auto own = module->figures(); !own.empty()) all.emplace_back(module->name(), std::move(own));
  return all;
}
std::vector<bodies::DrawnLine> Simulation::drawn() const {
  std::vector<bodies::DrawnLine> all = drawn_rods(world_->parts);
  for (const auto& module : world_->parts.modules)
    for (auto& line : module->drawn(world_->parts.bodies)) all.push_back(std::move(line));
  return all;
}
double Simulation::of_body(std::string_view name, std::int64_t id) const {
  bool known = name == bodies::k_damage;
  double sum = 0;
  for (const auto& module : world_->parts.modules)
    if (const std::optional<double> own = module->of_body(name, id)) {
      sum += *own;
      known = true;
    }
  NILAS_DEMAND(known);
  return sum;
}
void Simulation::save(StateWriter out) const { world_->save(out); }
void Simulation::restore(const StateReader& in) { world_->restore(in); }

}  // namespace nilas::sim
