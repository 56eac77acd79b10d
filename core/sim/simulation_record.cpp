/// What a step leaves: accounts, records, warnings, and the state for a checkpoint.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/order_free_sum.h"
#include "core/sim/account/load_residual.h"
#include "core/sim/build/load_axes.h"
#include "core/sim/simulation_world.h"

namespace nilas {

/// The worst of all solutions of the step.
void Simulation::World::note_residuals(const Residuals& residuals, StepRecord& record) {
  if (!(residuals.law_map_m_s < record.residuals.law_map_m_s)) record.residuals = residuals;
}

void Simulation::World::note_solution(const ContactSolution& solution, StepRecord& record) const {
  record.iterations += solution.iterations;
  if (solution.status >= record.status) {
    record.status = solution.status;
    record.solver_message = solution.message;
  }
  const bool as_asked = solution.status == SolveStatus::converged ||
                        (model.fixed_sweeps && solution.status == SolveStatus::iteration_limit);
  record.solver_short = record.solver_short || !as_asked;
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
  if (!parts.vessel) return account;
  account.index = parts.vessel_index;
  if (parts.is_jointed()) account.joints = &parts.vessel->joint_account();
  if (!is_booked_whole()) return account;
  account.on_carriage = true;
  account.carriage = parts.vessel->carriage_loads().about_com;
  account.inertia_before = vessel_start.inertia;
  account.inertia_after = parts.bodies.inertia_G(parts.vessel_index);
  return account;
}

/// Loads on the hull and the parts about the hull's centre of mass.
Wrench Simulation::World::on_whole_vessel(const Wrench& on_hull, const StepMotion& motion,
                                          const Wrenches& on_parts) const {
  Wrench sum = on_hull;
  const auto hull = static_cast<std::size_t>(parts.vessel_index);
  for (std::size_t k = 0; k < on_parts.size(); ++k) {
    const Vec3 arm = motion.p[hull + 1 + k] - motion.p[hull];
    sum += {on_parts[k].force, on_parts[k].torque + arm.cross(on_parts[k].force)};
  }
  return sum;
}

std::vector<PartRecord> Simulation::World::part_records(const StepMotion& motion) const {
  std::vector<PartRecord> records;
  int body = parts.vessel_index;
  for (const PartState& part : parts.vessel->parts()) {
    const Wrench impulse = contact_impulse_on(motion, ++body);
    records.push_back({part.joint,
                       {impulse.force / h, impulse.torque / h},
                       part.coordinates,
                       part.rates,
                       part.unbalanced_force,
                       part.unbalanced_torque});
  }
  return records;
}

VesselRecord Simulation::World::vessel_record(const StepMotion& motion, const std::vector<Mat3>& C) const {
  VesselRecord record;
  record.parts = part_records(motion);
  record.rods = parts.vessel->joint_account().rods;
  const Wrench impulse = contact_impulse_on(motion, parts.vessel_index);
  Wrenches on_parts;
  for (const PartRecord& part : record.parts) on_parts.push_back(part.contact);
  record.contact = on_whole_vessel({impulse.force / h, impulse.torque / h}, motion, on_parts);
  const LoadResidual off = load_residual(solved.back(), C, motion, parts.vessel_index, parts.num_parts);
  record.solver_residual = {off.solver.force / h, off.solver.torque / h};
  record.law_residual = {off.law.force / h, off.law.torque / h};
  const auto vessel = static_cast<std::size_t>(parts.vessel_index);
  OrderFreeVectorSum on_port, on_starboard, of_ice;
  record.course = course_at(parts, time() + h);
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    const ContactPoint& c = motion.points[i];
    const bool is_b = parts.is_of_vessel(c.b);
    if (parts.is_of_vessel(c.a) == is_b) continue;
    const bool port = (motion.R[vessel].transpose() * (c.p - motion.p[vessel])).y() > 0;
    const double sign = is_b ? 1 : -1;
    (port ? on_port : on_starboard).add(sign / h * motion.impulses[i]);
    const auto other = static_cast<std::size_t>(is_b ? c.a : c.b);
    if (parts.bodies.kind[other] != BodyKind::floe || motion.impulses[i].isZero(0)) continue;
    record.touches_ice = true;
    of_ice.add(sign / h * motion.impulses[i]);
  }
  record.ice = of_ice.value();
  record.contact_port = on_port.value();
  record.contact_starboard = on_starboard.value();
  record.state = parts.vessel->state();
  if (parts.vessel->on_carriage()) record.carriage = parts.vessel->carriage_loads();
  record.has_cells = parts.info.has_cells;
  if (parts.info.has_hydro) {
    record.hydro.emplace();
    for (const auto& loads : module_loads)
      *record.hydro += on_whole_vessel(loads[static_cast<std::size_t>(parts.vessel_index)], motion, of_parts(loads));
  }
  return record;
}

/// Loads are means over the step; those in the joints are of its end.
void Simulation::World::note_reference_vessel(const ReferenceVesselLoads& impulses, StepRecord& record) {
  const auto mean = [&](const Wrench& impulse) -> Wrench {
    return {impulse.force / whole_step, impulse.torque / whole_step};
  };
  VesselRecord& vessel = record.vessel.emplace();
  if (reference->has_vessel()) {
    const auto b = static_cast<std::size_t>(parts.vessel_index);
    const Bodies& bodies = parts.bodies;
    parts.vessel->follow(time(), {{bodies.q_GB[b], bodies.p_GB[b]}, bodies.v_GB[b], bodies.w_GB[b]},
                         reference->parts_now(time()));
  }
  for (std::size_t k = 0; k < impulses.on_parts.size(); ++k) {
    const PartState& part = parts.vessel->parts()[k];
    vessel.parts.push_back({part.joint, mean(impulses.on_parts[k]), part.coordinates, part.rates, part.unbalanced_force,
                            part.unbalanced_torque});
  }
  vessel.contact = mean(impulses.contact);
  vessel.ice = impulses.ice / whole_step;
  vessel.touches_ice = !impulses.ice.isZero(0);
  if (impulses.carriage) {
    CarriageLoads& carriage = vessel.carriage.emplace();
    carriage = {mean(impulses.carriage->about_com), mean(impulses.carriage->about_joint), impulses.carriage->cells, {}};
    for (double& cell : carriage.cells) cell /= whole_step;
    vessel.has_cells = parts.info.has_cells;
  }
  if (parts.info.has_hydro) vessel.hydro = mean(impulses.hydro);
  vessel.state = parts.vessel->state();
  vessel.course = course_at(parts, time());
}

static void add_share(const Wrench& part, double share, Wrench& sum) {
  sum += {share * part.force, share * part.torque};
}

/// Loads are means over the step: each part adds its share.
void Simulation::World::note_vessel(const StepMotion& motion, const std::vector<Mat3>& C, StepRecord& record) const {
  VesselRecord part = vessel_record(motion, C);
  if (h == whole_step) {
    record.vessel = std::move(part);
    return;
  }
  const double share = h / whole_step;
  if (!record.vessel) record.vessel.emplace();
  VesselRecord& sum = *record.vessel;
  add_share(part.contact, share, sum.contact);
  add_share(part.solver_residual, share, sum.solver_residual);
  add_share(part.law_residual, share, sum.law_residual);
  sum.contact_port += share * part.contact_port;
  sum.contact_starboard += share * part.contact_starboard;
  sum.ice += share * part.ice;
  if (part.carriage) {
    if (!sum.carriage) sum.carriage.emplace();
    add_share(part.carriage->about_com, share, sum.carriage->about_com);
    add_share(part.carriage->about_joint, share, sum.carriage->about_joint);
    if (part.carriage->disagreement) {
      if (!sum.carriage->disagreement) sum.carriage->disagreement.emplace();
      add_share(*part.carriage->disagreement, share, *sum.carriage->disagreement);
    }
    for (std::size_t k = 0; k < part.carriage->cells.size(); ++k)
      sum.carriage->cells[k] += share * part.carriage->cells[k];
  }
  if (part.hydro) {
    if (!sum.hydro) sum.hydro.emplace();
    add_share(*part.hydro, share, *sum.hydro);
  }
  sum.parts.resize(part.parts.size());
  for (std::size_t k = 0; k < part.parts.size(); ++k) {
    const PartRecord& now = part.parts[k];
    PartRecord& whole = sum.parts[k];
    add_share(now.joint, share, whole.joint);
    add_share(now.contact, share, whole.contact);
    whole.coordinates = now.coordinates;
    whole.rates = now.rates;
    whole.unbalanced_force = std::max(whole.unbalanced_force, now.unbalanced_force);
    whole.unbalanced_torque = std::max(whole.unbalanced_torque, now.unbalanced_torque);
  }
  if (sum.rods.size() == 0) sum.rods = VecX::Zero(part.rods.size());
  sum.rods += share * part.rods;
  sum.has_cells = part.has_cells;
  sum.state = part.state;
  sum.course = part.course;
  sum.touches_ice = sum.touches_ice || part.touches_ice;
}

/// Adds the share of the part of the step at work.
void Simulation::World::note_structures(const StepMotion& motion, StepRecord& record) const {
  const auto& structures = parts.info.structures;
  // floes that broke have moved the bodies behind them; their order stays
  std::vector<int> places;
  for (std::size_t b = 0; b < parts.bodies.id.size(); ++b)
    if (is_structure(parts.bodies, b)) places.push_back(static_cast<int>(b));
  const auto structure_of = [&](int body) {
    const auto found = std::lower_bound(places.begin(), places.end(), body);
    return found != places.end() && *found == body ? found - places.begin() : -1;
  };
  struct Sums {
    OrderFreeVectorSum force, torque, ice;
  };
  std::vector<Sums> sums(structures.size());
  record.structures.resize(structures.size());
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    const ContactPoint& c = motion.points[i];
    for (const auto& [body, other, sign] : {std::tuple(c.a, c.b, -1.0), std::tuple(c.b, c.a, 1.0)}) {
      const auto k = structure_of(body);
      if (k < 0 || motion.impulses[i].isZero(0)) continue;
      Sums& sum = sums[static_cast<std::size_t>(k)];
      sum.force.add(sign * motion.impulses[i]);
      sum.torque.add((c.p - motion.p[static_cast<std::size_t>(body)]).cross(sign * motion.impulses[i]));
      if (!motion.couples.empty()) sum.torque.add(sign * motion.couples[i]);
      if (parts.bodies.kind[static_cast<std::size_t>(other)] != BodyKind::floe) continue;
      record.structures[static_cast<std::size_t>(k)].touches_ice = true;
      sum.ice.add(sign * motion.impulses[i]);
    }
  }
  for (std::size_t k = 0; k < sums.size(); ++k) {
    record.structures[k].contact += {sums[k].force.value() / whole_step, sums[k].torque.value() / whole_step};
    record.structures[k].ice += sums[k].ice.value() / whole_step;
  }
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
  // squares and volumes of what is farther or faster than this overflow long before it does
  constexpr double k_beyond = 1e12;
  for (std::size_t b = 0; b < size(); ++b)
    if (!(bodies.p_GB[b].norm() < k_beyond && bodies.v_GB[b].norm() < k_beyond && bodies.w_GB[b].norm() < k_beyond))
      throw SimulationError(fmt::format("at {} s body '{}' is {:.1e} m away at {:.1e} m/s: try a smaller <time step>",
                                        time(), bodies.name[b], bodies.p_GB[b].norm(), bodies.v_GB[b].norm()));
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
  if (pieces) pieces->save(parts.bodies, out.group("pieces"));
  parts.bodies.save(out.group("bodies"));
  if (parts.vessel) parts.vessel->save(out.group("vessel"));
  parts.friction.save(out.group("friction"));
  out.add("pairs_named", pairs_named);
  detector.save(out.group("detector"));
  if (model.static_friction) model.static_friction->save(out.group("static_friction"));
  warm.save(out.group("warm_start"));
  if (breaking) breaking->save(out.group("breaking"));
  if (pieces) broken_contacts.save(out.group("broken_contacts"));
  energy.save(out.group("energy"));
  if (crushing) crushing->save(out.group("crushing"));
}

void Simulation::World::restore(const StateReader& in) {
  in.get("steps", steps);
  if (pieces) {
    pieces->restore(in.group("pieces"), parts.bodies, *parts.ice_properties);
    follow_bodies({});
  }
  parts.bodies.restore(in.group("bodies"));
  if (parts.vessel) parts.vessel->restore(in.group("vessel"));
  parts.friction.restore(in.group("friction"));
  in.get("pairs_named", pairs_named);
  detector.restore(parts.bodies, in.group("detector"));
  if (model.static_friction) model.static_friction->restore(in.group("static_friction"));
  warm.restore(in.group("warm_start"));
  if (breaking) breaking->restore(in.group("breaking"));
  if (pieces) broken_contacts.restore(in.group("broken_contacts"));
  energy.restore(in.group("energy"));
  if (crushing) crushing->restore(in.group("crushing"));
}

/// What every record holds at its end, whatever moved the bodies.
void Simulation::World::note_end(const MomentumBalance& balance, StepRecord& record) const {
  record.step = steps;
  record.t = time();
  record.h = whole_step;
  record.floes = floes;
  record.ledger = energy.ledger();
  record.momentum_imbalance = balance.linear;
  record.momentum_scale = balance.linear_scale;
  record.angular_momentum_imbalance = balance.angular;
  record.angular_momentum_scale = balance.angular_scale;
  record.state_hash = state_hash();
}

void Simulation::World::stop_on_failure(const StepRecord& record) const {
  if (!model.stop_on_failure || record.status == SolveStatus::converged || last().problem.num_contacts() == 0) return;
  throw SimulationError(fmt::format("at {:g} s the contact solver stopped with status {}, law_map_m_s {:.3g}{}",
                                    record.t, to_string(record.status), record.residuals.law_map_m_s,
                                    record.solver_message.empty() ? "" : ": " + record.solver_message));
}

}  // namespace nilas
