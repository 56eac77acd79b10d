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
  return {std::move(block)};
}

void finish_vessel_step(World& world, contact::StepMotion& motion) {
  if (!vessel_moves(world)) return;
  WorldParts& parts = world.parts;
  std::vector<Wrench> on_parts;
  for (int part = 1; part <= parts.num_parts; ++part)
    on_parts.push_back(contact::contact_impulse_on(motion, parts.vessel_index + part));
  parts.vessel->finish(contact::contact_impulse_on(motion, parts.vessel_index), on_parts);
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
