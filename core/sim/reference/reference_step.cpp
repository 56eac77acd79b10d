#include "core/sim/reference/reference_step.h"

#include <utility>

#include "core/sim/account/stopwatch.h"
#include "core/sim/step/step_book.h"
#include "core/sim/world/load_axes.h"

namespace nilas::sim {

/// Loads on the vessel: means over the step, but joint loads at its end.
static VesselRecord vessel_record(World& world, ReferenceIntegrator& reference, const ReferenceVesselLoads& impulses) {
  const auto mean = [&](const Wrench& impulse) -> Wrench {
    return {impulse.force / world.step, impulse.torque / world.step};
  };
  WorldParts& parts = world.parts;
  VesselRecord vessel;
  if (reference.has_vessel()) {
    const auto b = static_cast<std::size_t>(parts.vessel_index);
    const bodies::Bodies& bodies = parts.bodies;
    parts.vessel->follow(world.time(), {{bodies.q_GB[b], bodies.p_GB[b]}, bodies.v_GB[b], bodies.w_GB[b]},
                         reference.parts_now(world.time()));
  }
  for (std::size_t k = 0; k < impulses.on_parts.size(); ++k) {
    const vessel::PartState& part = parts.vessel->parts()[k];
    vessel.parts.push_back({part.joint, mean(impulses.on_parts[k]), part.coordinates, part.rates, part.unbalanced_force,
                            part.unbalanced_torque});
  }
  vessel.contact = mean(impulses.contact);
  vessel.ice = impulses.ice / world.step;
  vessel.touches_ice = !impulses.ice.isZero(0);
  if (impulses.carriage) {
    vessel::CarriageLoads& carriage = vessel.carriage.emplace();
    carriage = {mean(impulses.carriage->about_com), mean(impulses.carriage->about_joint), impulses.carriage->cells, {}};
    for (double& cell : carriage.cells) cell /= world.step;
    vessel.has_cells = parts.info.has_cells;
  }
  if (parts.info.has_hydro) vessel.hydro = mean(impulses.hydro);
  for (const Wrench& load : impulses.modules) vessel.module_loads.push_back(mean(load));
  vessel.state = parts.vessel->state();
  vessel.course = course_at(parts, world.time());
  return vessel;
}

StepRecord take_reference_step(World& world, ReferenceIntegrator& reference) {
  StepRecord record;
  Stopwatch watch(record.ms);
  const bodies::Bodies& bodies = world.parts.bodies;
  const bool with_vessel = reference.accounts_for_vessel();
  const Momenta start = momenta(bodies, with_vessel);
  const double t0 = world.time();
  ++world.steps;
  ReferenceStep done = reference.advance(t0, world.time());
  world.demand_finite(world.time());
  warn_of_unnamed_pairs(world, done.met);
  record.contacts = done.contacts;
  record.residuals = done.residuals;
  world.solved.clear();
  contact::SolvedProblem& last = world.solved.emplace_back(std::move(done.impact));
  last.solution.status = done.status;
  last.solution.iterations = done.iterations;
  last.solution.message = done.message;
  note_solution(world, last.solution, world.time(), record);
  record.events = std::move(done.events);
  watch.lap(Phase::integration);

  const ReferenceAccount& account = done.account;
  world.energy.whole_step(kinetic_energy(bodies), world.potential(), account.works, account.friction, account.impact);
  const Momenta end = momenta(bodies, with_vessel);
  note_end(world,
           {(end.linear - start.linear - account.impulse).norm(), start.linear_size + account.impulse_scale,
            (end.angular - start.angular - account.angular_impulse).norm(), start.angular_size + account.angular_scale},
           record);
  if (world.parts.vessel) record.vessel = vessel_record(world, reference, account.vessel);
  for (const auto& module : world.parts.modules) module->append_values(record.module_values);
  watch.lap(Phase::output);
  stop_on_failure(world, record);
  return record;
}

}  // namespace nilas::sim
