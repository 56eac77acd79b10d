#include "core/sim/world/contact_model.h"

#include <algorithm>
#include <limits>

#include "contact/measure/measure.h"
#include "contact/registry.h"
#include "contact/solvers/with_retry.h"
#include "core/base/error.h"

namespace nilas::sim {

contact::StaticFrictionSolution ContactModel::solve(contact::ContactProblem& problem,
                                                    const contact::PreparedProblem& prepared, const VecX& guess,
                                                    const contact::SlippingContacts& slipped) const {
  contact::StaticFrictionSolution found;
  if (static_friction)
    found = contact::solve_with_static_friction(*static_friction, *solver, guess, slipped, problem, prepared);
  else
    found = {solver->solve(prepared, guess), {}, 1};
  contact::ContactSolution& solution = found.solution;
  if (sweep_at_rest && solution.iterations == 0 && solution.status == contact::SolveStatus::converged) {
    contact::ContactSolution swept = sweep_at_rest->solve(prepared, solution.r);
    // A sweep may also lead away from the law, by more than was asked for.
    if (!(contact::largest_law_map(prepared, swept.r) <= tolerance)) return found;
    solution.r = std::move(swept.r);
    solution.v = std::move(swept.v);
    solution.u = std::move(swept.u);
  }
  return found;
}

contact::AssemblySettings ContactModel::assembly_over(double h) const {
  contact::AssemblySettings settings = assembly;
  settings.h = h;
  return settings;
}

contact::CorrectionSettings ContactModel::correction_over(double h) const {
  contact::CorrectionSettings settings = correction;
  settings.h = h;
  return settings;
}

/// Tolerance of the position correction [m/s]. Over a step of 0.01 s it is a hundredth of a millimetre, far below the
/// penetration to remove. Where a scene fixes its iterations, it is no more than what the velocities may leave.
constexpr double k_correction_tolerance = 1e-3;

static void set_stabilisation(const scene::ContactScene& contact, double correction_tolerance, ContactModel& model) {
  model.correction.slop = contact.slop;
  switch (contact.stabilisation) {
    case Stabilisation::none:
      break;
    case Stabilisation::baumgarte:
      model.assembly.stabilisation = {contact.erp, contact.slop, contact.max_speed};
      break;
    case Stabilisation::tasora:
      model.assembly.stabilisation = {1, contact.slop, contact.max_speed};
      break;
    case Stabilisation::split_impulse:
      model.position_step = PositionStep::split_impulse;
      model.correction.erp = contact.erp;
      model.correction.max_speed = contact.max_speed;
      model.correction.tolerance = correction_tolerance;
      break;
    case Stabilisation::projection:
      model.position_step = PositionStep::projection;
      model.correction.erp = 1;
      model.correction.max_speed = std::numeric_limits<double>::infinity();
      model.correction.tolerance = contact.tolerance > 0 ? contact.tolerance : correction_tolerance;
      model.correction.max_sweeps = contact.max_iterations;
      break;
  }
}

/// Share of the step's motion that follows the impulses.
static double theta_of(const scene::ContactScene& contact) {
  switch (contact.integrator) {
    case Integrator::moreau:
      return contact.theta;
    case Integrator::semi_implicit_euler:
    case Integrator::reference:
      return 1;
  }
  return 1;
}

bool has_static_friction(const scene::ContactScene& contact) {
  return contact.law.law != Law::frictionless &&
         std::any_of(contact.friction.begin(), contact.friction.end(),
                     [](const scene::FrictionScene& pair) { return pair.static_ > pair.kinetic; });
}

ContactModel build_contact_model(const scene::ContactScene& contact, int threads, double speed_scale) {
  ContactModel model;
  model.assembly.restitution_threshold *= speed_scale;
  model.assembly.law = contact.law.law;
  model.assembly.facets = contact.law.facets;
  model.assembly.axes = contact.axes_deg * k_deg;
  set_stabilisation(contact, speed_scale * k_correction_tolerance, model);
  const contact::SolverEntry& solver = contact::find_solver(contact.solver);
  model.correction.order_free = solver.order_free;
  constexpr int k_extragradient_steps = 1000;  // each costs less than a sweep
  if (solver.order_free) model.correction.max_sweeps = std::max(model.correction.max_sweeps, k_extragradient_steps);
  // A fixed number of iterations applies to the correction as well.
  model.tolerance = contact.tolerance;
  model.fixed_sweeps = contact.tolerance == 0;
  model.correction.finish = model.position_step == PositionStep::projection && !model.fixed_sweeps;
  if (model.fixed_sweeps) model.correction.max_sweeps = std::min(model.correction.max_sweeps, contact.max_iterations);
  model.theta = theta_of(contact);
  model.hit_when_met =
      model.theta < 1 && std::any_of(contact.friction.begin(), contact.friction.end(),
                                     [](const scene::FrictionScene& pair) { return pair.restitution > 0; });
  model.warm_start = contact.warm_start;
  model.stop_on_failure = contact.on_failure == OnFailure::stop && !model.fixed_sweeps;  // no tolerance to miss
  model.detection = contact.detection;
  if (model.detection == Detection::continuous) model.most_substeps = std::max(1, contact.substeps);
  model.margin = contact.margin;
  contact::SolverSettings settings;
  settings.tolerance = contact.tolerance;
  settings.max_iterations = contact.max_iterations;
  settings.threads = threads;
  model.solver = solver.make(settings);
  if (contact.on_failure == OnFailure::retry && !model.fixed_sweeps)
    model.solver = std::make_unique<solvers::WithRetry>(std::move(model.solver),
                                                        contact::find_solver(SolverName::automatic).make(settings));
  const bool any_elastic = std::any_of(contact.friction.begin(), contact.friction.end(),
                                       [](const scene::FrictionScene& pair) { return pair.elastic; });
  if (any_elastic && !solver.order_free)
    model.sweep_at_rest = contact::find_solver(SolverName::nsgs).make({.tolerance = 0, .max_iterations = 1});
  // Slip below ten times the solver's tolerance counts as rest.
  constexpr double k_least_slip = 1e-5;  // [m/s]
  if (has_static_friction(contact))
    model.static_friction = contact::StaticFriction{std::max(speed_scale * k_least_slip, 10 * contact.tolerance)};
  return model;
}

}  // namespace nilas::sim
