#include "core/sim/simulation.h"

#include <algorithm>
#include <map>

#include "contact/problem/islands.h"
#include "core/sim/account/stopwatch.h"
#include "core/sim/simulation_world.h"
#include "core/sim/world/course.h"

namespace nilas {

static void note_penetration(const std::vector<ContactPoint>& points, StepRecord& record) {
  int count = 0;
  record.penetration_max = record.penetration_mean = 0;  // those of a part that was taken back do not count
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
  const bool with_vessel = reference->accounts_for_vessel();
  const auto [linear, angular] = momenta(parts.bodies, with_vessel);
  const double t0 = time();
  ++steps;
  ReferenceStep done = reference->advance(t0, time());
  demand_finite();
  name_unnamed_pairs();
  record.contacts = done.contacts;
  record.residuals = done.residuals;
  solved = {std::move(done.impact)};
  SolvedProblem& last = solved.front();
  last.solution.status = done.status;
  last.solution.iterations = done.iterations;
  last.solution.message = done.message;
  note_solution(last.solution, record);
  record.events = std::move(done.events);
  watch.lap(Phase::integration);

  const ReferenceAccount& account = done.account;
  energy.whole_step(kinetic_energy(parts.bodies), potential(), account.works, account.friction, account.impact);
  const auto [linear_end, angular_end] = momenta(parts.bodies, with_vessel);
  note_end({(linear_end - linear - account.impulse).norm(), account.impulse_scale,
            (angular_end - angular - account.angular_impulse).norm(), account.angular_scale},
           record);
  if (parts.vessel) note_reference_vessel(account.vessel, record);
  watch.lap(Phase::output);
  stop_on_failure(record);
  return record;
}

/// Of every contact, and of every moment that of its contact.
static std::vector<Mat3> orthonormal_frames(const AssembledContacts& contacts) {
  std::vector<Mat3> frames = contacts.C;
  for (std::size_t c = 0; c < frames.size(); ++c)
    if (contacts.problem.is_moment(static_cast<int>(c)))
      frames[c] = contacts.C[static_cast<std::size_t>(contacts.problem.moments[c].contact)];
  return frames;
}

ContactSolution Simulation::World::solve(AssembledContacts& contacts, const std::vector<ContactPoint>& points,
                                         StepRecord& record) {
  ContactProblem& problem = contacts.problem;
  const std::vector<Mat3> frames = orthonormal_frames(contacts);
  VecX guess;
  if (model.warm_start) {
    guess = warm.guess(problem.key, frames);
    broken_contacts.add_to(parts.bodies, points, contacts.C, guess);
  }
  ContactSolution solution = model.solve(problem, guess);
  warm.keep(problem.key, frames, solution.r);
  broken_contacts.forget();
  note_residuals(measure(problem, solution.r, solution.v, contact_d), record);
  note_solution(solution, record);
  return solution;
}

void Simulation::World::keep_solved(ContactProblem& problem, ContactSolution& solution, const StepMotion& motion) {
  SolvedProblem& kept = solved.emplace_back();
  kept.problem = std::move(problem);
  kept.solution = std::move(solution);
  kept.points = motion.points;
  kept.d = std::move(contact_d);
  const auto touching = [&](int body) -> TouchingBody {
    const auto b = static_cast<std::size_t>(body);
    return {parts.bodies.id[b], parts.bodies.motion[b] == Motion::fixed ? 0 : 1 / parts.bodies.mass[b]};
  };
  for (const ContactPoint& c : motion.points) kept.touching.push_back({touching(c.a), touching(c.b)});
  kept.impulses = motion.impulses;
  kept.couples = motion.couples;
  if (!parts.vessel) return;
  kept.vessel_p = motion.p[static_cast<std::size_t>(parts.vessel_index)];
  kept.vessel_R = motion.R[static_cast<std::size_t>(parts.vessel_index)];
}

const SolvedProblem& Simulation::World::last() const {
  const auto touched = std::find_if(solved.rbegin(), solved.rend(),
                                    [](const SolvedProblem& part) { return part.problem.num_points() > 0; });
  if (touched != solved.rend()) return *touched;
  return solved.empty() ? unsolved : solved.front();
}

/// What the step's loads break, and what was crushed so far that it goes: of a floe that breaks, if it cannot be cut
/// so.
std::vector<FloeBreak> Simulation::World::take_breaks() {
  std::map<std::int64_t, std::vector<Failure>> ways;
  if (breaking)
    for (FloeBreak& floe : breaking->take_breaks(parts.bodies, *parts.ice_properties, whole_step))
      ways[floe.floe] = std::move(floe.ways);
  if (crushing)
    for (FloeBreak& floe : crushing->floes_to_clear(parts.bodies, warnings))
      ways[floe.floe].push_back(std::move(floe.ways.front()));
  std::vector<FloeBreak> breaks;
  for (auto& [floe, of_floe] : ways) breaks.push_back({floe, std::move(of_floe)});
  return breaks;
}

/// Pieces take part from the next step on.
void Simulation::World::break_ice(StepRecord& record) {
  std::vector<NewPiece> new_pieces;
  for (const FloeBreak& broken : take_breaks()) {
    FractureEvent event = pieces->put(broken, parts.bodies, *parts.ice_properties, warnings, new_pieces);
    if (event.kind.empty()) continue;
    event.t = time();
    event.energy = energy.breaking(kinetic_energy(parts.bodies), potential());
    record.broken.push_back(std::move(event));
  }
  if (record.broken.empty()) return;
  broken_contacts.note(solved.back(), record.broken);
  follow_bodies(new_pieces);
}

/// The rest of the step, or less of it: `longest` at most [s], and with `may_cut` up to the first impact of a fast
/// pair. Returns how long the next part may be.
double Simulation::World::part_of_step(double longest, bool may_cut, StepRecord& record, MomentumBalance& balance,
                                       Stopwatch& watch) {
  // what moves before the impulses (moreau), then loads other than contact, at that pose
  const double left = whole_step - elapsed;
  h = std::min(left, longest);
  shorten_motion_before_impulses();
  const double part = h;
  const std::optional<PartStart> before = part_start();
  move_before_impulses();
  demand_finite();
  const Wrenches& free = evaluate_loads();
  watch.lap(Phase::hydro);

  // contacts that can close in this step, or in the part of it up to an impact
  h = may_cut ? until_first_impact(part) : part;
  cut = h < part;
  model.set_step(h);
  std::vector<ContactPoint> points = find_contacts();
  if (elapsed == 0) note_penetration(points, record);
  record.detection += detector.counts();
  watch.lap(Phase::detection);
  if (crushing) {
    add_crush_points(points);
    watch.lap(Phase::fracture);
  }

  // one value holds the step's contact problem
  const std::vector<ArticulatedBlock> vessel_block = begin_vessel(free);
  AssembledContacts contacts = assemble(parts.bodies, free, points, parts.friction, model.assembly, vessel_block);
  watch.lap(Phase::assembly);

  // impulses, judged by the one yardstick; again where they lead fast pairs into each other
  const std::optional<StaticFriction> slipped = model.static_friction;
  ContactSolution solution = solve(contacts, points, record);
  std::vector<int> misses;
  while (add_missed(solved_velocities(contacts, solution, vessel_block), misses, points)) {
    contacts = assemble(parts.bodies, free, points, parts.friction, model.assembly, vessel_block);
    solution = solve(contacts, points, record);
  }
  watch.lap(Phase::solver);
  if (!unheld.empty() && can_be_halved()) {
    model.static_friction = slipped;
    take_back(before);
    return part_of_step(h / 2, may_cut, record, balance, watch);
  }
  if (!unheld.empty()) judge_unheld(solved_velocities(contacts, solution, vessel_block));

  // new velocities, then new poses, then the position correction that the scene chose
  StepMotion motion = velocity_step(contacts, solution, free, std::move(points));
  advance_poses(motion);
  const Velocities pseudo = correct_positions(motion, contacts, record);
  elapsed = h < left ? elapsed + h : whole_step;
  record.contacts = std::max(record.contacts, contacts.problem.num_points());
  record.islands = std::max(record.islands, static_cast<int>(find_islands(contacts.problem).size()));
  keep_solved(contacts.problem, solution, motion);
  demand_finite();
  name_unnamed_pairs();
  watch.lap(Phase::integration);

  // accounts of energy and momentum
  const VesselAccount vessel = vessel_account();
  const StepLoads loads = step_loads();
  energy.velocity_step(parts.bodies, motion, loads, vessel);
  energy.position_step(kinetic_energy(parts.bodies), potential(), pseudo, motion, loads,
                       parts.vessel ? parts.vessel->joint_account().after : JointAccount::Motion{});
  balance += momentum_balance(parts.bodies, motion, loads, vessel);
  if (parts.vessel) note_vessel(motion, contacts.C, record);
  if (!parts.info.structures.empty()) note_structures(motion, record);
  if (crushing) {
    crushing->note_crushed(parts.bodies, motion);
    record.crushed_overlap_max = std::max(record.crushed_overlap_max, crushing->deepest_overlap(parts.bodies));
  }
  if (breaking) breaking->note_loads(parts.bodies, *parts.ice_properties, motion);
  ++record.parts;
  watch.lap(Phase::output);
  return 2 * part;
}

StepRecord Simulation::step() {
  World& world = *world_;
  if (world.reference) return world.reference_step();
  StepRecord record;
  Stopwatch watch(record.ms);
  MomentumBalance balance;
  world.solved.clear();
  double longest = world.whole_step;
  for (int cuts = 1; world.elapsed < world.whole_step; cuts += world.cut ? 1 : 0)
    longest = world.part_of_step(longest, cuts < world.model.most_substeps, record, balance, watch);
  world.elapsed = 0;
  ++world.steps;
  if (world.pieces) {
    world.break_ice(record);
    watch.lap(Phase::fracture);
  }
  world.note_end(balance, record);
  watch.lap(Phase::output);
  world.stop_on_failure(record);
  return record;
}

std::string Simulation::end_of_course() const {
  return nilas::end_of_course(world_->parts, world_->time(), world_->whole_step);
}
double Simulation::time() const { return world_->time(); }
const Bodies& Simulation::bodies() const { return world_->parts.bodies; }
const RunInfo& Simulation::info() const { return world_->parts.info; }
const Ledger& Simulation::initial_ledger() const { return world_->energy.ledger(); }
const SolvedProblem& Simulation::last_problem() const { return world_->last(); }
const std::vector<SolvedProblem>& Simulation::solved_parts() const { return world_->solved; }
int Simulation::vessel_index() const { return world_->parts.vessel_index; }
long Simulation::steps() const { return world_->steps; }
double Simulation::brash_mass() const { return world_->pieces ? world_->pieces->brash_mass() : 0; }
double Simulation::extruded_mass() const { return world_->pieces ? world_->pieces->extruded_mass() : 0; }
double Simulation::damage(std::int64_t floe) const { return world_->breaking ? world_->breaking->damage(floe) : 0; }
double Simulation::crushed_mass() const { return world_->crushing ? world_->crushing->crushed_mass() : 0; }
void Simulation::save(StateWriter out) const { world_->save(out); }
void Simulation::restore(const StateReader& in) { world_->restore(in); }

}  // namespace nilas
