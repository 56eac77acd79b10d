#include "core/sim/world/world_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/detect/broad/fast_pairs.h"
#include "core/base/error.h"

namespace nilas::sim {

World::World(const scene::Scene& scene, int thread_count, WarningCounts& warning_counts, WorldParts built)
    : parts(std::move(built)),
      warnings(warning_counts),
      threads(thread_count),
      step(scene.time.step),
      start(scene.time.start),
      gravity(scene.gravity),
      gyroscopic(scene.contact.gyroscopic),
      ice_modulus(scene.ice ? scene.ice->youngs_modulus : 0),
      model(build_contact_model(scene.contact, thread_count, std::sqrt(scene.scale))),
      load_checks(build_load_checks(scene, parts, thread_count)),
      detector(thread_count, scene.contact.narrow_phase),
      energy(parts.info.work_names, 0, 0) {
  if (load_checks.solver) {
    parts.info.check_every = load_checks.every;
    parts.info.check_tolerance = load_checks.tolerance;
  }
  if (parts.friction.any_elastic()) elastic.emplace();
  follow_bodies({});
  energy = EnergyAccount(parts.info.work_names, kinetic_energy(parts.bodies), potential());
}

void World::follow_bodies(const std::vector<fracture::NewPiece>& pieces) {
  width = detect::smallest_widths(parts.bodies);
  floes = static_cast<int>(std::count(parts.bodies.kind.begin(), parts.bodies.kind.end(), bodies::BodyKind::floe));
  weight.assign(size(), Wrench{});
  for (std::size_t b = 0; b < size(); ++b) weight[b].force = parts.bodies.mass[b] * gravity;
  if (elastic) {
    edge.assign(size(), 0);
    for (std::size_t b = 0; b < size(); ++b)
      if (parts.bodies.kind[b] == bodies::BodyKind::floe) edge[b] = ice_modulus * parts.bodies.shape[b]->thickness;
  }
  for (const auto& module : parts.modules) module->follow(parts.bodies, pieces);
}

std::vector<contact::Spring> World::springs(const std::vector<detect::ContactPoint>& points) const {
  return elastic ? elastic->springs(parts.bodies, points, parts.friction, edge) : std::vector<contact::Spring>{};
}

double World::potential() {
  double sum = weight_energy(parts.bodies, gravity);
  for (bodies::Module* module : parts.forces)
    if (module->conservative()) sum += module->potential_energy(parts.bodies);
  return sum;
}

void World::demand_finite(double t) const {
  const bodies::Bodies& bodies = parts.bodies;
  for (std::size_t b = 0; b < size(); ++b)
    if (!(bodies.p_GB[b].allFinite() && bodies.v_GB[b].allFinite() && bodies.w_GB[b].allFinite() &&
          bodies.q_GB[b].coeffs().allFinite()))
      throw SimulationError("at " + std::to_string(t) + " s body '" + bodies.name[b] +
                            "' left finite numbers; try a smaller <time step>");
  // Beyond this, squares and volumes soon overflow.
  constexpr double k_beyond = 1e12;
  for (std::size_t b = 0; b < size(); ++b)
    if (!(bodies.p_GB[b].norm() < k_beyond && bodies.v_GB[b].norm() < k_beyond && bodies.w_GB[b].norm() < k_beyond))
      throw SimulationError(fmt::format("at {} s body '{}' is {:.1e} m away at {:.1e} m/s: try a smaller <time step>",
                                        t, bodies.name[b], bodies.p_GB[b].norm(), bodies.v_GB[b].norm()));
}

void World::save(StateWriter out) const {
  out.add("steps", steps);
  parts.bodies.save(out.group("bodies"));
  if (parts.vessel) parts.vessel->save(out.group("vessel"));
  std::vector<int> first, second;
  for (const auto& [a, b] : unnamed_pairs) {
    first.push_back(a);
    second.push_back(b);
  }
  out.add("unnamed_first", first);
  out.add("unnamed_second", second);
  detector.save(out.group("detector"));
  out.add("slipping", slipping);
  warm.save(out.group("warm_start"));
  if (elastic) elastic->save(out.group("elastic"));
  energy.save(out.group("energy"));
  out.add("check_every", load_checks.every);  // a later end would set another
  if (parts.hull_water) out.add("hull_twist", parts.hull_water->twist);
  if (parts.commands->size() > 0) parts.commands->save(out.group("commands"));
  for (const auto& module : parts.modules) module->save(parts.bodies, out.group("module_" + module->name()));
}

void World::restore(const StateReader& in) {
  in.get("steps", steps);
  const auto state_of = [&](const bodies::Module& module) { return in.group("module_" + module.name()); };
  for (const auto& module : parts.modules) module->restore_bodies(state_of(*module), parts.bodies);
  follow_bodies({});
  detector.follow(parts.bodies);
  parts.bodies.restore(in.group("bodies"));
  if (parts.vessel) parts.vessel->restore(in.group("vessel"));
  std::vector<int> first, second;
  in.get("unnamed_first", first);
  in.get("unnamed_second", second);
  if (first.size() != second.size()) in.refuse("unnamed_second", "it has another length than unnamed_first");
  for (std::size_t k = 0; k < first.size(); ++k) unnamed_pairs.emplace(first[k], second[k]);
  if (parts.hull_water) in.get("hull_twist", parts.hull_water->twist);
  if (parts.commands->size() > 0) parts.commands->restore(in.group("commands"));
  detector.restore(parts.bodies, in.group("detector"));
  in.get("slipping", slipping);
  warm.restore(in.group("warm_start"));
  if (elastic) elastic->restore(in.group("elastic"));
  energy.restore(in.group("energy"));
  in.get("check_every", load_checks.every);
  if (load_checks.solver) parts.info.check_every = load_checks.every;
  for (const auto& module : parts.modules) module->restore(state_of(*module));
}

}  // namespace nilas::sim
