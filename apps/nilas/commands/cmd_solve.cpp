#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "apps/nilas/commands/commands.h"
#include "contact/fclib/fclib_io.h"
#include "contact/measure/contact_counts.h"
#include "contact/registry.h"
#include "core/base/error.h"
#include "core/output/text/phase_progress.h"

namespace nilas::commands {

namespace {

using nlohmann::ordered_json;

struct SolveOptions {
  std::string problem, solver = "auto", law = "coulomb", write;
  double tolerance = 1e-8, max_seconds = 60;
  int max_iterations = 100000, threads = 1, repeat = 1;
  bool json = false, quiet = false;
};

/// Solves that take longer than this are not repeated, because the clock is exact enough for them [s].
constexpr double k_short_solve = 0.05;

struct Outcome {
  contact::ContactSolution solution;
  contact::SolveStatus claimed = contact::SolveStatus::numerical_error;  ///< the status that the solver reports
  contact::Residuals residuals;
  contact::ContactCounts counts;
  double seconds = 0;
};

/// Throws FileError if the folder of the target does not exist, before a long solve rather than after it.
void check_target(const std::filesystem::path& target) {
  const auto folder = target.parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder))
    throw FileError(target.string() + ": cannot be written because there is no folder " + folder.string());
}

void set_law(const ParsedLaw& law, contact::FclibProblem& problem) {
  std::visit(
      [&law](auto& form) {
        form.law = law.law;
        if (law.facets > 0) form.facets = law.facets;
      },
      problem.problem);
}

/// Sets the velocities to those that follow from the impulses alone, so that the measured answer is the one written.
void follow_impulses(const contact::LocalProblem& problem, contact::ContactSolution& solution) {
  solution.u = contact::contact_velocities(problem, solution.r);
}

void follow_impulses(const contact::ContactProblem& problem, contact::ContactSolution& solution) {
  solution.v = contact::velocities(problem, solution.r);
  solution.u = contact::contact_velocities(problem, solution.v);
}

template <class Problem>
Outcome solve_form(const Problem& problem, const solvers::ContactSolver& solver, const SolveOptions& options) {
  Outcome out;
  for (int k = 0; k < options.repeat && (k == 0 || out.seconds < k_short_solve); ++k) {
    const auto start = std::chrono::steady_clock::now();
    out.solution = solver.solve(problem, VecX());
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    out.seconds = k == 0 ? seconds : std::min(out.seconds, seconds);
  }
  follow_impulses(problem, out.solution);
  out.residuals = contact::measure(problem, out.solution.r);
  out.counts = contact::count_contacts(problem, out.solution.r, out.solution.u);
  out.claimed = out.solution.status;
  // the measured residual decides, whatever the solver reports
  if (out.claimed == contact::SolveStatus::converged && options.tolerance > 0 &&
      !(out.residuals.law_map_m_s <= options.tolerance))
    out.solution.status = contact::SolveStatus::stalled;
  return out;
}

ordered_json solve_report(const SolveOptions& options, const contact::FclibProblem& problem, const Outcome& outcome) {
  const auto& solution = outcome.solution;
  const bool failed = solution.status == contact::SolveStatus::numerical_error;
  const bool late = solution.status == contact::SolveStatus::iteration_limit && options.max_seconds > 0 &&
                    outcome.seconds >= options.max_seconds;
  ordered_json table{{"problem", std::filesystem::path(options.problem).stem().string()},
                     {"title", problem.title},
                     {"form", problem.num_velocities() > 0 ? "global" : "local"},
                     {"nc", problem.num_contacts()},
                     {"ndof", problem.num_velocities()},
                     {"asymmetry", problem.asymmetry},
                     {"solver", options.solver},
                     {"used", failed || solution.message.empty() ? options.solver : solution.message},
                     {"message", failed ? solution.message
                                 : late ? "--max-time ended the solve"
                                        : ""},
                     {"law", options.law},
                     {"tolerance", options.tolerance},
                     {"status", contact::to_string(solution.status)},
                     {"claimed", contact::to_string(outcome.claimed)},
                     {"iterations", solution.iterations},
                     {"seconds", outcome.seconds},
                     {"open", outcome.counts.open},
                     {"sticking", outcome.counts.sticking},
                     {"sliding", outcome.counts.sliding}};
  for (const auto& column : contact::residual_columns()) table[column.name] = outcome.residuals.*column.member;
  return table;
}

void print(const ordered_json& table, bool json) {
  // titles in FCLIB files may have any encoding
  constexpr auto k_on_bad_text = ordered_json::error_handler_t::replace;
  if (json) {
    std::cout << table.dump(2, ' ', false, k_on_bad_text) << "\n";
    return;
  }
  for (const auto& [name, value] : table.items()) {
    const std::string text = value.is_string()         ? value.template get<std::string>()
                             : value.is_number_float() ? fmt::format("{:.6g}", value.template get<double>())
                                                       : value.dump();
    if (text.empty()) continue;
    std::cout << fmt::format("  {:<22}{}\n", name, text);
  }
}

int solve_problem(const SolveOptions& options) {
  const contact::SolverEntry& entry = contact::find_solver(options.solver);
  const ParsedLaw law = parse_law(options.law);
  contact::demand_law(entry, law.law);
  if (!options.write.empty()) check_target(options.write);
  output::PhaseProgress progress(std::cerr, output::phase_style(options.quiet, options.json), "reading the problem");
  contact::FclibProblem problem = contact::read_fclib(options.problem);
  set_law(law, problem);
  if (const auto* const global = std::get_if<contact::ContactProblem>(&problem.problem);
      global && global->has_moments())
    contact::demand_moments(entry, law.law);
  contact::SolverSettings settings;
  settings.tolerance = options.tolerance;
  settings.max_iterations = options.max_iterations;
  settings.max_seconds = options.max_seconds;
  settings.threads = options.threads;
  const auto solver = entry.make(settings);
  progress.next(fmt::format("solving {} contacts with {}", problem.num_contacts(), options.solver));
  const Outcome outcome =
      std::visit([&](const auto& form) { return solve_form(form, *solver, options); }, problem.problem);
  progress.end();
  print(solve_report(options, problem, outcome), options.json);
  std::cout.flush();
  if (!options.write.empty()) {
    contact::write_fclib(options.write, problem, &outcome.solution);
    if (!options.json) std::cout << "written: " << options.write << "\n";
  }
  return outcome.solution.status == contact::SolveStatus::converged ? exit_done : exit_numerics;
}

}  // namespace

void add_solve(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("solve", "Solves one contact problem in FCLIB format and prints the residuals of the answer.");
  auto options = std::make_shared<SolveOptions>();
  command
      ->add_option("problem", options->problem,
                   "Reads the problem from this FCLIB file (HDF5), which holds a 3-D problem in local or "
                   "global form.")
      ->required();
  command->add_option("--solver", options->solver, "Solves with this solver. `nilas solvers` lists the names.")
      ->capture_default_str();
  command
      ->add_option("--law", options->law,
                   "Solves this contact law: coulomb, ccp, pyramid, pyramid-K with K facets, or frictionless.")
      ->capture_default_str();
  command
      ->add_option("--tolerance", options->tolerance,
                   "Stops the solver at this residual law_map_m_s [m/s]. With 0 it stops only when the residual is 0, "
                   "when it stalls, or when the iterations are spent.")
      ->check(at_least(0))
      ->capture_default_str();
  command
      ->add_option("--max-iterations", options->max_iterations,
                   "Limits the iterations of the solver to this number, at least 1.")
      ->check(at_least(1))
      ->capture_default_str();
  command->add_option("--max-time", options->max_seconds, "Limits the wall time of the solve [s]. 0 sets no limit.")
      ->check(at_least(0))
      ->capture_default_str();
  command
      ->add_option("--threads", options->threads,
                   "Computes on this many threads, at least 1. The results do not depend on the number.")
      ->check(at_least(1))
      ->capture_default_str();
  command
      ->add_option(
          "--repeat", options->repeat,
          "Solves this many times, at least once, and reports the least time. Only solves below 0.05 s are repeated.")
      ->check(at_least(1))
      ->capture_default_str();
  command->add_option("--write", options->write, "Writes the problem and the solution to this FCLIB file.");
  command->add_flag("--json", options->json, "Prints the result as JSON on standard output.");
  command->add_flag("--quiet", options->quiet, "Prints no progress.");
  command->callback([&action, options] { action = [options] { return solve_problem(*options); }; });
}

}  // namespace nilas::commands
