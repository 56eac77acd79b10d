#include "core/sim/world/contact_model.h"

#include <algorithm>
#include <limits>

#include "contact/registry.h"
#include "contact/solvers/with_retry.h"
#include "core/base/error.h"

namespace nilas {

StaticFrictionSolution ContactModel::solve(ContactProblem& problem, const VecX& guess,
                                           const SlippingContacts& slipped) const {
  if (static_friction) return solve_with_static_friction(*static_friction, *solver, guess, slipped, problem);
  return {solver->solve(problem, guess), {}, 1};
}

AssemblySettings ContactModel::assembly_over(double h) const {
  AssemblySettings settings = assembly;
  settings.h = h;
  return settings;
}

CorrectionSettings ContactModel::correction_over(double h) const {
  CorrectionSettings settings = correction;
  settings.h = h;
  return settings;
}

NarrowPhase narrow_phase(const ContactScene& contact) {
  if (contact.narrow_phase == "fcl") return NarrowPhase::fcl;
  if (contact.narrow_phase == "nilas-alone") return NarrowPhase::nilas_alone;
  NILAS_DEMAND(contact.narrow_phase == "nilas");
  return NarrowPhase::nilas;
}

static void demand_cuts(const ContactScene& contact) {
  if (contact.substeps > 1 && contact.detection == "continuous" && contact.integrator == "moreau")
    throw InputError(
        "substeps: with integrator moreau the impulses of a step act in the middle of its motion, which a cut at an "
        "impact would move; take integrator semi-implicit-euler, or substeps 0");
}

void demand_contact_choices(const Scene& scene) {
  const auto& friction = scene.contact.friction;
  const bool rolls = std::any_of(friction.begin(), friction.end(),
                                 [](const FrictionScene& pair) { return pair.rolling > 0 || pair.spinning > 0; });
  const bool spins =
      std::any_of(friction.begin(), friction.end(), [](const FrictionScene& pair) { return pair.spinning > 0; });
  try {
    const SolverEntry& solver = find_solver(scene.contact.solver);
    const Law law = parse_law(scene.contact.law).law;
    demand_law(solver, law);
    demand_cuts(scene.contact);
    if (rolls) demand_moments(solver, law);
    if (spins && scene.output.problems != "never")
      throw InputError("spinning friction has no place in FCLIB's form of a problem; <output problems> must be never");
  } catch (const InputError& error) {
    throw InputError(scene.file.string() + ": <contact>: " + error.what());
  }
}

static void set_stabilisation(const ContactScene& contact, ContactModel& model) {
  const std::string& name = contact.stabilisation;
  if (name == "baumgarte") model.assembly.stabilisation = {contact.erp, contact.slop, contact.max_speed};
  if (name == "tasora") model.assembly.stabilisation = {1, contact.slop, contact.max_speed};
  if (name == "split-impulse") {
    model.position_step = PositionStep::split_impulse;
    model.correction.erp = contact.erp;
    model.correction.max_speed = contact.max_speed;
    // a hundredth of a millimetre per step at 0.01 s: far below what the split impulse is to remove
    constexpr double k_correction_tolerance = 1e-3;  // [m/s]
    model.correction.tolerance = k_correction_tolerance;
  }
  if (name == "projection") {
    model.position_step = PositionStep::projection;
    model.correction.erp = 1;
    model.correction.max_speed = std::numeric_limits<double>::infinity();
    // over a step, no more than what the velocities may leave
    constexpr double k_fixed_sweeps_tolerance = 1e-3;  // [m/s]
    model.correction.tolerance = contact.tolerance > 0 ? contact.tolerance : k_fixed_sweeps_tolerance;
    model.correction.max_sweeps = contact.max_iterations;
  }
  model.correction.slop = contact.slop;
}

ContactModel build_contact_model(const ContactScene& contact, int threads) {
  ContactModel model;
  const ParsedLaw law = parse_law(contact.law);
  model.assembly.law = law.law;
  model.assembly.facets = law.facets;
  model.assembly.axes = contact.axes_deg * k_deg;
  set_stabilisation(contact, model);
  const SolverEntry& solver = find_solver(contact.solver);
  model.correction.order_free = solver.order_free;
  constexpr int k_extragradient_steps = 1000;  // each does less than a sweep
  if (solver.order_free) model.correction.max_sweeps = std::max(model.correction.max_sweeps, k_extragradient_steps);
  // a scene that fixes its sweeps means these too
  model.tolerance = contact.tolerance;
  model.fixed_sweeps = contact.tolerance == 0;
  if (model.fixed_sweeps) model.correction.max_sweeps = std::min(model.correction.max_sweeps, contact.max_iterations);
  if (contact.integrator == "moreau") model.theta = contact.theta;
  model.hit_when_met = model.theta < 1 && std::any_of(contact.friction.begin(), contact.friction.end(),
                                                      [](const FrictionScene& pair) { return pair.restitution > 0; });
  model.warm_start = contact.warm_start;
  model.stop_on_failure = contact.on_failure == "stop" && !model.fixed_sweeps;  // they promise nothing
  if (contact.detection == "discrete") model.detection = Detection::discrete;
  if (contact.detection == "speculative") model.detection = Detection::speculative;
  if (model.detection == Detection::continuous) model.most_substeps = std::max(1, contact.substeps);
  model.margin = contact.margin;
  SolverSettings settings;
  settings.tolerance = contact.tolerance;
  settings.max_iterations = contact.max_iterations;
  settings.threads = threads;
  model.solver = solver.make(settings);
  if (contact.on_failure == "retry" && !model.fixed_sweeps)
    model.solver = std::make_unique<WithRetry>(std::move(model.solver), find_solver("auto").make(settings));
  // slower than ten times what the solver may leave is rest
  constexpr double k_least_slip = 1e-5;  // [m/s]
  const bool two_coefficients = std::any_of(contact.friction.begin(), contact.friction.end(),
                                            [](const FrictionScene& pair) { return pair.static_ > pair.kinetic; });
  if (two_coefficients && law.law != Law::frictionless)
    model.static_friction = StaticFriction{std::max(k_least_slip, 10 * contact.tolerance)};
  return model;
}

}  // namespace nilas
