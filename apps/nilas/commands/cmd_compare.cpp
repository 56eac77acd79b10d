#include <fmt/format.h>

#include <memory>

#include "apps/compare/problems/problem_study.h"
#include "apps/compare/scenes/study.h"
#include "apps/nilas/commands/commands.h"
#include "apps/nilas/commands/scene_flags.h"
#include "core/base/error.h"
#include "core/base/stop_request.h"

namespace nilas {

namespace {

struct CompareOptions {
  StudyOptions study;
  std::string problems;  ///< folder of stored problems, in place of a scene
  SceneFlags scene;
};

int compare_problems(const CompareOptions& options, bool goes_on) {
  const StudyOptions& shared = options.study;
  ProblemStudyOptions study;
  study.folder = options.problems;
  study.solvers = shared.grid.solvers;
  study.laws = shared.grid.laws;
  study.tolerances = shared.grid.tolerances;
  if (shared.budget_s && *shared.budget_s == 0)
    throw InputError(
        "--budget: found 0; with --problems a number above 0 [s], of which the time limit of a solve is a share");
  study.budget_s = shared.budget_s.value_or(0);
  study.jobs = shared.jobs;
  study.out = shared.out;
  study.json = shared.json;
  study.quiet = shared.quiet;
  study.force = shared.force;
  if (goes_on) study.resume = shared.resume;
  return run_problem_study(study, stop_requested);
}

/// Whether a folder holds a study of stored problems and not of a scene.
bool holds_problem_study(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / "compare.json") && !std::filesystem::exists(folder / "study.json");
}

int compare(CompareOptions options) {
  listen_for_stop();
  const bool goes_on = !options.study.resume.empty() && holds_problem_study(options.study.resume);
  if (goes_on && options.study.realisations)
    throw InputError("--seeds: the comparison in " + options.study.resume +
                     " is of stored problems, without realisations");
  if (!options.problems.empty() || goes_on) return compare_problems(options, goes_on);
  options.study.scene = options.scene.file;
  for (const auto& text : options.scene.set) options.study.overrides.push_back(split_override(text));
  if (options.scene.until) options.study.overrides.emplace_back("time/@end", fmt::format("{}", *options.scene.until));
  if (options.scene.seed) options.study.overrides.emplace_back("seed/@value", fmt::format("{}", *options.scene.seed));
  return run_study(options.study, stop_requested);
}

template <class List>
CLI::Option* add_list(CLI::App& command, const std::string& flag, List& values, const std::string& description) {
  return command.add_option(flag, values, description)->delimiter(',')->allow_extra_args(false);
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "compare",
      "runs a scene, or stored contact problems, over solvers, laws, steps and tolerances: what accuracy costs, as "
      "tables and a page");
  auto options = std::make_shared<CompareOptions>();
  StudyOptions& study = options->study;
  auto* scene = command->add_option("scene", options->scene.file, "scene file (XML)");
  auto* problems = command->add_option("--problems", options->problems,
                                       "in place of a scene: a folder of stored contact problems (FCLIB files)");
  add_list(*command, "--solvers", study.grid.solvers, "contact solvers, comma-separated (see nilas solvers)");
  add_list(*command, "--laws", study.grid.laws, "contact laws");
  add_list(*command, "--dt", study.grid.steps, "time steps [s]")->check(above(0));
  add_list(*command, "--tolerance", study.grid.tolerances,
           "tolerances of the solver; 0: always its most iterations [m/s]")
      ->check(at_least(0));
  add_list(*command, "--integrators", study.grid.integrators, "semi-implicit-euler, moreau, reference");
  add_list(*command, "--stabilisations", study.grid.stabilisations,
           "none, baumgarte, split-impulse, tasora, projection");
  auto* ablate = command->add_flag(
      "--ablate", study.grid.ablate,
      "in place of a grid: each simplification of game-engine based simulators, alone and all together");
  command
      ->add_option("--seeds", study.realisations,
                   "realisations of each setting (default: 3, 2 where the budget asks); with --resume: as many in all")
      ->check(at_least(1));
  command->add_option("--reference", study.reference, "auto, or a run folder to judge by")->capture_default_str();
  auto* tolerance = command
                        ->add_option("--reference-tolerance", study.reference_tolerance,
                                     "of the reference's solver; without this flag a budget may loosen it [m/s]")
                        ->check(above(0))
                        ->capture_default_str();
  command
      ->add_option("--budget", study.budget_s,
                   "wall time for all; 0: no limit (default: 1200, of a resumed one its own) [s]")
      ->check(at_least(0));
  command->add_option("--jobs", study.jobs, "runs at a time (default: one per core)")->check(at_least(1));
  auto* resume =
      command->add_option("--resume", study.resume, "in place of a scene: continues the comparison in this folder");
  command->add_option("--out", study.out, "folder (default: runs/<scene>-compare-<time>)");
  command->add_option("--until", options->scene.until, "end time instead of the scene's [s]");
  add_value_flags(*command, options->scene);
  command->add_flag("--keep-runs", study.keep_runs, "keep all outputs of every run, not only summaries and motions");
  command->add_flag("--force", study.force, "write into a folder that is not empty");
  command->add_flag("--json", study.json, "compare.json on stdout and nothing else there");
  command->add_flag("--quiet", study.quiet, "no progress, only warnings and errors");
  for (const char* flag : {"--solvers", "--laws", "--dt", "--tolerance", "--integrators", "--stabilisations"})
    ablate->excludes(flag);
  for (const char* flag : {"--dt", "--integrators", "--stabilisations", "--ablate", "--seeds", "--reference",
                           "--reference-tolerance", "--until", "--seed", "--set", "--keep-runs"})
    problems->excludes(flag);
  problems->excludes(scene);
  ablate->excludes("--reference");
  for (const char* flag : {"scene", "--problems", "--solvers", "--laws", "--dt", "--tolerance", "--integrators",
                           "--stabilisations", "--ablate", "--reference", "--reference-tolerance", "--out", "--until",
                           "--seed", "--set", "--keep-runs", "--force"})
    resume->excludes(flag);
  command->callback([&action, options, scene, tolerance] {
    if (options->study.resume.empty() && options->problems.empty() && scene->count() == 0)
      throw CLI::RequiredError("scene");
    options->study.fixed_reference_tolerance = tolerance->count() > 0;
    action = [options] { return compare(*options); };
  });
}

}  // namespace nilas
