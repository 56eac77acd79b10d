#include "core/sim/simulation.h"

#include <algorithm>

#include "contact/islands.h"
#include "core/sim/simulation_world.h"
#include "core/sim/stopwatch.h"

namespace nilas {

static void note_penetration(const std::vector<ContactPoint>& points, StepRecord& record) {
  int count = 0;
  for (const auto& c : points) {
    if (c.gap >= 0) continue;
    ++count;
    record.penetration_max = std::max(record.penetration_max, -c.gap);
    record.penetration_mean -= c.gap;
  }
  if (count > 0) record.penetration_mean /= count;
}

Simulation::Simulation(const Scene& scene, int threads, WarningCounts& warnings)
    : world_(std::make_unique<World>(scene, threads, warnings)) {}
Simulation::~Simulation() = default;

/// One output step of the reference integrator, with as many impacts and other events as fall into it.
StepRecord Simulation::World::reference_step() {
  StepRecord record;
  Stopwatch watch(record.ms);
  const auto [linear, angular] = momenta(parts.bodies);
  const double t0 = time();
  ++steps;
  ReferenceStep done = reference->advance(t0, time());
  demand_finite();
  name_unnamed_pairs();
  record.contacts = done.contacts;
  record.residuals = done.residuals;
  last = std::move(done.impact);
  last.solution.status = done.status;
  last.solution.iterations = done.iterations;
  last.solution.message = done.message;
  note_solution(last.solution, record);
  record.events = std::move(done.events);
  watch.lap(Phase::integration);

  const ReferenceAccount& account = done.account;
  energy.whole_step(kinetic_energy(parts.bodies), potential(), account.works, account.friction, account.impact);
  const auto [linear_end, angular_end] = momenta(parts.bodies);
  note_end({(linear_end - linear - account.impulse).norm(), account.impulse_scale,
            (angular_end - angular - account.angular_impulse).norm(), account.angular_scale},
           record);
  watch.lap(Phase::output);
  stop_on_failure(record);
  return record;
}

StepRecord Simulation::step() {
  World& world = *world_;
  if (world.reference) return world.reference_step();
  StepRecord record;
  Stopwatch watch(record.ms);

  // what moves before the impulses (moreau), then loads other than contact, at that pose
  world.move_before_impulses();
  const Wrenches& free = world.evaluate_loads();
  watch.lap(Phase::hydro);

  // contacts that can close in this step
  std::vector<ContactPoint> points = world.find_contacts();
  note_penetration(points, record);
  record.detection_fallbacks = world.detector.counts().fallbacks;
  watch.lap(Phase::detection);

  // one value holds the step's contact problem
  AssembledContacts contacts =
      assemble(world.parts.bodies, free, points, world.parts.friction, world.model.assembly, world.begin_vessel(free));
  watch.lap(Phase::assembly);

  // impulses, judged by the one yardstick
  const VecX guess = world.model.warm_start ? world.warm.guess(contacts.problem.key) : VecX();
  const ContactSolution solution = world.model.solve(contacts.problem, guess);
  world.warm.keep(contacts.problem.key, solution.r);
  record.residuals = measure(contacts.problem, solution.r, solution.v);
  world.note_solution(solution, record);
  watch.lap(Phase::solver);

  // new velocities, then new poses, then the position correction that the scene chose
  StepMotion motion = world.velocity_step(contacts, solution, free, std::move(points));
  world.advance_poses(motion);
  const Velocities pseudo = world.correct_positions(motion, contacts, record);
  ++world.steps;
  record.contacts = contacts.problem.num_points();
  record.islands = static_cast<int>(find_islands(contacts.problem).size());
  world.last = {std::move(contacts.problem), solution, {}, {}};
  world.demand_finite();
  world.name_unnamed_pairs();
  watch.lap(Phase::integration);

  // accounts of energy and momentum
  const VesselAccount vessel = world.vessel_account();
  const StepLoads loads = world.step_loads();
  world.energy.velocity_step(world.parts.bodies, motion, loads, vessel);
  world.energy.position_step(kinetic_energy(world.parts.bodies), world.potential(), pseudo, motion, loads);
  const MomentumBalance balance = momentum_balance(world.parts.bodies, motion, loads, vessel);
  watch.lap(Phase::output);

  // what the outputs need
  world.note_end(balance, record);
  if (world.parts.vessel) record.vessel = world.vessel_record(motion);
  world.last.points = std::move(motion.points);
  world.last.impulses = std::move(motion.impulses);
  world.stop_on_failure(record);
  return record;
}

double Simulation::time() const { return world_->time(); }
const Bodies& Simulation::bodies() const { return world_->parts.bodies; }
const RunInfo& Simulation::info() const { return world_->parts.info; }
const Ledger& Simulation::initial_ledger() const { return world_->energy.ledger(); }
const SolvedProblem& Simulation::last_problem() const { return world_->last; }
int Simulation::vessel_index() const { return world_->parts.vessel_index; }
long Simulation::steps() const { return world_->steps; }
void Simulation::save(StateWriter out) const { world_->save(out); }
void Simulation::restore(const StateReader& in) { world_->restore(in); }

}  // namespace nilas
