#include "core/sim/step/load_check.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "contact/problem/islands.h"
#include "contact/problem/row_of.h"
#include "core/sim/world/load_axes.h"

namespace nilas::sim {

namespace {

/// The places of loads in a LoadCheck, by body: the vessel with its parts, or each structure. -1: bears none.
std::vector<int> bearers_of(const World& world) {
  std::vector<int> place(world.size(), -1);
  int count = 0;
  for (std::size_t b = 0; b < world.size(); ++b) {
    if (world.parts.vessel)
      place[b] = world.parts.is_of_vessel(static_cast<int>(b)) ? 0 : -1;
    else if (is_structure(world.parts.bodies, b))
      place[b] = count++;
  }
  return place;
}

/// A contact of ice with what bears a load.
struct IceContact {
  int contact = -1, place = -1;
  double sign = 1;  ///< of the impulse on body b in the load
};

std::vector<IceContact> ice_contacts(const World& world, const std::vector<detect::ContactPoint>& points) {
  const std::vector<int> place = bearers_of(world);
  const auto is_ice = [&](int body) { return world.parts.bodies.kind[body] == bodies::BodyKind::floe; };
  std::vector<IceContact> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int a = points[i].a, b = points[i].b;
    if (place[b] >= 0 && is_ice(a)) found.push_back({static_cast<int>(i), place[b], 1});
    if (place[a] >= 0 && is_ice(b)) found.push_back({static_cast<int>(i), place[a], -1});
  }
  return found;
}

/// The contacts, moments among them, of all islands that have one of `sought`; in rising order.
std::vector<int> islands_with(const contact::ContactProblem& problem, const std::vector<IceContact>& sought) {
  std::vector<char> is_sought(problem.num_contacts(), 0);
  for (const IceContact& c : sought) is_sought[c.contact] = 1;
  std::vector<int> contacts;
  for (const std::vector<int>& island : contact::find_islands(problem))
    if (std::any_of(island.begin(), island.end(), [&](int c) { return is_sought[c] != 0; }))
      contacts.insert(contacts.end(), island.begin(), island.end());
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

/// The problem of these contacts. A pyramid stands for the exact cone, and its loads are compared with those of the
/// cone.
contact::ContactProblem strict_problem(const contact::ContactProblem& problem, const std::vector<int>& contacts) {
  contact::ContactProblem strict = contact::select(problem, contacts);
  if (strict.law == Law::pyramid || strict.law == Law::pyramid_k) strict.law = Law::coulomb;
  return strict;
}

}  // namespace

void check_load(const World& world, const SolvedContacts& solved, const contact::StepMotion& motion,
                std::optional<LoadCheck>& check) {
  const std::vector<IceContact> on_bearers = ice_contacts(world, motion.points);
  if (on_bearers.empty()) return;
  const std::vector<int> contacts = islands_with(solved.contacts.problem, on_bearers);
  const contact::ContactProblem problem = strict_problem(solved.contacts.problem, contacts);
  VecX r(contact::row_of(contacts.size()));
  for (std::size_t i = 0; i < contacts.size(); ++i)
    r.segment<3>(contact::row_of(i)) = solved.solution.r.segment<3>(contact::row_of(contacts[i]));
  const contact::ContactSolution strict = world.load_checks.solver->solve(problem, r);
  if (!check) check.emplace();
  check->is_strict = check->is_strict && strict.status == contact::SolveStatus::converged;
  const std::size_t bearers = world.parts.vessel ? 1 : world.parts.info.structures.size();
  check->load.resize(bearers, Vec3::Zero());
  check->strict.resize(bearers, Vec3::Zero());
  for (const IceContact& c : on_bearers) {
    const auto part = std::lower_bound(contacts.begin(), contacts.end(), c.contact) - contacts.begin();
    const Mat3 C = c.sign / world.step * solved.contacts.C[c.contact];
    check->load[c.place] += C * r.segment<3>(contact::row_of(part));
    check->strict[c.place] += C * strict.r.segment<3>(contact::row_of(part));
  }
}

}  // namespace nilas::sim
