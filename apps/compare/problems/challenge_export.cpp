#include "apps/compare/problems/challenge_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <vector>

#include "apps/compare/problems/challenge_catalogue.h"
#include "apps/compare/problems/challenge_scenes.h"
#include "apps/compare/problems/problem_study_plan.h"
#include "apps/compare/workshop/json_store.h"
#include "apps/compare/workshop/special_numbers.h"
#include "apps/verify/jobs.h"
#include "contact/fclib/fclib_io.h"
#include "contact/registry.h"
#include "core/base/error.h"
#include "core/output/file/csv_row.h"
#include "core/output/file/output_file.h"
#include "core/output/run/claim_folder.h"

namespace nilas::compare {

namespace {

namespace fs = std::filesystem;

constexpr double k_wanted = 1e-10, k_certified = 1e-8;  // [m/s]
constexpr int k_most_iterations = 3000;                 // unlike a time limit, it gives the same files each time

/// A problem that is to be written.
struct Source {
  std::string name, what;
  std::function<std::optional<contact::ContactProblem>(std::string& what)> make;
};

struct Exported {
  std::string name, what, solver;
  int contacts = 0, velocities = 0;
  double mass_ratio = 0, law_map = 0;  ///< [m/s]
  bool certified() const { return law_map <= k_certified; }
};

struct Answer {
  contact::ContactSolution solution;
  std::string solver;
  double law_map = k_unknown;
};

Answer best_answer(const contact::ContactProblem& problem) {
  Answer best;
  for (const char* name : {"auto", "newton", "ipm"}) {
    const contact::SolverEntry& entry = contact::find_solver(name);
    if (problem.has_moments() && !entry.moments) continue;
    contact::ContactSolution solution =
        entry.make({.tolerance = k_wanted, .max_iterations = k_most_iterations})->solve(problem, VecX());
    const double map = contact::measure(problem, solution.r).law_map_m_s;
    if (best.solver.empty() || map < best.law_map) best = {std::move(solution), name, map};
    if (best.law_map <= k_wanted) break;
  }
  return best;
}

/// Writes the file, reads it again and measures its residual. Only one thread may call it at a time, because of HDF5.
Exported write_problem(const fs::path& folder, const Source& source, const contact::ContactProblem& problem,
                       Answer answer) {
  answer.solution.v = contact::velocities(problem, answer.solution.r);
  answer.solution.u = contact::contact_velocities(problem, answer.solution.v);
  const fs::path file = folder / (source.name + ".hdf5");
  contact::FclibProblem stored;
  stored.problem = problem;
  stored.title = source.name;
  stored.description = source.what;
  stored.dof_of_file.resize(static_cast<std::size_t>(problem.num_velocities()));
  std::iota(stored.dof_of_file.begin(), stored.dof_of_file.end(), 0);
  contact::write_fclib(file, stored, &answer.solution);
  const contact::FclibProblem read = contact::read_fclib(file);
  const auto& own = std::get<contact::ContactProblem>(read.problem);
  const double map = read.solution ? contact::measure(own, *read.solution).law_map_m_s
                                   : contact::measure(own, VecX::Zero(own.w.size())).law_map_m_s;
  return {source.name, source.what, answer.solver, own.num_points(), own.num_velocities(), contact_mass_ratio(own),
          map};
}

std::vector<Source> sources_of(const ProblemExportOptions& options) {
  std::vector<Source> all;
  if (options.generated)
    for (auto& one : challenges())
      all.push_back({one.name, one.what, [problem = one.problem](std::string&) { return std::optional(problem); }});
  if (options.scenes.empty()) return all;
  std::error_code error;
  if (!fs::is_directory(options.scenes, error))
    throw FileError(options.scenes.string() + ": there is no such folder of scenes");
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(options.scenes))
    if (entry.path().extension() == ".xml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty()) throw InputError(options.scenes.string() + ": found no scene (*.xml)");
  for (const auto& file : files)
    all.push_back({"scene-" + file.stem().string(), "", [file, until = options.until_s](std::string& what) {
                     auto step = hardest_step(file, until);
                     if (!step) return std::optional<contact::ContactProblem>();
                     what = fmt::format("{} at {:.6g} s: {} iterations", file.filename().string(), step->time,
                                        step->iterations);
                     return std::optional(std::move(step->problem));
                   }});
  return all;
}

std::string exported_table(const std::vector<Exported>& all) {
  std::string csv = output::csv_header(
      {"name", "source", "contacts", "velocities", "mass_ratio_1", "law", "solver", "law_map_m_s", "certified"});
  for (const auto& one : all) {
    output::CsvRow row;
    row.text(one.name).text(one.what).integer(one.contacts).integer(one.velocities).shortest(one.mass_ratio);
    row.text("coulomb").text(one.solver).shortest(one.law_map).text(one.certified() ? "yes" : "no");
    csv += row.line();
  }
  return csv;
}

Json exported_json(const std::vector<Exported>& all) {
  Json problems = Json::array();
  for (const auto& one : all)
    problems.push_back({{"name", one.name},
                        {"source", one.what},
                        {"contacts", one.contacts},
                        {"velocities", one.velocities},
                        {"mass_ratio_1", one.mass_ratio},
                        {"law", "coulomb"},
                        {"solver", one.solver},
                        {"law_map_m_s", one.law_map},
                        {"certified", one.certified()}});
  return {{"problems", problems}};
}

std::string exported_line(const Exported& one) {
  return fmt::format("{:<24}{:>6} contacts  {:<7} {:.1e} m/s  {}\n", one.name, one.contacts, one.solver, one.law_map,
                     one.certified() ? "certified" : "NOT certified");
}

}  // namespace

int export_problems(const ProblemExportOptions& options) {
  const std::vector<Source> sources = sources_of(options);
  output::claim_folder(options.out, options.force);
  std::vector<std::optional<Exported>> slots(sources.size());
  std::mutex writing;
  verify::run_jobs(
      sources.size(), options.threads,
      [&](std::size_t k) {
        Source source = sources[k];
        auto problem = source.make(source.what);
        if (problem) {
          problem->law = Law::coulomb;
          Answer answer = best_answer(*problem);
          const std::lock_guard hold(writing);
          slots[k] = write_problem(options.out, source, *problem, std::move(answer));
        }
        if (options.quiet) return;
        const std::lock_guard hold(writing);
        std::cerr << (slots[k] ? exported_line(*slots[k]) : fmt::format("{:<24}the bodies never touch\n", source.name));
      },
      {});
  std::vector<Exported> all;
  for (auto& slot : slots)
    if (slot) all.push_back(std::move(*slot));
  output::write_whole(options.out / "problems.csv", exported_table(all));
  if (options.json) std::cout << exported_json(all).dump(2) << "\n";
  const auto certified = std::count_if(all.begin(), all.end(), [](const Exported& one) { return one.certified(); });
  if (!options.quiet && !options.json)
    std::cout << fmt::format("{} problems, {} with certified solutions (law_map_m_s at most {} m/s), in {}\n",
                             all.size(), certified, in_words(k_certified), options.out.string());
  return 0;
}

}  // namespace nilas::compare
