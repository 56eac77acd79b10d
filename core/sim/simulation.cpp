#include "core/sim/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/assemble.h"
#include "contact/detect/detector.h"
#include "contact/detect/reach.h"
#include "contact/islands.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/order_free_sum.h"
#include "core/sim/advance.h"
#include "core/sim/contact_model.h"
#include "core/sim/ledger.h"
#include "core/sim/reference.h"
#include "core/sim/stopwatch.h"
#include "core/sim/warm_start.h"
#include "core/sim/world.h"

namespace nilas {

namespace {

/// Contacts enter the problem when they can close within this multiple of the bodies' way in one step: a hit turns some
/// points of a floe faster than what hit it.
constexpr double k_reach_share = 1.5;

/// Per body; infinite for a half space [m].
std::vector<double> smallest_widths(const Bodies& bodies) {
  std::vector<double> widths;
  for (const auto& shape : bodies.shape) {
    double width = std::numeric_limits<double>::infinity();
    for (const auto& part : shape->parts) width = std::min(width, part.smallest_width);
    if (shape->radius > 0) width = 2 * shape->radius;
    if (shape->half_height > 0) width = std::min(width, 2 * shape->half_height);
    widths.push_back(width);
  }
  return widths;
}

/// A vessel on a carriage at the step's start: its momenta balance from there, not from where the contacts are found.
struct VesselStart {
  Vec3 v = Vec3::Zero(), w = Vec3::Zero();  ///< [m/s, rad/s]
  Mat3 inertia = Mat3::Zero();              ///< in G [kg m^2]
};

}  // namespace

struct Simulation::World {
  World(const Scene& scene, int thread_count, WarningCounts& warning_counts)
      : parts(build_world(scene, thread_count, warning_counts)),
        warnings(warning_counts),
        threads(thread_count),
        h(scene.time.step),
        start(scene.time.start),
        gravity(scene.gravity),
        gyroscopic(scene.contact.gyroscopic),
        detector(thread_count),
        model(build_contact_model(scene.contact, scene.time.step, thread_count)),
        energy(parts.info.work_names, 0, 0) {
    parts.info.modules.emplace_back(
        "contact", "law " + scene.contact.law + ", solver " + scene.contact.solver + ", stabilisation " +
                       scene.contact.stabilisation + ", detection " + scene.contact.detection + ", integrator " +
                       scene.contact.integrator + (model.static_friction ? ", static friction above kinetic" : ""));
    module_loads.resize(parts.modules.size(), Wrenches(size()));
    if (model.hit_when_met) width = smallest_widths(parts.bodies);
    weight.resize(size());
    for (std::size_t b = 0; b < size(); ++b) weight[b].force = parts.bodies.mass[b] * gravity;
    energy = EnergyAccount(parts.info.work_names, kinetic_energy(parts.bodies), potential());
    if (scene.contact.integrator == "reference") reference.emplace(scene, thread_count, parts, model);
  }

  std::size_t size() const { return static_cast<std::size_t>(parts.bodies.size()); }

  double potential();
  double time() const { return start + static_cast<double>(steps) * h; }

  void move_before_impulses();
  void move_vessel_before_impulses();
  const Wrenches& evaluate_loads();
  std::vector<ArticulatedBlock> begin_vessel(const Wrenches& free);
  std::vector<ContactPoint> find_contacts();
  bool will_bounce_when_met(const ContactPoint& c);
  StepMotion velocity_step(const AssembledContacts& contacts, const ContactSolution& solution, const Wrenches& free,
                           std::vector<ContactPoint> points);
  void advance_poses(StepMotion& motion);
  Velocities correct_positions(const StepMotion& motion, const AssembledContacts& contacts, StepRecord& record);
  void note_solution(const ContactSolution& solution, StepRecord& record) const;
  void copy_vessel_state();
  VesselAccount vessel_account() const;
  StepLoads step_loads() const;
  VesselRecord vessel_record(const StepMotion& motion) const;
  StepRecord reference_step();
  void note_end(const MomentumBalance& balance, StepRecord& record) const;
  void stop_on_failure(const StepRecord& record) const;
  std::uint64_t state_hash() const;
  void demand_finite() const;
  void name_unnamed_pairs();
  void save(StateWriter out) const;
  void restore(const StateReader& in);

  WorldParts parts;
  WarningCounts& warnings;
  int threads;
  double h, start;
  long steps = 0;
  Vec3 gravity;
  bool gyroscopic;
  ContactDetector detector;
  ContactModel model;
  WarmStart warm;
  Wrenches weight, free_loads;
  std::vector<Wrenches> module_loads;
  std::vector<double> width;  ///< smallest of each body, where the contact model needs it [m]
  EnergyAccount energy;
  VesselStart vessel_start;
  SolvedProblem last;
  std::optional<ReferenceIntegrator> reference;  ///< moves the bodies in place of all else
  std::size_t pairs_named = 0;                   ///< of the pairs without friction, already told
};

double Simulation::World::potential() {
  double sum = weight_energy(parts.bodies, gravity);
  for (const auto& module : parts.modules)
    if (module->conservative()) sum += module->potential_energy(parts.bodies);
  return sum;
}

void Simulation::World::move_before_impulses() {
  if (model.theta < 1)
    advance(parts.bodies, {parts.bodies.v_GB, parts.bodies.w_GB}, (1 - model.theta) * h, gyroscopic, threads);
  const bool vessel_moves = parts.vessel && !parts.vessel->fixed();
  if (vessel_moves && !parts.vessel->on_carriage()) move_vessel_before_impulses();
  if (model.theta < 1) energy.motion_before_impulses(kinetic_energy(parts.bodies));
  // the energy of what the carriage moves is booked from end to end
  if (vessel_moves && parts.vessel->on_carriage()) {
    const auto b = static_cast<std::size_t>(parts.vessel_index);
    vessel_start = {parts.bodies.v_GB[b], parts.bodies.w_GB[b], parts.bodies.inertia_G(parts.vessel_index)};
    move_vessel_before_impulses();
  }
}

void Simulation::World::move_vessel_before_impulses() {
  parts.vessel->move_before_impulses(h);
  copy_vessel_state();
}

const Wrenches& Simulation::World::evaluate_loads() {
  free_loads = weight;
  for (std::size_t k = 0; k < parts.modules.size(); ++k) {
    std::fill(module_loads[k].begin(), module_loads[k].end(), Wrench{});
    parts.modules[k]->add_forces(parts.bodies, time() + (1 - model.theta) * h, module_loads[k]);
    for (std::size_t b = 0; b < size(); ++b) free_loads[b] += module_loads[k][b];
  }
  for (std::size_t b = 0; b < size(); ++b)
    if (!(free_loads[b].force.allFinite() && free_loads[b].torque.allFinite()))
      throw SimulationError("at " + std::to_string(time()) + " s the loads on body '" + parts.bodies.name[b] +
                            "' left finite numbers; try a smaller <time step>");
  return free_loads;
}

std::vector<ArticulatedBlock> Simulation::World::begin_vessel(const Wrenches& free) {
  if (!parts.vessel || parts.vessel->fixed()) return {};
  VesselBlock block = parts.vessel->begin(free[static_cast<std::size_t>(parts.vessel_index)], h);
  return {{parts.vessel_index, std::move(block.mass), std::move(block.f), std::move(block.jacobian), block.prescribed}};
}

std::vector<ContactPoint> Simulation::World::find_contacts() {
  auto points = model.margin > 0 ? detector.detect(parts.bodies, model.margin)
                                 : detector.detect(parts.bodies, own_reach(parts.bodies, free_loads, h, k_reach_share));
  // in the middle of the motion what bounces is hit when it is met: then a bounce is its own image in time
  if (model.hit_when_met)
    std::erase_if(points, [&](const ContactPoint& c) { return c.gap > 0 && will_bounce_when_met(c); });
  return points;
}

/// As assemble() judges it: slower approach than the threshold ends a series of bounces. What could be half through a
/// body when it is met bounces at once.
bool Simulation::World::will_bounce_when_met(const ContactPoint& c) {
  const double before = c.n.dot(parts.bodies.velocity_at(c.b, c.p) - parts.bodies.velocity_at(c.a, c.p));
  if (before >= -model.assembly.restitution_threshold) return false;
  constexpr double k_deepest_share = 0.5;
  const double thinner = std::min(width[static_cast<std::size_t>(c.a)], width[static_cast<std::size_t>(c.b)]);
  if (-before * h > k_deepest_share * thinner) return false;
  const auto& material = parts.bodies.material;
  return parts.friction.find(material[static_cast<std::size_t>(c.a)], material[static_cast<std::size_t>(c.b)])
             .restitution > 0;
}

static void add_couples(const AssembledContacts& contacts, const ContactSolution& solution, StepMotion& motion) {
  motion.couples.assign(motion.points.size(), Vec3::Zero());
  for (std::size_t c = motion.points.size(); c < contacts.C.size(); ++c)
    motion.couples[static_cast<std::size_t>(contacts.problem.moments[c].contact)] =
        contacts.C[c] * solution.r.segment<3>(3 * static_cast<Eigen::Index>(c));
}

StepMotion Simulation::World::velocity_step(const AssembledContacts& contacts, const ContactSolution& solution,
                                            const Wrenches& free, std::vector<ContactPoint> points) {
  StepMotion motion;
  motion.h = h;
  motion.p = parts.bodies.p_GB;
  motion.R = parts.bodies.R_GB;
  motion.before = {parts.bodies.v_GB, parts.bodies.w_GB};
  if (parts.vessel && parts.vessel->on_carriage()) {
    const auto vessel = static_cast<std::size_t>(parts.vessel_index);
    motion.before.v[vessel] = vessel_start.v;
    motion.before.w[vessel] = vessel_start.w;
  }
  motion.points = std::move(points);
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    const Vec3 r = solution.r.segment<3>(3 * static_cast<Eigen::Index>(i));
    motion.impulses.emplace_back(contacts.C[i] * r);
    motion.normal_impulses.emplace_back(contacts.C[i].col(0) * r[0]);
  }
  motion.speed_asked = contacts.speed_asked;
  if (contacts.problem.has_moments()) add_couples(contacts, solution, motion);
  free_velocities(parts.bodies, free, h, motion.after);
  for (std::size_t b = 0; b < size(); ++b) {
    const int block = contacts.block_of_body[b];
    if (block < 0 || !parts.bodies.is_free(static_cast<int>(b))) continue;
    const int first = contacts.problem.block_offset[static_cast<std::size_t>(block)];
    motion.after.v[b] = solution.v.segment<3>(first);
    motion.after.w[b] = solution.v.segment<3>(first + 3);
  }
  return motion;
}

void Simulation::World::copy_vessel_state() {
  const VesselState& state = parts.vessel->state();
  const auto b = static_cast<std::size_t>(parts.vessel_index);
  parts.bodies.set_pose(parts.vessel_index, state.pose.p, state.pose.q);
  parts.bodies.v_GB[b] = state.v;
  parts.bodies.w_GB[b] = state.w;
}

void Simulation::World::advance_poses(StepMotion& motion) {
  advance(parts.bodies, motion.after, model.theta * h, gyroscopic, threads);
  if (!parts.vessel || parts.vessel->fixed()) return;
  parts.vessel->finish(contact_impulse_on(motion, parts.vessel_index));
  const Vec6 twist = parts.vessel->velocity_after_impulses();
  const auto b = static_cast<std::size_t>(parts.vessel_index);
  motion.after.v[b] = twist.head<3>();
  motion.after.w[b] = twist.tail<3>();
  copy_vessel_state();
}

/// A point that was hit deep leaves as it came; lifted out as well, it would win height in every bounce.
static void leave_to_their_motion(const StepMotion& motion, std::vector<ContactPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double speed = points[i].n.dot(relative_velocity(motion, motion.after, i));
    if (points[i].gap < 0 && speed * motion.h >= -points[i].gap) points[i].gap = 0;
  }
}

Velocities Simulation::World::correct_positions(const StepMotion& motion, const AssembledContacts& contacts,
                                                StepRecord& record) {
  if (model.position_step == PositionStep::none) return {};
  Velocities pseudo{std::vector<Vec3>(size(), Vec3::Zero()), std::vector<Vec3>(size(), Vec3::Zero())};
  std::vector<ContactPoint> points =
      model.position_step == PositionStep::projection ? carried_points(motion, parts.bodies) : motion.points;
  if (model.hit_when_met) leave_to_their_motion(motion, points);
  record.positions_corrected = correction_velocities(contacts, points, model.correction, pseudo.v, pseudo.w).converged;
  displace(parts.bodies, pseudo, h);
  return pseudo;
}

void Simulation::World::note_solution(const ContactSolution& solution, StepRecord& record) const {
  record.status = solution.status;
  record.iterations = solution.iterations;
  record.solver_message = solution.message;
  const bool as_asked = solution.status == SolveStatus::converged ||
                        (model.fixed_sweeps && solution.status == SolveStatus::iteration_limit);
  record.solver_short = !as_asked;
  if (as_asked) return;
  warnings.warn("steps short of the contact tolerance",
                fmt::format("contact solver at {:g} s: {}, law_map_m_s {:.3g} above the tolerance {:.3g}{}", time() + h,
                            to_string(solution.status), record.residuals.law_map_m_s, model.tolerance,
                            solution.message.empty() ? "" : ", " + solution.message));
}

StepLoads Simulation::World::step_loads() const {
  StepLoads loads;
  loads.gravity = &weight;
  for (std::size_t k = 0; k < parts.modules.size(); ++k)
    (parts.modules[k]->conservative() ? loads.conservative : loads.working).push_back(&module_loads[k]);
  return loads;
}

VesselAccount Simulation::World::vessel_account() const {
  VesselAccount account;
  if (!parts.vessel || !parts.vessel->on_carriage()) return account;
  account.index = parts.vessel_index;
  account.on_carriage = true;
  account.carriage = parts.vessel->carriage_loads().about_com;
  account.inertia_before = vessel_start.inertia;
  account.inertia_after = parts.bodies.inertia_G(parts.vessel_index);
  return account;
}

VesselRecord Simulation::World::vessel_record(const StepMotion& motion) const {
  VesselRecord record;
  const Wrench impulse = contact_impulse_on(motion, parts.vessel_index);
  record.contact = {impulse.force / h, impulse.torque / h};
  const auto vessel = static_cast<std::size_t>(parts.vessel_index);
  OrderFreeVectorSum on_port, on_starboard;
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    const ContactPoint& c = motion.points[i];
    if (c.a != parts.vessel_index && c.b != parts.vessel_index) continue;
    const bool port = (motion.R[vessel].transpose() * (c.p - motion.p[vessel])).y() > 0;
    const double sign = c.b == parts.vessel_index ? 1 : -1;
    (port ? on_port : on_starboard).add(sign / h * motion.impulses[i]);
  }
  record.contact_port = on_port.value();
  record.contact_starboard = on_starboard.value();
  record.state = parts.vessel->state();
  if (parts.vessel->on_carriage()) record.carriage = parts.vessel->carriage_loads();
  record.has_cells = parts.info.has_cells;
  if (parts.info.has_hydro) {
    record.hydro.emplace();
    for (const auto& loads : module_loads) *record.hydro += loads[static_cast<std::size_t>(parts.vessel_index)];
  }
  return record;
}

std::uint64_t Simulation::World::state_hash() const {
  StateHash hash;
  const Bodies& bodies = parts.bodies;
  for (std::size_t b = 0; b < size(); ++b) {
    if (bodies.motion[b] == Motion::fixed) continue;
    hash.add_vector(bodies.p_GB[b]);
    hash.add_vector(bodies.q_GB[b].coeffs());
    hash.add_vector(bodies.v_GB[b]);
    hash.add_vector(bodies.w_GB[b]);
  }
  if (parts.vessel) hash.add_vector(parts.vessel->coordinates());
  return hash.value();
}

void Simulation::World::demand_finite() const {
  const Bodies& bodies = parts.bodies;
  for (std::size_t b = 0; b < size(); ++b)
    if (!(bodies.p_GB[b].allFinite() && bodies.v_GB[b].allFinite() && bodies.w_GB[b].allFinite() &&
          bodies.q_GB[b].coeffs().allFinite()))
      throw SimulationError("at " + std::to_string(time()) + " s body '" + bodies.name[b] +
                            "' left finite numbers; try a smaller <time step>");
}

void Simulation::World::name_unnamed_pairs() {
  const auto pairs = parts.friction.unnamed_pairs();
  for (; pairs_named < pairs.size(); ++pairs_named) {
    const auto& [a, b] = pairs[pairs_named];
    warnings.warn("frictionless " + a + " " + b,
                  "'" + a + "' and '" + b + "' touch, but no <friction between> names them: frictionless");
  }
}

/// Modules keep nothing but what they would compute again from the poses.
void Simulation::World::save(StateWriter out) const {
  out.add("steps", steps);
  parts.bodies.save(out.group("bodies"));
  if (parts.vessel) parts.vessel->save(out.group("vessel"));
  parts.friction.save(out.group("friction"));
  out.add("pairs_named", pairs_named);
  detector.save(out.group("detector"));
  if (model.static_friction) model.static_friction->save(out.group("static_friction"));
  warm.save(out.group("warm_start"));
  energy.save(out.group("energy"));
}

void Simulation::World::restore(const StateReader& in) {
  in.get("steps", steps);
  parts.bodies.restore(in.group("bodies"));
  if (parts.vessel) parts.vessel->restore(in.group("vessel"));
  parts.friction.restore(in.group("friction"));
  in.get("pairs_named", pairs_named);
  detector.restore(parts.bodies, in.group("detector"));
  if (model.static_friction) model.static_friction->restore(in.group("static_friction"));
  warm.restore(in.group("warm_start"));
  energy.restore(in.group("energy"));
}

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

/// What every record holds at its end, whatever moved the bodies.
void Simulation::World::note_end(const MomentumBalance& balance, StepRecord& record) const {
  record.step = steps;
  record.t = time();
  record.h = h;
  record.floes = parts.info.floes;
  record.ledger = energy.ledger();
  record.momentum_imbalance = balance.linear;
  record.momentum_scale = balance.linear_scale;
  record.angular_momentum_imbalance = balance.angular;
  record.angular_momentum_scale = balance.angular_scale;
  record.state_hash = state_hash();
}

void Simulation::World::stop_on_failure(const StepRecord& record) const {
  if (!model.stop_on_failure || record.status == SolveStatus::converged || last.problem.num_contacts() == 0) return;
  throw SimulationError(fmt::format("at {:g} s the contact solver stopped with status {}, law_map_m_s {:.3g}{}",
                                    record.t, to_string(record.status), record.residuals.law_map_m_s,
                                    record.solver_message.empty() ? "" : ": " + record.solver_message));
}

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
