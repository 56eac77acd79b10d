#include "core/sim/step/choose_substep.h"

#include <algorithm>
#include <cmath>

#include "core/sim/step/advance.h"
#include "core/sim/step/fast_bodies.h"
#include "core/sim/step/find_contacts.h"
#include "core/sim/step/solve_contacts.h"

namespace nilas::sim {

namespace {

/// The vessel as a block without coordinates that continues with its present motion.
std::vector<contact::ArticulatedBlock> vessel_as_it_moves(const World& world, const contact::Velocities& velocities) {
  const WorldParts& parts = world.parts;
  if (!parts.vessel || parts.vessel->fixed()) return {};
  contact::ArticulatedBlock block;
  for (int body = parts.vessel_index; parts.is_of_vessel(body); ++body) {
    const auto b = static_cast<std::size_t>(body);
    Vec6 twist;
    twist << velocities.v[b], velocities.w[b];
    block.bodies.push_back({body, MatX(6, 0), twist});
  }
  return {std::move(block)};
}

/// The velocities at the end of a substep of this length, without the impacts still to come.
contact::Velocities velocities_until_impact(World& world, const Loads& loads, const Substep& substep) {
  const bodies::Bodies& bodies = world.parts.bodies;
  contact::Velocities velocities;
  free_velocities(bodies, loads.total, substep.h, velocities);
  if (detect::fast_pairs(bodies, {velocities.v, velocities.w, substep.h}, world.width, k_fast_share).empty())
    return velocities;
  FoundContacts found = find_contacts(world, loads, substep);
  add_module_contacts(world, substep, found.points);
  if (found.points.empty()) return velocities;
  contact::AssembledContacts contacts =
      contact::assemble(bodies, loads.total, found.points, world.parts.friction, world.model.assembly_over(substep.h),
                        vessel_as_it_moves(world, velocities), world.springs(found.points));
  const contact::PreparedProblem prepared(contacts.problem);
  const contact::ContactSolution solution =
      world.model.solve(contacts.problem, prepared, VecX(), world.slipping).solution;
  return new_velocities(world, contacts, solution, loads, substep.h);
}

/// Error up to which impact times are found [share of the step].
constexpr double k_instant = 1e-9;

}  // namespace

Substep choose_substep(World& world, const Loads& loads, double t, double longest, bool may_cut) {
  if (!may_cut) return {t, longest, false};
  const double shortest = k_shortest_cut * world.step;
  double h = longest;
  constexpr int k_most_passes = 20;
  for (int pass = 0; pass < k_most_passes; ++pass) {
    double first = longest;
    const contact::Velocities velocities = velocities_until_impact(world, loads, {t, h, true});
    for (const detect::SweptPair& pair : sweep(world, velocities, h, longest))
      if (pair.first.hit && pair.first.t * longest >= shortest) first = std::min(first, pair.first.t * longest);
    if (longest - first < shortest) return {t, longest, false};
    if (std::abs(first - h) <= k_instant * world.step) return {t, first, first < longest};
    h = first;
  }
  return {t, h, h < longest};
}

}  // namespace nilas::sim
