#include "core/sim/step/vessel_step.h"

#include <utility>

namespace nilas::sim {

static bool vessel_moves(const World& world) { return world.parts.vessel && !world.parts.vessel->fixed(); }

bool is_booked_whole(const WorldParts& parts) {
  return parts.vessel && parts.vessel->on_carriage() && !parts.is_jointed();
}

static void copy_vessel_state(WorldParts& parts) {
  const auto copy = [&](int body, const vessel::VesselState& state) {
    const auto b = static_cast<std::size_t>(body);
    parts.bodies.set_pose(body, state.pose.p, state.pose.q);
    parts.bodies.v_GB[b] = state.v;
    parts.bodies.w_GB[b] = state.w;
  };
  int body = parts.vessel_index;
  copy(body, parts.vessel->state());
  for (const vessel::PartState& part : parts.vessel->parts()) copy(++body, part.state);
}

void move_vessel_before_impulses(World& world, double h) {
  if (!vessel_moves(world)) return;
  world.parts.vessel->move_before_impulses(h);
  copy_vessel_state(world.parts);
}

void abandon_vessel_step(World& world) {
  if (vessel_moves(world)) world.parts.vessel->abandon_step();
}

Wrench quadratic_water_load(const Mat6& added_G, const Vec3& v, const Vec3& w) {
  Vec6 twist;
  twist << v, w;
  const Vec6 momentum = added_G * twist, carried = added_G.leftCols<3>() * w.cross(v);
  const Vec3 linear = momentum.head<3>(), angular = momentum.tail<3>();
  return {carried.head<3>() - w.cross(linear), carried.tail<3>() - w.cross(angular) - v.cross(linear)};
}

/// Adds the water that moves with the hull to the vessel's block: with the twist V = J u + V_c of the hull and its
/// value V_0 after the last impulses, (M + J^T A J) u = f + J^T A (V_0 - V_c) + impulses.
static void add_hull_water(WorldParts& parts, contact::ArticulatedBlock& block) {
  HullWater& water = *parts.hull_water;
  water.added_G = bodies::turned(water.added_B, parts.bodies.R_GB[parts.vessel_index]);
  const contact::ArticulatedBody& hull = block.bodies.front();
  block.mass += hull.jacobian.transpose() * water.added_G * hull.jacobian;
  block.f += hull.jacobian.transpose() * (water.added_G * (water.twist - hull.prescribed));
  water.block = block;
}

/// The impulse of that water on the hull, -A (V - V_0), under the contact impulses of `motion`.
static Wrench hull_water_impulse(WorldParts& parts, const contact::StepMotion& motion) {
  HullWater& water = *parts.hull_water;
  VecX impulse = water.block.f;
  for (const contact::ArticulatedBody& body : water.block.bodies) {
    const Wrench contact = contact::contact_impulse_on(motion, body.body);
    Vec6 of_contact;
    of_contact << contact.force, contact.torque;
    impulse += body.jacobian.transpose() * of_contact;
  }
  const contact::ArticulatedBody& hull = water.block.bodies.front();
  Vec6 twist = hull.prescribed;
  if (impulse.size() > 0) twist += hull.jacobian * water.block.mass.llt().solve(impulse);
  const Vec6 reaction = -(water.added_G * (twist - water.twist));
  water.twist = twist;
  return {reaction.head<3>(), reaction.tail<3>()};
}

std::vector<contact::ArticulatedBlock> begin_vessel_step(World& world, const bodies::Wrenches& loads, double h) {
  if (!vessel_moves(world)) return {};
  const WorldParts& parts = world.parts;
  const auto hull = loads.begin() + parts.vessel_index;
  vessel::VesselBlock found = world.parts.vessel->begin(*hull, h, {hull + 1, hull + 1 + parts.num_parts});
  contact::ArticulatedBlock block{{}, std::move(found.mass), std::move(found.f)};
  int body = parts.vessel_index;
  block.bodies.push_back({body, std::move(found.hull.jacobian), found.hull.prescribed});
  for (vessel::BodyTwist& part : found.parts)
    block.bodies.push_back({++body, std::move(part.jacobian), part.prescribed});
  if (world.parts.hull_water) add_hull_water(world.parts, block);
  return {std::move(block)};
}

void finish_vessel_step(World& world, Loads& loads, contact::StepMotion& motion) {
  if (!vessel_moves(world)) return;
  WorldParts& parts = world.parts;
  Wrench on_hull = contact::contact_impulse_on(motion, parts.vessel_index);
  if (parts.hull_water) {
    const Wrench of_water = hull_water_impulse(parts, motion);
    on_hull += of_water;
    loads.by_module[parts.hull_water->force][parts.vessel_index] +=
        Wrench{of_water.force / motion.h, of_water.torque / motion.h};
  }
  std::vector<Wrench> on_parts;
  for (int part = 1; part <= parts.num_parts; ++part)
    on_parts.push_back(contact::contact_impulse_on(motion, parts.vessel_index + part));
  parts.vessel->finish(on_hull, on_parts);
  std::vector<Vec6> twists = parts.vessel->part_velocities_after_impulses();
  twists.insert(twists.begin(), parts.vessel->velocity_after_impulses());
  for (std::size_t k = 0; k < twists.size(); ++k) {
    const std::size_t b = static_cast<std::size_t>(parts.vessel_index) + k;
    motion.after.v[b] = twists[k].head<3>();
    motion.after.w[b] = twists[k].tail<3>();
  }
  copy_vessel_state(parts);
}

VesselAccount vessel_account(const World& world, const VesselStart& start) {
  const WorldParts& parts = world.parts;
  VesselAccount account;
  if (!parts.vessel) return account;
  account.index = parts.vessel_index;
  if (parts.is_jointed()) account.joints = &parts.vessel->joint_account();
  if (!is_booked_whole(parts)) return account;
  account.on_carriage = true;
  account.carriage = parts.vessel->carriage_loads().about_com;
  account.inertia_before = start.inertia;
  account.inertia_after = parts.bodies.inertia_G(parts.vessel_index);
  return account;
}

vessel::JointAccount::Motion joint_work_before(const World& world) {
  return world.parts.vessel ? world.parts.vessel->joint_account().before : vessel::JointAccount::Motion{};
}

vessel::JointAccount::Motion joint_work_after(const World& world) {
  return world.parts.vessel ? world.parts.vessel->joint_account().after : vessel::JointAccount::Motion{};
}

}  // namespace nilas::sim
