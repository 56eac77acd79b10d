#include "core/sim/reference/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/problem/row_of.h"
#include "contact/registry.h"
#include "core/base/error.h"
#include "core/numerics/event_ode.h"

namespace nilas::sim {

namespace {

/// Local error per step. Without closed contacts: the smallest that CVODE accepts, with a margin. With closed contacts:
/// larger, because their forces are known to about 1e-10 only and steps would otherwise shrink to nothing.
constexpr double k_relative_in_flight = 1e-15, k_relative_in_contact = 1e-13;
/// Approach below this speed is inelastic and ends a series of bounces. It is far above the speed of a fall through the
/// rounding of gaps.
constexpr double k_inelastic_speed = 2e-5;  // [m/s]
/// An unloaded point of a body that rests on others may sink by this before it carries load [m].
constexpr double k_unloaded_slack = 1e-12;
constexpr int k_events_to_trust = 5, k_most_events = 200;  ///< counts of events at one instant

std::unique_ptr<solvers::ContactSolver> acceleration_solver(const scene::ContactScene& contact, int threads) {
  contact::SolverSettings settings;
  constexpr double k_tolerance = 1e-10;  // [m/s^2]
  settings.tolerance = k_tolerance;
  settings.max_iterations = std::max(contact.max_iterations, contact::SolverSettings{}.max_iterations);
  settings.threads = threads;
  return contact::find_solver(contact.solver).make(settings);
}

double rest_speed(double tolerance) {
  constexpr double k_least = 2e-6;  // [m/s] ten times the speed of a fall through the rounding of gaps
  return std::max(k_least, 3 * tolerance);
}

/// Rounding error of a gap between points at p [m].
double gap_rounding(const Vec3& p) {
  constexpr double k_share = 3e-16;
  return k_share * (1 + p.norm());
}

std::optional<ReferenceVessel> moving_vessel(const WorldParts& parts) {
  if (!parts.vessel || parts.vessel->fixed()) return std::nullopt;
  return std::optional<ReferenceVessel>(std::in_place, *parts.vessel_model, parts.vessel_index, parts.vessel->time(),
                                        parts.vessel->coordinates());
}

double moment_of(const Vec3& p, const Wrench& load) { return (p.cross(load.force) + load.torque).norm(); }

}  // namespace

ReferenceIntegrator::ReferenceIntegrator(const scene::Scene& scene, int threads, WorldParts& parts,
                                         const ContactModel& model)
    : parts_(parts),
      model_(model),
      gravity_(scene.gravity),
      vessel_(moving_vessel(parts)),
      no_vessel_loads_(parts.num_parts, parts.info.vessel_loads.size(), vessel_ && vessel_->is_towed()),
      state_(parts.bodies, parts.info.work_names.size(), vessel_ ? &*vessel_ : nullptr,
             parts.vessel ? &no_vessel_loads_ : nullptr),
      contacts_(parts.friction, acceleration_solver(scene.contact, threads), scene.contact.law.law == Law::frictionless,
                rest_speed(scene.contact.tolerance), vessel_ ? &*vessel_ : nullptr,
                [&parts](int a, int b) { return parts.are_joined(a, b); }),
      module_loads_(parts.forces.size(), bodies::Wrenches(parts.bodies.id.size())),
      impact_settings_(model.assembly),
      rest_speed_(rest_speed(scene.contact.tolerance)) {
  impact_settings_.h = 1;  // the points are already closed
  impact_settings_.restitution_threshold = k_inelastic_speed;
  impact_settings_.stabilisation = {};
  const auto points = contacts_.detect(parts.bodies);
  const auto closed =
      std::count_if(points.begin(), points.end(), [](const auto& c) { return c.gap <= k_reference_touch; });
  if (closed > k_most_reference_contacts)
    throw InputError(
        fmt::format("{}: <contact integrator>: 'reference' does not take {} contacts at once, as the "
                    "scene begins with; allowed: {}",
                    scene.file.string(), closed, k_most_reference_contacts));
}

bool ReferenceIntegrator::moves(int body) const {
  return parts_.bodies.is_free(body) || (vessel_ && vessel_->holds(body));
}

/// Adds the force or impulse `on_b` of a contact to the loads on the vessel and its parts.
void ReferenceIntegrator::add_to_vessel(const detect::ContactPoint& c, const Vec3& on_b,
                                        ReferenceVesselLoads& sum) const {
  const auto about = [&](int body, const Vec3& force) -> Wrench {
    return {force, (c.p - parts_.bodies.p_GB[body]).cross(force)};
  };
  for (const auto& [body, sign] : {std::pair(c.a, -1.0), std::pair(c.b, 1.0)})
    if (parts_.is_of_vessel(body) && body != parts_.vessel_index)
      sum.on_parts[body - parts_.vessel_index - 1] += about(body, sign * on_b);
  const bool is_b = parts_.is_of_vessel(c.b);
  if (parts_.is_of_vessel(c.a) == is_b) return;
  const Vec3 force = (is_b ? 1 : -1) * on_b;
  sum.contact += about(parts_.vessel_index, force);
  if (parts_.bodies.kind[is_b ? c.a : c.b] == bodies::BodyKind::floe) sum.ice += force;
}

double ReferenceIntegrator::approach(const detect::ContactPoint& point) const {
  return point.n.dot(parts_.bodies.velocity_at(point.b, point.p) - parts_.bodies.velocity_at(point.a, point.p));
}

bodies::Wrenches ReferenceIntegrator::free_loads(double t) {
  const bodies::Bodies& bodies = parts_.bodies;
  bodies::Wrenches loads(bodies.id.size());
  for (std::size_t b = 0; b < loads.size(); ++b) loads[b].force = bodies.mass[b] * gravity_;
  for (std::size_t k = 0; k < module_loads_.size(); ++k) {
    std::fill(module_loads_[k].begin(), module_loads_[k].end(), Wrench{});
    parts_.forces[k]->add_forces(bodies, t, module_loads_[k]);
    for (std::size_t b = 0; b < loads.size(); ++b) loads[b] += module_loads_[k][b];
  }
  return loads;
}

void ReferenceIntegrator::add_module_loads(std::size_t body, ReferenceVesselLoads& sum) const {
  const Vec3 arm = parts_.bodies.p_GB[body] - parts_.bodies.p_GB[parts_.vessel_index];
  std::size_t own = 0;
  for (std::size_t m = 0; m < module_loads_.size(); ++m) {
    const Wrench& on_body = module_loads_[m][body];
    const Wrench load{on_body.force, on_body.torque + arm.cross(on_body.force)};
    const bodies::VesselLoad kind = parts_.forces[m]->load_on_vessel();
    if (kind == bodies::VesselLoad::water) sum.hydro += load;
    if (kind == bodies::VesselLoad::own) sum.modules[own++] += load;
  }
}

ReferenceLoads ReferenceIntegrator::loads(double t) {
  bodies::Bodies& bodies = parts_.bodies;
  ReferenceLoads out(bodies.id.size(), parts_.info.work_names.size(), no_vessel_loads_);
  out.total = free_loads(t);
  for (int k = 0; k < bodies.size(); ++k) {
    const auto b = static_cast<std::size_t>(k);
    if (parts_.is_of_vessel(k)) add_module_loads(b, out.vessel);
    if (!moves(k)) continue;
    const auto weigh = [&](const Wrench& load) {
      out.force_sum += load.force.norm();
      out.moment_sum += moment_of(bodies.p_GB[b], load);
    };
    weigh({bodies.mass[b] * gravity_, Vec3::Zero()});
    std::size_t work = 0;
    for (std::size_t m = 0; m < module_loads_.size(); ++m) {
      const Wrench& load = module_loads_[m][b];
      weigh(load);
      if (parts_.forces[m]->conservative()) continue;
      out.powers[work++] += load.force.dot(bodies.v_GB[b]) + load.torque.dot(bodies.w_GB[b]);
    }
  }
  if (parts_.num_parts > 0) out.powers.back() += vessel_->joint_power();
  sustained_ = contacts_.forces(bodies, out.total);
  contacts_.add(sustained_, bodies, out.total);
  out.friction_power = sustained_.friction_power;
  for (std::size_t i = 0; i < sustained_.at.size(); ++i) {
    out.force_sum += sustained_.force[i].norm();
    out.moment_sum += sustained_.at[i].point.p.norm() * sustained_.force[i].norm();
    if (sustained_.at[i].found)
      add_to_vessel(sustained_.at[i].point, sustained_.at[i].frame * sustained_.force[i], out.vessel);
  }
  if (out.vessel.carriage) {
    const auto hull = static_cast<std::size_t>(parts_.vessel_index);
    out.vessel.carriage = vessel_->carriage_loads(out.total);
    const Wrench& held = out.vessel.carriage->about_com;
    out.powers[carriage_work()] += held.force.dot(bodies.v_GB[hull]) + held.torque.dot(bodies.w_GB[hull]);
    out.force_sum += held.force.norm();
    out.moment_sum += moment_of(bodies.p_GB[hull], held);
  }
  return out;
}

/// Event functions: first one for the gaps of the open points above the levels where they close, then two per sustained
/// contact.
void ReferenceIntegrator::watch(double t, VecX& g) {
  loads(t);
  contacts_.watch(sustained_, g.tail(g.size() - 1));
  g[0] = k_reference_margin;
  for (const auto& point : contacts_.detect(parts_.bodies)) {
    const auto& list = contacts_.list();
    if (std::any_of(list.begin(), list.end(), [&](const SustainedContact& c) { return c.key == point.key; })) continue;
    const auto level = level_.find(point.key);
    g[0] = std::min(g[0], point.gap - (level == level_.end() ? 0 : level->second));
  }
}

void ReferenceIntegrator::begin_smooth_motion(double t0, double longest_step) {
  numerics::EventOde ode;
  // The time of an event is found to a share of the integration time, so time is counted from the last event.
  ode.derivative = [this, t0](double since, const VecX& y, VecX& dy) {
    state_.unpack(t0 + since, y, parts_.bodies);
    state_.derivative(parts_.bodies, y, loads(t0 + since), dy);
  };
  ode.num_events = 1 + 2 * static_cast<int>(contacts_.list().size());
  ode.events = [this, t0](double since, const VecX& y, VecX& g) {
    state_.unpack(t0 + since, y, parts_.bodies);
    watch(t0 + since, g);
  };
  numerics::OdeSettings settings;
  settings.relative = contacts_.list().empty() ? k_relative_in_flight : k_relative_in_contact;
  settings.absolute = state_.absolute_tolerances(parts_.bodies, settings.relative);
  settings.longest_step = longest_step;
  accounted_ = state_.pack(parts_.bodies);
  smooth_.emplace(std::move(ode), settings, 0, accounted_);
  smooth_start_ = t0;
}

/// Applies impulses from the scene's own contact problem, law, restitution and solver. Poses do not change.
void ReferenceIntegrator::impact(double t, std::vector<detect::ContactPoint> points, ReferenceStep& step) {
  bodies::Bodies& bodies = parts_.bodies;
  const auto hardest = std::min_element(points.begin(), points.end(),
                                        [this](const auto& p, const auto& q) { return approach(p) < approach(q); });
  step.events.push_back({t, ContactEventKind::impact, hardest->a, hardest->b, -approach(*hardest)});
  for (auto& point : points) point.gap = 0;
  step.met.insert(step.met.end(), points.begin(), points.end());
  std::vector<contact::ArticulatedBlock> vessel;
  if (vessel_) vessel.push_back(vessel_->velocity_block());
  contact::AssembledContacts contacts =
      contact::assemble(bodies, bodies::Wrenches(bodies.id.size()), points, parts_.friction, impact_settings_, vessel);
  const contact::PreparedProblem prepared(contacts.problem);
  contact::StaticFrictionSolution solved = model_.solve(contacts.problem, prepared, {}, slipped_);
  slipped_ = std::move(solved.slipping);
  const contact::ContactSolution& solution = solved.solution;
  const contact::Residuals residuals = contact::measure(prepared, solution.r, solution.v);
  if (residuals.law_map_m_s >= step.residuals.law_map_m_s) step.residuals = residuals;
  step.iterations += solution.iterations;
  if (contact::worse(step.status, solution.status) != step.status) step.message = solution.message;
  step.status = contact::worse(step.status, solution.status);

  const contact::Velocities before{bodies.v_GB, bodies.w_GB};
  for (std::size_t b = 0; b < bodies.id.size(); ++b) {
    const int block = contacts.block_of_body[b];
    if (block < 0) continue;
    const int first = contacts.problem.block_offset[block];
    if (vessel_ && vessel_->holds(static_cast<int>(b))) {
      vessel_->set_speeds(solution.v.segment(first, vessel_->speeds().size()), bodies);
      continue;
    }
    bodies.v_GB[b] = solution.v.segment<3>(first);
    bodies.w_GB[b] = solution.v.segment<3>(first + 3);
  }
  ContactImpulses impulses{std::move(points), {}};
  for (std::size_t i = 0; i < impulses.points.size(); ++i)
    impulses.impulses.emplace_back(contacts.C[i] * solution.r.segment<3>(contact::row_of(i)));
  book(impulses, before, step.account);
  step.impact = {};
  step.impact.problem = std::move(contacts.problem);
  step.impact.solution = solution;
  step.impact.points = std::move(impulses.points);
  step.impact.impulses = std::move(impulses.impulses);
}

/// Books losses and momenta of impulses that changed the velocities from `before` to the current ones.
void ReferenceIntegrator::book(const ContactImpulses& impulses, const contact::Velocities& before,
                               ReferenceAccount& account) const {
  const bodies::Bodies& bodies = parts_.bodies;
  ReferenceVesselLoads on_vessel = no_vessel_loads_;
  for (std::size_t i = 0; i < impulses.points.size(); ++i) {
    const detect::ContactPoint& c = impulses.points[i];
    const auto sum_at = [&](int body) -> Vec3 {
      const auto b = static_cast<std::size_t>(body);
      return bodies.v_GB[b] + before.v[b] + (bodies.w_GB[b] + before.w[b]).cross(c.p - bodies.p_GB[b]);
    };
    const Vec3 mean = 0.5 * (sum_at(c.b) - sum_at(c.a)), impulse = impulses.impulses[i];
    const double normal = c.n.dot(impulse) * c.n.dot(mean);
    account.impact -= normal;
    account.friction -= impulse.dot(mean) - normal;
    add_to_vessel(c, impulse, account.vessel);
    add_to_vessel(c, impulse, on_vessel);
    const auto counts = [&](int body) {
      return bodies.is_free(body) || (accounts_for_vessel() && vessel_->holds(body)) ? 1 : 0;
    };
    const double on_free = counts(c.b) - counts(c.a);
    account.impulse += on_free * impulse;
    account.angular_impulse += on_free * c.p.cross(impulse);
    account.impulse_scale += impulse.norm();
    account.angular_scale += c.p.cross(impulse).norm();
  }
  if (on_vessel.carriage) book_carriage(on_vessel.contact, before, account);
}

/// Index of the carriage among the works; only the joints come after it.
std::size_t ReferenceIntegrator::carriage_work() const {
  return parts_.info.work_names.size() - (parts_.num_parts > 0 ? 2 : 1);
}

/// Books the carriage's impulse: the change of the vessel's momenta minus the impulses of its contacts, about the
/// hull's centre of mass.
void ReferenceIntegrator::book_carriage(const Wrench& contact, const contact::Velocities& before,
                                        ReferenceAccount& account) const {
  const bodies::Bodies& bodies = parts_.bodies;
  const auto hull = static_cast<std::size_t>(parts_.vessel_index);
  Wrench held{-contact.force, -contact.torque};
  for (int k = parts_.vessel_index; vessel_->holds(k); ++k) {
    const auto b = static_cast<std::size_t>(k);
    const Vec3 gained = bodies.mass[b] * (bodies.v_GB[b] - before.v[b]);
    held += {gained,
             (bodies.p_GB[b] - bodies.p_GB[hull]).cross(gained) + bodies.inertia_G(k) * (bodies.w_GB[b] - before.w[b])};
  }
  const vessel::CarriageLoads impulse = vessel_->carriage_impulse(held);
  vessel::CarriageLoads& sum = *account.vessel.carriage;
  sum.about_com += impulse.about_com;
  sum.about_joint += impulse.about_joint;
  for (std::size_t i = 0; i < sum.cells.size(); ++i) sum.cells[i] += impulse.cells[i];
  account.works[carriage_work()] +=
      0.5 * (held.force.dot(bodies.v_GB[hull] + before.v[hull]) + held.torque.dot(bodies.w_GB[hull] + before.w[hull]));
  account.impulse += held.force;
  account.angular_impulse += bodies.p_GB[hull].cross(held.force) + held.torque;
  account.impulse_scale += held.force.norm();
  account.angular_scale += moment_of(bodies.p_GB[hull], held);
}

/// Enters the next smooth stretch of the carriage's motion if the present one ends at t. Returns whether it did.
bool ReferenceIntegrator::enter_stretch(double t, ReferenceStep& step) {
  if (!vessel_ || t < vessel_->stretch_end()) return false;
  const contact::Velocities before{parts_.bodies.v_GB, parts_.bodies.w_GB};
  vessel_->enter_next_stretch(parts_.bodies);
  book({}, before, step.account);
  return true;
}

/// Sets the gaps at which open points close: zero, or slightly less where rounding or a bounce that has just ended
/// leaves a gap of zero.
void ReferenceIntegrator::set_levels(const std::vector<detect::ContactPoint>& points) {
  level_.clear();
  for (const auto& point : points) {
    const double rounding = gap_rounding(point.p);
    if (point.gap >= rounding) continue;
    level_[point.key] = point.gap - (std::abs(approach(point)) <= rest_speed_ ? k_unloaded_slack : rounding);
  }
}

/// Whether some point has sunk in while approaching: the integrator may step over a bounce shorter than its first step.
bool ReferenceIntegrator::sunk() {
  const auto points = contacts_.detect(parts_.bodies);
  return std::any_of(points.begin(), points.end(), [this](const detect::ContactPoint& c) {
    return c.gap < -k_reference_touch && approach(c) < -rest_speed_;
  });
}

void ReferenceIntegrator::count_standstill(double t) {
  constexpr double k_instant = 1e-12;
  standstill_ = std::abs(t - last_event_) <= k_instant * (1 + std::abs(t)) ? standstill_ + 1 : 0;
  last_event_ = t;
  if (standstill_ > k_most_events)
    throw SimulationError(
        fmt::format("at {:g} s integrator 'reference' finds more than {} events at one instant", t, k_most_events));
}

/// The contacts that an event ended although their states had been confirmed: whether the detector finds a point at the
/// very end of its edge depends on rounding, and such a point must not begin again at the same instant.
std::vector<std::uint64_t> ReferenceIntegrator::ended_by(const std::vector<int>& events) const {
  std::vector<std::uint64_t> ended;
  for (const int event : events)
    if (contacts_.trusted() && event % 2 == 1) ended.push_back(contacts_.list()[event / 2].key);
  return ended;
}

/// Handles an event: impulses where points close, then the decision which contacts stay closed, and how. Those with the
/// keys `ended` do not.
void ReferenceIntegrator::settle(double t, ReferenceStep& step, const std::vector<std::uint64_t>& ended) {
  count_standstill(t);
  bodies::Bodies& bodies = parts_.bodies;
  const auto points = contacts_.detect(bodies);
  std::vector<detect::ContactPoint> closed, resting;
  for (const auto& point : points)
    if (point.gap <= k_reference_touch) closed.push_back(point);
  const bool hit = std::any_of(closed.begin(), closed.end(),
                               [this](const detect::ContactPoint& c) { return approach(c) < -rest_speed_; });
  if (hit) impact(t, closed, step);
  for (const auto& point : closed)
    if (std::abs(approach(point)) <= rest_speed_ && std::find(ended.begin(), ended.end(), point.key) == ended.end())
      resting.push_back(point);
  const auto before = contacts_.list();
  contacts_.decide(bodies, free_loads(t), resting, t);
  if (standstill_ >= k_events_to_trust) contacts_.trust_states();
  const contact::Velocities creeping{bodies.v_GB, bodies.w_GB};
  book(contacts_.stop_creep(bodies), creeping, step.account);
  set_levels(points);
  note_changes(t, before, contacts_.list(), step.events);
  smooth_.reset();
  settled_ = true;
}

std::vector<vessel::PartState> ReferenceIntegrator::parts_now(double t) { return vessel_->parts(loads(t).total); }

numerics::OdeStop ReferenceIntegrator::follow(double t1, VecX& y) {
  try {
    return smooth_->follow(t1 - smooth_start_, y);
  } catch (const SimulationError& error) {
    throw SimulationError(fmt::format(
        "between the event at {:.9g} s and {:g} s: {}; integrator 'reference' suits smooth motion of few bodies: use "
        "moreau or semi-implicit-euler",
        smooth_start_, t1, error.what()));
  }
}

ReferenceStep ReferenceIntegrator::advance(double t0, double t1) {
  ReferenceStep step;
  step.account.works.assign(parts_.info.work_names.size(), 0);
  step.account.vessel = no_vessel_loads_;
  if (!settled_ || contacts_.trusted() || sunk()) settle(t0, step);
  for (double t = t0; t < t1;) {
    if (!smooth_) begin_smooth_motion(t, t1 - t0);
    VecX y;
    const double end = vessel_ ? std::min(t1, vessel_->stretch_end()) : t1;
    const numerics::OdeStop stop = follow(end, y);
    const bool reached = stop.events.empty();
    t = reached ? end : smooth_start_ + stop.t;
    state_.unpack(t, y, parts_.bodies);
    if (vessel_) vessel_->demand_regular(t);
    state_.add_account(y - accounted_, step.account);
    accounted_ = y;
    if (enter_stretch(t, step) || !reached) settle(t, step, ended_by(stop.events));
  }
  step.contacts = static_cast<int>(contacts_.list().size());
  for (const SustainedContact& contact : contacts_.list()) step.met.push_back(contact.point);
  return step;
}

}  // namespace nilas::sim
