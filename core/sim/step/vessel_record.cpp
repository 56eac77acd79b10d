#include "core/sim/step/vessel_record.h"

#include <algorithm>
#include <utility>

#include "core/base/order_free_sum.h"
#include "core/sim/account/load_residual.h"
#include "core/sim/world/course.h"
#include "core/sim/world/load_axes.h"

namespace nilas::sim {

namespace {

/// Sum of the loads on the hull and the parts, about the hull's centre of mass.
Wrench on_whole_vessel(const Wrench& on_hull, std::size_t hull, const contact::StepMotion& motion,
                       const bodies::Wrenches& on_parts) {
  Wrench sum = on_hull;
  for (std::size_t k = 0; k < on_parts.size(); ++k) {
    const Vec3 arm = motion.p[hull + 1 + k] - motion.p[hull];
    sum += {on_parts[k].force, on_parts[k].torque + arm.cross(on_parts[k].force)};
  }
  return sum;
}

Wrench over(const Wrench& impulse, double h) { return {impulse.force / h, impulse.torque / h}; }

std::vector<PartRecord> part_records(const WorldParts& parts, const contact::StepMotion& motion) {
  std::vector<PartRecord> records;
  int body = parts.vessel_index;
  for (const vessel::PartState& part : parts.vessel->parts())
    records.push_back({part.joint, over(contact::contact_impulse_on(motion, ++body), motion.h), part.coordinates,
                       part.rates, part.unbalanced_force, part.unbalanced_torque});
  return records;
}

/// Adds the contact force by side of the hull, and the share of ice in it.
void add_contacts_by_side(const WorldParts& parts, const contact::StepMotion& motion, VesselRecord& record) {
  const auto vessel = static_cast<std::size_t>(parts.vessel_index);
  OrderFreeVectorSum on_port, on_starboard, of_ice;
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    const detect::ContactPoint& c = motion.points[i];
    const bool is_b = parts.is_of_vessel(c.b);
    if (parts.is_of_vessel(c.a) == is_b) continue;
    const bool port = (motion.R[vessel].transpose() * (c.p - motion.p[vessel])).y() > 0;
    const double sign = is_b ? 1 : -1;
    (port ? on_port : on_starboard).add(sign / motion.h * motion.impulses[i]);
    const auto other = static_cast<std::size_t>(is_b ? c.a : c.b);
    if (parts.bodies.kind[other] != bodies::BodyKind::floe || motion.impulses[i].isZero(0)) continue;
    record.touches_ice = true;
    of_ice.add(sign / motion.h * motion.impulses[i]);
  }
  record.ice = of_ice.value();
  record.contact_port = on_port.value();
  record.contact_starboard = on_starboard.value();
}

void add_share(const Wrench& substep, double share, Wrench& step) {
  step += {share * substep.force, share * substep.torque};
}

/// Adds the share of a substep's load. A step without a load so far begins at zero.
void add_share(const std::optional<Wrench>& substep, double share, std::optional<Wrench>& step) {
  if (!substep) return;
  if (!step) step.emplace();
  add_share(*substep, share, *step);
}

void add_share(const std::optional<vessel::CarriageLoads>& substep, double share,
               std::optional<vessel::CarriageLoads>& step) {
  if (!substep) return;
  if (!step) step.emplace();
  add_share(substep->about_com, share, step->about_com);
  add_share(substep->about_joint, share, step->about_joint);
  add_share(substep->disagreement, share, step->disagreement);
  for (std::size_t k = 0; k < substep->cells.size(); ++k) step->cells[k] += share * substep->cells[k];
}

void add_share(const PartRecord& substep, double share, PartRecord& step) {
  add_share(substep.joint, share, step.joint);
  add_share(substep.contact, share, step.contact);
  step.coordinates = substep.coordinates;
  step.rates = substep.rates;
  step.unbalanced_force = std::max(step.unbalanced_force, substep.unbalanced_force);
  step.unbalanced_torque = std::max(step.unbalanced_torque, substep.unbalanced_torque);
}

}  // namespace

VesselRecord vessel_record(const World& world, const Loads& loads, const contact::StepMotion& motion,
                           const contact::SolvedProblem& solved, const std::vector<Mat3>& frames, double t_end) {
  const WorldParts& parts = world.parts;
  const auto hull = static_cast<std::size_t>(parts.vessel_index);
  VesselRecord record;
  record.parts = part_records(parts, motion);
  record.rods = parts.vessel->joint_account().rods;
  bodies::Wrenches on_parts;
  for (const PartRecord& part : record.parts) on_parts.push_back(part.contact);
  record.contact =
      on_whole_vessel(over(contact::contact_impulse_on(motion, parts.vessel_index), motion.h), hull, motion, on_parts);
  const LoadResidual off = load_residual(solved, frames, motion, parts.vessel_index, parts.num_parts, world.threads);
  record.solver_residual = over(off.solver, motion.h);
  record.law_residual = over(off.law, motion.h);
  record.course = course_at(parts, t_end);
  add_contacts_by_side(parts, motion, record);
  record.state = parts.vessel->state();
  if (parts.vessel->on_carriage()) record.carriage = parts.vessel->carriage_loads();
  record.has_cells = parts.info.has_cells;
  if (parts.info.has_hydro) record.hydro.emplace();
  for (std::size_t m = 0; m < loads.by_module.size(); ++m) {
    const auto first = loads.by_module[m].begin() + parts.vessel_index;
    const Wrench load = on_whole_vessel(*first, hull, motion, {first + 1, first + 1 + parts.num_parts});
    const bodies::VesselLoad kind = parts.forces[m]->load_on_vessel();
    if (kind == bodies::VesselLoad::water) *record.hydro += load;
    if (kind == bodies::VesselLoad::own) record.module_loads.push_back(load);
  }
  return record;
}

void add_share(VesselRecord substep, double share, VesselRecord& step) {
  if (share == 1) {
    step = std::move(substep);
    return;
  }
  add_share(substep.contact, share, step.contact);
  add_share(substep.solver_residual, share, step.solver_residual);
  add_share(substep.law_residual, share, step.law_residual);
  step.contact_port += share * substep.contact_port;
  step.contact_starboard += share * substep.contact_starboard;
  step.ice += share * substep.ice;
  add_share(substep.carriage, share, step.carriage);
  add_share(substep.hydro, share, step.hydro);
  step.module_loads.resize(substep.module_loads.size());
  for (std::size_t m = 0; m < substep.module_loads.size(); ++m)
    add_share(substep.module_loads[m], share, step.module_loads[m]);
  step.parts.resize(substep.parts.size());
  for (std::size_t k = 0; k < substep.parts.size(); ++k) add_share(substep.parts[k], share, step.parts[k]);
  if (step.rods.size() == 0) step.rods = VecX::Zero(substep.rods.size());
  step.rods += share * substep.rods;
  step.has_cells = substep.has_cells;
  step.state = substep.state;
  step.course = substep.course;
  step.touches_ice = step.touches_ice || substep.touches_ice;
}

}  // namespace nilas::sim
