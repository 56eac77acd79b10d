#include "apps/compare/problems/challenge_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <iterator>
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
constexpr const char* k_jams = "jams";   // folder of scenes whose last steps are wanted, beside the others
constexpr int k_most_for_w = 3000;       // contacts beyond which newton and ipm would take minutes
constexpr int k_most_iterations = 3000;  // unlike a time limit, it gives the same files each time

/// A problem that is to be written.
struct Found {
  std::string name, what;
  contact::ContactProblem problem;
  std::optional<VecX> guess;
};

/// Where problems come from: one of the generated ones, or a scene that must be run first.
struct Source {
  std::string name;
  std::function<std::vector<Found>()> make;
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

Answer best_answer(const contact::ContactProblem& problem, const std::optional<VecX>& guess) {
  Answer best;
  const auto try_from = [&](const char* name, const VecX& start) {
    const contact::SolverEntry& entry = contact::find_solver(name);
    if (problem.has_moments() && !entry.moments) return;
    contact::ContactSolution solution =
        entry.make({.tolerance = k_wanted, .max_iterations = k_most_iterations})->solve(problem, start);
    const double map = contact::measure(problem, solution.r).law_map_m_s;
    if (best.solver.empty() || map < best.law_map) best = {std::move(solution), name, map};
  };
  const auto is_done = [&] { return best.law_map <= k_wanted; };
  try_from("auto", VecX());
  if (!is_done() && guess) try_from("auto", *guess);
  if (problem.num_contacts() > k_most_for_w) return best;
  for (const char* name : {"newton", "ipm"})
    if (!is_done()) try_from(name, VecX());
  return best;
}

/// Writes the file, reads it again and measures its residual. Only one thread may call it at a time, because of HDF5.
Exported write_problem(const fs::path& folder, const Found& source, Answer answer) {
  const contact::ContactProblem& problem = source.problem;
  answer.solution.v = contact::velocities(problem, answer.solution.r);
  answer.solution.u = contact::contact_velocities(problem, answer.solution.v);
  const fs::path file = folder / (source.name + ".hdf5");
  contact::FclibProblem stored;
  stored.problem = problem;
  stored.guess = source.guess;
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

/// The scenes of a folder in the order of their names.
std::vector<fs::path> scenes_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".xml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Found> hardest_of(const std::string& name, const fs::path& file, double until,
                              const std::function<bool()>& stop) {
  auto step = hardest_step(file, until, stop);
  if (!step) return {};
  const std::string what =
      fmt::format("{} at {:.6g} s: {} iterations", file.filename().string(), step->time, step->iterations);
  return {{name, what, std::move(step->problem), {}}};
}

std::vector<Found> last_of(const fs::path& file, double until, const std::function<bool()>& stop) {
  std::vector<Found> all;
  for (StoredStep& step : last_steps(file, until, stop)) {
    Found& one = all.emplace_back();
    one.name = fmt::format("{}-step-{}", file.stem().string(), step.step);
    one.what = fmt::format("{} at {:.6g} s with its warm start", file.filename().string(), step.time);
    one.problem = std::move(step.problem);
    if (step.guess.size() > 0) one.guess = std::move(step.guess);
  }
  return all;
}

std::vector<Source> sources_of(const ProblemExportOptions& options, const std::function<bool()>& stop) {
  std::vector<Source> all;
  if (options.generated)
    for (auto& one : challenges())
      all.push_back({one.name, [one] { return std::vector<Found>{{one.name, one.what, one.problem, {}}}; }});
  if (options.scenes.empty()) return all;
  std::error_code error;
  if (!fs::is_directory(options.scenes, error))
    throw FileError(options.scenes.string() + ": there is no such folder of scenes");
  const std::vector<fs::path> files = scenes_in(options.scenes);
  if (files.empty()) throw InputError(options.scenes.string() + ": found no scene (*.xml)");
  for (const auto& file : files) {
    const std::string name = "scene-" + file.stem().string();
    all.push_back({name, [=, until = options.until_s] { return hardest_of(name, file, until, stop); }});
  }
  if (!fs::is_directory(options.scenes / k_jams, error)) return all;
  for (const auto& file : scenes_in(options.scenes / k_jams))
    all.push_back({file.stem().string(), [=, until = options.until_s] { return last_of(file, until, stop); }});
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

int export_problems(const ProblemExportOptions& options, const std::function<bool()>& stop) {
  const std::vector<Source> sources = sources_of(options, stop);
  output::claim_folder(options.out, options.force);
  std::vector<std::vector<Exported>> slots(sources.size());
  std::mutex writing;
  std::size_t done = 0;
  const auto tell = [&](const std::string& line) {
    if (!options.quiet) std::cerr << fmt::format("{:>3} of {}  {}", done, sources.size(), line);
  };
  verify::run_jobs(sources.size(), options.threads,
                   [&](std::size_t k) {
                     if (stop()) return;
                     std::vector<Found> found = sources[k].make();
                     for (std::size_t i = 0; i < found.size() && !stop(); ++i) {
                       found[i].problem.law = Law::coulomb;
                       Answer answer = best_answer(found[i].problem, found[i].guess);
                       const std::lock_guard hold(writing);
                       slots[k].push_back(write_problem(options.out, found[i], std::move(answer)));
                       if (i + 1 == found.size()) ++done;
                       tell(exported_line(slots[k].back()));
                     }
                     if (stop() || !found.empty()) return;
                     const std::lock_guard hold(writing);
                     ++done;
                     tell(fmt::format("{:<24}the bodies never touch\n", sources[k].name));
                   },
                   {});
  std::vector<Exported> all;
  for (auto& slot : slots) std::move(slot.begin(), slot.end(), std::back_inserter(all));
  output::write_whole(options.out / "problems.csv", exported_table(all));
  if (options.json) std::cout << exported_json(all).dump(2) << "\n";
  const auto certified = std::count_if(all.begin(), all.end(), [](const Exported& one) { return one.certified(); });
  if (!options.quiet && !options.json)
    std::cout << fmt::format("{} problems, {} with certified solutions (law_map_m_s at most {} m/s), in {}\n",
                             all.size(), certified, in_words(k_certified), options.out.string());
  if (done == sources.size()) return exit_done;
  std::cerr << fmt::format("The program was interrupted; {} of {} sources are done.\n", done, sources.size());
  return exit_interrupted;
}

}  // namespace nilas::compare
