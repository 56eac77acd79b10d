/// Loads, contacts, velocities and poses: what moves the world in a step.
#include "core/sim/simulation_world.h"

#include <algorithm>
#include <cmath>

#include "contact/detect/broad/reach.h"
#include "core/base/error.h"
#include "core/sim/build/breaking_settings.h"
#include "core/sim/build/crushing_settings.h"
#include "core/sim/build/step_modules.h"
#include "core/sim/step/advance.h"

namespace nilas {

namespace {

/// Contacts enter the problem when they can close within this multiple of the bodies' way in one step: a hit turns some
/// points of a floe faster than what hit it.
constexpr double k_reach_share = 1.5;

}  // namespace

Simulation::World::World(const Scene& scene, int thread_count, WarningCounts& warning_counts)
    : parts(build_world(scene, thread_count, warning_counts)),
      warnings(warning_counts),
      threads(thread_count),
      whole_step(scene.time.step),
      start(scene.time.start),
      h(scene.time.step),
      gravity(scene.gravity),
      gyroscopic(scene.contact.gyroscopic),
      detector(thread_count, scene.contact.narrow_phase),
      model(build_contact_model(scene.contact, scene.time.step, thread_count)),
      energy(parts.info.work_names, 0, 0) {
  list_step_modules(scene, parts);
  follow_bodies({});
  energy = EnergyAccount(parts.info.work_names, kinetic_energy(parts.bodies), potential());
  if (has_crushing(scene, parts)) crushing.emplace(crushing_settings(scene), parts.bodies, *parts.ice_properties);
  if (has_breaking(scene, parts)) breaking.emplace(breaking_settings(scene));
  if (breaking || clears_crushed_ice(scene, parts)) pieces.emplace(piece_limits(scene));
  if (scene.contact.integrator == Integrator::reference) reference.emplace(scene, thread_count, parts, model);
}

/// What is kept per body, after bodies came or went; `new_pieces`: those that came.
void Simulation::World::follow_bodies(const std::vector<NewPiece>& new_pieces) {
  module_loads.assign(parts.modules.size(), Wrenches(size()));
  width = smallest_widths(parts.bodies);
  floes = static_cast<int>(std::count(parts.bodies.kind.begin(), parts.bodies.kind.end(), BodyKind::floe));
  weight.assign(size(), Wrench{});
  for (std::size_t b = 0; b < size(); ++b) weight[b].force = parts.bodies.mass[b] * gravity;
  if (crushing) crushing->follow(parts.bodies, new_pieces);
  if (breaking) breaking->follow(parts.bodies, new_pieces);
  if (pieces) detector.follow(parts.bodies);
}

double Simulation::World::potential() {
  double sum = weight_energy(parts.bodies, gravity);
  for (const auto& module : parts.modules)
    if (module->conservative()) sum += module->potential_energy(parts.bodies);
  return sum;
}

/// Whatever moves before the impulses, without contacts, must not pass through anything.
void Simulation::World::shorten_motion_before_impulses() {
  if (model.theta == 1 || model.detection != Detection::continuous) return;
  while (const auto pair = passing({parts.bodies.v_GB, parts.bodies.w_GB}, (1 - model.theta) * h)) {
    if (!can_be_halved()) refuse(*pair);
    h /= 2;
  }
}

/// Nothing where no body moves before the impulses: a vessel keeps its own.
std::optional<PartStart> Simulation::World::part_start() const {
  if (model.theta == 1 || model.detection != Detection::continuous) return std::nullopt;
  const Bodies& bodies = parts.bodies;
  return PartStart{bodies.p_GB,
                   bodies.v_GB,
                   bodies.w_GB,
                   bodies.q_GB,
                   bodies.R_GB,
                   energy,
                   crushing ? std::optional(crushing->memory()) : std::nullopt};
}

void Simulation::World::take_back(const std::optional<PartStart>& before) {
  if (parts.vessel && !parts.vessel->fixed()) parts.vessel->abandon_step();
  if (!before) return;
  Bodies& bodies = parts.bodies;
  bodies.p_GB = before->p;
  bodies.v_GB = before->v;
  bodies.w_GB = before->w;
  bodies.q_GB = before->q;
  bodies.R_GB = before->R;
  energy = before->energy;
  if (crushing) crushing->set_memory(before->crushed.value());
}

void Simulation::World::move_before_impulses() {
  if (model.theta < 1)
    advance(parts.bodies, {parts.bodies.v_GB, parts.bodies.w_GB}, (1 - model.theta) * h, gyroscopic, threads);
  const bool vessel_moves = parts.vessel && !parts.vessel->fixed();
  if (vessel_moves && !is_booked_whole()) move_vessel_before_impulses();
  if (model.theta < 1)
    energy.motion_before_impulses(kinetic_energy(parts.bodies),
                                  parts.vessel ? parts.vessel->joint_account().before : JointAccount::Motion{});
  // the energy of what the carriage moves is booked from end to end
  if (vessel_moves && is_booked_whole()) {
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
    parts.modules[k]->limit(parts.bodies, h, module_loads[k]);
    for (std::size_t b = 0; b < size(); ++b) free_loads[b] += module_loads[k][b];
  }
  for (std::size_t b = 0; b < size(); ++b)
    if (!(free_loads[b].force.allFinite() && free_loads[b].torque.allFinite()))
      throw SimulationError("at " + std::to_string(time()) + " s the loads on body '" + parts.bodies.name[b] +
                            "' left finite numbers; try a smaller <time step>");
  return free_loads;
}

/// Entries of the vessel's parts.
std::vector<Wrench> Simulation::World::of_parts(const Wrenches& loads) const {
  const auto first = loads.begin() + parts.vessel_index + 1;
  return {first, first + parts.num_parts};
}

std::vector<ArticulatedBlock> Simulation::World::begin_vessel(const Wrenches& free) {
  if (!parts.vessel || parts.vessel->fixed()) return {};
  VesselBlock found = parts.vessel->begin(free[static_cast<std::size_t>(parts.vessel_index)], h, of_parts(free));
  ArticulatedBlock block{{}, std::move(found.mass), std::move(found.f)};
  int body = parts.vessel_index;
  block.bodies.push_back({body, std::move(found.hull.jacobian), found.hull.prescribed});
  for (BodyTwist& part : found.parts) block.bodies.push_back({++body, std::move(part.jacobian), part.prescribed});
  return {std::move(block)};
}

/// Pairs that are no contacts: those that crush, and those that a joint holds together.
PairFilter Simulation::World::left_pairs() const {
  if (!crushing && parts.joined.empty()) return {};
  return [this](int a, int b) { return (crushing && crushing->crushes(a, b)) || parts.are_joined(a, b); };
}

std::vector<ContactPoint> Simulation::World::find_contacts() {
  const bool by_margin = model.detection == Detection::discrete && model.margin > 0;
  const PairFilter left = left_pairs();
  std::vector<ContactPoint> points =
      by_margin
          ? detector.detect(parts.bodies, model.margin, left)
          : detector.detect(parts.bodies, own_reach(parts.bodies, free_loads, h, k_reach_share), model.margin, left);
  if (model.detection == Detection::discrete && !by_margin)
    std::erase_if(points, [&](const ContactPoint& c) {
      return c.gap > std::min(width[static_cast<std::size_t>(c.a)], width[static_cast<std::size_t>(c.b)]);
    });
  if (model.detection == Detection::continuous) follow_fast_pairs(points);
  // in the middle of the motion what bounces is hit when it is met: then a bounce is its own image in time
  if (model.hit_when_met)
    std::erase_if(points, [&](const ContactPoint& c) { return c.gap > 0 && will_bounce_when_met(c); });
  return points;
}

/// Of the last detection.
std::vector<std::pair<int, int>> Simulation::World::crushing_pairs() const {
  std::vector<std::pair<int, int>> pairs = detector.pairs_left();
  std::erase_if(pairs, [this](const auto& pair) { return parts.are_joined(pair.first, pair.second); });
  return pairs;
}

void Simulation::World::add_crush_points(std::vector<ContactPoint>& points) {
  if (!crushing) return;
  const std::vector<ContactPoint> crush = crushing->points(parts.bodies, crushing_pairs(), h, model.theta * h);
  if (crush.empty()) return;
  points.insert(points.end(), crush.begin(), crush.end());
  sort_as_detected(points);
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
  if (is_booked_whole()) {
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
  motion.after = new_velocities(contacts, solution, free);
  return motion;
}

/// Of the free bodies; others keep what they have.
Velocities Simulation::World::new_velocities(const AssembledContacts& contacts, const ContactSolution& solution,
                                             const Wrenches& free) const {
  Velocities after;
  free_velocities(parts.bodies, free, h, after);
  for (std::size_t b = 0; b < size(); ++b) {
    const int block = contacts.block_of_body[b];
    if (block < 0 || !parts.bodies.is_free(static_cast<int>(b))) continue;
    const int first = contacts.problem.block_offset[static_cast<std::size_t>(block)];
    after.v[b] = solution.v.segment<3>(first);
    after.w[b] = solution.v.segment<3>(first + 3);
  }
  return after;
}

void Simulation::World::copy_vessel_state() {
  const auto copy = [&](int body, const VesselState& state) {
    const auto b = static_cast<std::size_t>(body);
    parts.bodies.set_pose(body, state.pose.p, state.pose.q);
    parts.bodies.v_GB[b] = state.v;
    parts.bodies.w_GB[b] = state.w;
  };
  int body = parts.vessel_index;
  copy(body, parts.vessel->state());
  for (const PartState& part : parts.vessel->parts()) copy(++body, part.state);
}

void Simulation::World::advance_poses(StepMotion& motion) {
  advance(parts.bodies, motion.after, model.theta * h, gyroscopic, threads);
  if (!parts.vessel || parts.vessel->fixed()) return;
  std::vector<Wrench> on_parts;
  for (int part = 1; part <= parts.num_parts; ++part)
    on_parts.push_back(contact_impulse_on(motion, parts.vessel_index + part));
  parts.vessel->finish(contact_impulse_on(motion, parts.vessel_index), on_parts);
  std::vector<Vec6> twists = parts.vessel->part_velocities_after_impulses();
  twists.insert(twists.begin(), parts.vessel->velocity_after_impulses());
  for (std::size_t k = 0; k < twists.size(); ++k) {
    const std::size_t b = static_cast<std::size_t>(parts.vessel_index) + k;
    motion.after.v[b] = twists[k].head<3>();
    motion.after.w[b] = twists[k].tail<3>();
  }
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
      model.position_step == PositionStep::projection ? points_at_the_end(motion) : motion.points;
  if (model.hit_when_met) leave_to_their_motion(motion, points);
  const PositionCorrection done = correction_velocities(contacts, points, model.correction, pseudo.v, pseudo.w);
  record.positions_corrected = record.positions_corrected && done.converged;
  displace(parts.bodies, pseudo, h);
  return pseudo;
}

}  // namespace nilas
