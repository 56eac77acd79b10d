#include "core/sim/world/load_checks.h"

#include <algorithm>
#include <cmath>

#include "contact/registry.h"
#include "core/scene/time_steps.h"
#include "core/sim/world/world.h"

namespace nilas::sim {

namespace {

/// By default at most this many steps of a run are checked, and at most one step of so many. A check may cost as much
/// as some steps, so that the second number bounds its share of the time.
constexpr int k_checks = 50, k_least_steps = 100;
/// Tolerance of the second solution [m/s]. Loads of jams then have four right digits, however they were reached.
constexpr double k_strict = 1e-8;
/// Sweeps and factorisations of a second solution at most: a jam that locks would take many times the time of a step.
/// With rolling friction sweeps are all that there is, and the scene says how many.
constexpr int k_most_iterations = 300;

bool has_rigid_friction(const scene::ContactScene& contact) {
  return contact.law.law != Law::frictionless &&
         std::any_of(contact.friction.begin(), contact.friction.end(),
                     [](const scene::FrictionScene& pair) { return !pair.elastic && pair.static_ > 0; });
}

bool rolls(const scene::ContactScene& contact) {
  return std::any_of(contact.friction.begin(), contact.friction.end(),
                     [](const scene::FrictionScene& pair) { return pair.rolling > 0 || pair.spinning > 0; });
}

}  // namespace

LoadChecks build_load_checks(const scene::Scene& scene, const WorldParts& parts, int threads) {
  if (scene.contact.integrator == Integrator::reference || !scene.ice) return {};
  if (scene.twin > 0 || (!parts.vessel && parts.info.structures.empty())) return {};
  const bool asked = scene.output.load_checks.has_value();
  const int most = scene.output.load_checks.value_or(has_rigid_friction(scene.contact) ? k_checks : 0);
  if (most == 0) return {};
  LoadChecks checks;
  const long steps = scene::number_of_steps(scene.time);
  checks.every = std::max((steps + most - 1) / most, static_cast<long>(asked ? 1 : k_least_steps));
  checks.tolerance = std::sqrt(scene.scale) * k_strict;
  contact::SolverSettings settings;
  settings.tolerance = checks.tolerance;
  settings.threads = threads;
  settings.max_iterations = rolls(scene.contact) ? scene.contact.max_iterations : k_most_iterations;
  checks.solver = contact::find_solver(SolverName::automatic).make(settings);
  return checks;
}

}  // namespace nilas::sim
