#include "core/sim/step/begin_substep.h"

#include "core/sim/step/advance.h"
#include "core/sim/step/fast_bodies.h"
#include "core/sim/step/substep_plan.h"

namespace nilas::sim {

static bool may_pass_before_impulses(const World& world) {
  return world.model.theta < 1 && world.model.detection == Detection::continuous;
}

/// The longest length up to `longest` [s] in which no bodies pass through each other before the impulses.
static double passable_length(World& world, double t, double longest) {
  const bodies::Bodies& bodies = world.parts.bodies;
  double h = longest;
  if (!may_pass_before_impulses(world)) return h;
  while (const auto pair = passing_bodies(world, {bodies.v_GB, bodies.w_GB}, (1 - world.model.theta) * h)) {
    if (!(h > k_shortest_half * world.step)) refuse_passing(world, *pair, t);
    h /= 2;
  }
  return h;
}

static std::optional<BeforeMotion> before_motion(World& world) {
  if (!may_pass_before_impulses(world)) return std::nullopt;
  for (const auto& module : world.parts.modules) module->remember();
  const bodies::Bodies& bodies = world.parts.bodies;
  return BeforeMotion{bodies.p_GB, bodies.v_GB, bodies.w_GB, bodies.q_GB, bodies.R_GB, world.energy};
}

SubstepStart begin_substep(World& world, double t, double longest) {
  bodies::Bodies& bodies = world.parts.bodies;
  const double theta = world.model.theta;
  SubstepStart start;
  start.h = passable_length(world, t, longest);
  start.to_undo = before_motion(world);
  if (theta < 1) advance(bodies, {bodies.v_GB, bodies.w_GB}, (1 - theta) * start.h, world.gyroscopic, world.threads);
  const bool whole = is_booked_whole(world.parts);
  if (!whole) move_vessel_before_impulses(world, start.h);
  if (theta < 1) world.energy.motion_before_impulses(kinetic_energy(bodies), joint_work_before(world));
  // The energy of a vessel that is booked whole is taken from end to end of the substep.
  if (whole) {
    const auto b = static_cast<std::size_t>(world.parts.vessel_index);
    start.vessel = {bodies.v_GB[b], bodies.w_GB[b], bodies.inertia_G(world.parts.vessel_index)};
    move_vessel_before_impulses(world, start.h);
  }
  world.demand_finite(t);
  return start;
}

void take_back(World& world, const SubstepStart& start) {
  abandon_vessel_step(world);
  if (!start.to_undo) return;
  bodies::Bodies& bodies = world.parts.bodies;
  bodies.p_GB = start.to_undo->p;
  bodies.v_GB = start.to_undo->v;
  bodies.w_GB = start.to_undo->w;
  bodies.q_GB = start.to_undo->q;
  bodies.R_GB = start.to_undo->R;
  world.energy = start.to_undo->energy;
  for (const auto& module : world.parts.modules) module->go_back();
}

}  // namespace nilas::sim
