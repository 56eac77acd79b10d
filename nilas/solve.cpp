#include "nilas/solve.h"

#include <algorithm>
#include <chrono>
#include <variant>

#include "contact/measure/measure.h"
#include "contact/registry.h"
#include "core/choices/law.h"
#include "core/output/run/program_versions.h"
#include "nilas/problem_content.h"
#include "nilas/translate.h"

namespace nilas {

namespace {

using Form = std::variant<contact::LocalProblem, contact::ContactProblem>;

Form with_law(Form form, const ParsedLaw& law) {
  std::visit(
      [&](auto& problem) {
        problem.law = law.law;
        if (law.facets > 0) problem.facets = law.facets;
      },
      form);
  return form;
}

Residuals residuals_of(const contact::Residuals& found) {
  return {.law_map_m_s = found.law_map_m_s,
          .natural_map_m_s = found.natural_map_m_s,
          .natural_map_rms_m_s = found.natural_map_rms_m_s,
          .ccp_map_m_s = found.ccp_map_m_s,
          .penetration_rate_m_s = found.penetration_rate_m_s,
          .complementarity_J = found.complementarity_J,
          .cone_violation_m_s = found.cone_violation_m_s,
          .slip_angle_deg = found.slip_angle_deg,
          .creep_m_s = found.creep_m_s,
          .bipotential_J = found.bipotential_J,
          .momentum_sqrtJ = found.momentum_sqrtJ};
}

Residuals measured(const Form& form, const VecX& r) {
  return std::visit([&](const auto& problem) { return residuals_of(contact::measure(problem, r)); }, form);
}

contact::SolverSettings settings_of(const SolveSettings& given) {
  const auto demand = [](bool holds, const char* what) {
    if (!holds) throw Error(ErrorKind::input, what);
  };
  demand(given.tolerance >= 0, "tolerance must be 0 or above");
  demand(given.max_iterations >= 1, "max_iterations must be at least 1");
  demand(given.max_seconds >= 0, "max_seconds must be 0 or above");
  demand(given.threads >= 1, "threads must be at least 1");
  contact::SolverSettings settings;
  settings.tolerance = given.tolerance;
  settings.max_iterations = given.max_iterations;
  settings.max_seconds = given.max_seconds;
  settings.threads = given.threads;
  settings.keep_history = given.keep_history;
  return settings;
}

/// The measured residual decides, whatever the solver says of itself.
contact::SolveStatus judged(const contact::ContactSolution& solution, const Residuals& residuals, double tolerance) {
  const bool is_wrong =
      solution.status == contact::SolveStatus::converged && tolerance > 0 && !(residuals.law_map_m_s <= tolerance);
  return is_wrong ? contact::SolveStatus::stalled : solution.status;
}

/// Sets the velocities to those that follow from the impulses alone, which may be beyond all numbers.
void follow_impulses(const Problem::Content& content, const VecX& r, Solution& solution) {
  if (const auto* local = content.local()) {
    solution.contact_velocities = library::listed(contact::contact_velocities(*local, r));
    return;
  }
  const VecX v = contact::velocities(*content.global(), r);
  solution.contact_velocities = library::listed(contact::contact_velocities(*content.global(), v));
  solution.velocities = library::in_order_of_file(content, v);
}

}  // namespace

Solution solve(const Problem& problem, const SolveSettings& settings, std::span<const double> guess) {
  return library::translated([&] {
    const contact::SolverEntry& entry = contact::find_solver(settings.solver);
    const ParsedLaw law = parse_law(settings.law);
    contact::demand_law(entry, law.law);
    const Form form = with_law(problem.content().stored.problem, law);
    if (const auto* global = std::get_if<contact::ContactProblem>(&form); global && global->has_moments())
      contact::demand_moments(entry, law.law);
    const VecX first = guess.empty() ? VecX() : library::impulses_of(problem.content(), guess, "guess");
    const auto solver = entry.make(settings_of(settings));
    const auto start = std::chrono::steady_clock::now();
    const contact::ContactSolution found = std::visit([&](const auto& p) { return solver->solve(p, first); }, form);
    Solution solution;
    solution.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    solution.impulses = library::listed(found.r);
    follow_impulses(problem.content(), found.r, solution);
    solution.residuals = measured(form, found.r);
    const contact::SolveStatus status = judged(found, solution.residuals, settings.tolerance);
    solution.status = contact::to_string(status);
    solution.converged = status == contact::SolveStatus::converged;
    solution.iterations = found.iterations;
    solution.message = found.message;
    solution.history = found.history;
    return solution;
  });
}

Residuals measure(const Problem& problem, std::span<const double> impulses, const std::string& law) {
  return library::translated([&] {
    const VecX r = library::impulses_of(problem.content(), impulses);
    return measured(with_law(problem.content().stored.problem, parse_law(law)), r);
  });
}

std::vector<SolverInfo> solver_list() {
  std::vector<SolverInfo> all;
  for (const contact::SolverEntry& entry : contact::solver_registry()) {
    SolverInfo info{entry.name, entry.summary, {}};
    for (const Law law : entry.laws) info.laws.emplace_back(contact::to_string(law));
    all.push_back(std::move(info));
  }
  return all;
}

std::string version() { return output::program_versions().at("nilas"); }

}  // namespace nilas
