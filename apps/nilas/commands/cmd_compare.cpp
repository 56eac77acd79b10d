#include <fmt/format.h>

#include <memory>

#include "apps/compare/problems/problem_study.h"
#include "apps/compare/scenes/study.h"
#include "apps/nilas/commands/commands.h"
#include "apps/nilas/commands/scene_flags.h"
#include "core/base/error.h"
#include "core/base/stop_request.h"

namespace nilas::commands {

namespace {

struct CompareOptions {
  compare::StudyOptions study;
  std::string problems;  ///< folder of stored problems; empty: a scene is compared
  SceneFlags scene;
};

int compare_problems(const CompareOptions& options, bool goes_on) {
  const compare::StudyOptions& shared = options.study;
  compare::ProblemStudyOptions study;
  study.folder = options.problems;
  study.solvers = shared.grid.solvers;
  study.laws = shared.grid.laws;
  study.tolerances = shared.grid.tolerances;
  if (shared.budget_s && *shared.budget_s == 0)
    throw InputError(
        "--budget: found 0; allowed with --problems: a number above 0 [s], since the time limit of a solve is a share "
        "of it");
  study.budget_s = shared.budget_s.value_or(0);
  study.jobs = shared.jobs;
  study.out = shared.out;
  study.json = shared.json;
  study.quiet = shared.quiet;
  study.force = shared.force;
  if (goes_on) study.resume = shared.resume;
  return compare::run_problem_study(study, stop_requested);
}

/// Whether the comparison in a folder is of stored problems and not of a scene.
bool holds_problem_study(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / "compare.json") && !std::filesystem::exists(folder / "study.json");
}

int compare(CompareOptions options) {
  listen_for_stop();
  const bool goes_on = !options.study.resume.empty() && holds_problem_study(options.study.resume);
  if (goes_on && options.study.realisations)
    throw InputError("--seeds: the comparison in " + options.study.resume +
                     " is of stored problems, which have no realisations");
  if (!options.problems.empty() || goes_on) return compare_problems(options, goes_on);
  options.study.scene = options.scene.file;
  for (const auto& text : options.scene.set) options.study.overrides.push_back(scene::split_override(text));
  if (options.scene.until) options.study.overrides.emplace_back("time/@end", fmt::format("{}", *options.scene.until));
  if (options.scene.seed) options.study.overrides.emplace_back("seed/@value", fmt::format("{}", *options.scene.seed));
  return compare::run_study(options.study, stop_requested);
}

template <class List>
CLI::Option* add_list(CLI::App& command, const std::string& flag, List& values, const std::string& description) {
  return command.add_option(flag, values, description)->delimiter(',')->allow_extra_args(false);
}

/// Adds the flags that say what is compared. Returns that of an ablation.
CLI::Option* add_grid_flags(CLI::App& command, compare::GridRequest& grid) {
  add_list(command, "--solvers", grid.solvers,
           "Compares these contact solvers, separated by commas. `nilas solvers` lists the names.");
  add_list(command, "--laws", grid.laws, "Compares these contact laws, separated by commas.");
  add_list(command, "--dt", grid.steps, "Compares these time steps [s], above 0 and separated by commas.")
      ->check(above(0));
  add_list(command, "--tolerance", grid.tolerances,
           "Compares these tolerances of the solver [m/s], separated by commas. With 0 a solver stops only when "
           "the residual is 0, when it stalls, or when the iterations are spent.")
      ->check(at_least(0));
  add_list(command, "--integrators", grid.integrators,
           "Compares these integrators: semi-implicit-euler, moreau or reference.");
  add_list(command, "--stabilisations", grid.stabilisations,
           "Compares these stabilisations: none, baumgarte, split-impulse, tasora or projection.");
  return command.add_flag(
      "--ablate", grid.ablate,
      "Compares the simplifications of game-engine based simulators, each alone and all together, instead of a grid of "
      "settings.");
}

/// Adds the flags of the realisations, the reference and the budget. Returns that of the reference's tolerance.
CLI::Option* add_effort_flags(CLI::App& command, compare::StudyOptions& study) {
  command
      .add_option("--seeds", study.realisations,
                  "Makes this many realisations of each setting, at least 1. The default is 3, or fewer if the budget "
                  "is short. "
                  "With --resume it is the total number.")
      ->check(at_least(1));
  command
      .add_option("--reference", study.reference,
                  "Measures errors against this reference: auto, or the folder of a run.")
      ->capture_default_str();
  auto* tolerance = command
                        .add_option("--reference-tolerance", study.reference_tolerance,
                                    "Solves the reference to this tolerance [m/s], above 0. Without this flag a short "
                                    "budget may loosen it.")
                        ->check(above(0))
                        ->capture_default_str();
  command
      .add_option("--budget", study.budget_s,
                  "Limits the wall time of the comparison [s]. The default is 1200, or the budget that a resumed "
                  "comparison has. "
                  "0 sets no limit for a scene.")
      ->check(at_least(0));
  command.add_option("--jobs", study.jobs, "Makes this many runs at a time, at least 1. The default is one per core.")
      ->check(at_least(1));
  return tolerance;
}

/// Adds the flags of the folder, the changes of the scene and the output. Returns that of the folder to resume.
CLI::Option* add_output_flags(CLI::App& command, CompareOptions& options) {
  compare::StudyOptions& study = options.study;
  auto* resume = command.add_option("--resume", study.resume,
                                    "Continues the comparison in this folder. It replaces the scene argument.");
  command.add_option("--out", study.out, "Writes into this folder. The default is runs/<scene>-compare-<time>.");
  command.add_option("--until", options.scene.until, "Ends at this simulated time [s] instead of the scene's end.");
  add_value_flags(command, options.scene);
  command.add_flag("--keep-runs", study.keep_runs,
                   "Keeps all outputs of every run, not only summaries, motions and ice loads.");
  command.add_flag("--force", study.force,
                   "Writes into the folder even if it is not empty. Files of an earlier comparison there are removed.");
  command.add_flag("--json", study.json, "Prints compare.json on standard output, and nothing else there.");
  command.add_flag("--quiet", study.quiet, "Prints only warnings and errors, no progress.");
  return resume;
}

/// The flags and arguments on which the exclusions depend.
struct ExcludingFlags {
  CLI::Option *scene, *problems, *ablate, *resume;
};

/// Refuses flags that have no meaning together.
void exclude_flags(const ExcludingFlags& flags) {
  for (const char* flag : {"--solvers", "--laws", "--dt", "--tolerance", "--integrators", "--stabilisations"})
    flags.ablate->excludes(flag);
  for (const char* flag : {"--dt", "--integrators", "--stabilisations", "--ablate", "--seeds", "--reference",
                           "--reference-tolerance", "--until", "--seed", "--set", "--keep-runs"})
    flags.problems->excludes(flag);
  flags.problems->excludes(flags.scene);
  flags.ablate->excludes("--reference");
  for (const char* flag : {"scene", "--problems", "--solvers", "--laws", "--dt", "--tolerance", "--integrators",
                           "--stabilisations", "--ablate", "--reference", "--reference-tolerance", "--out", "--until",
                           "--seed", "--set", "--keep-runs", "--force"})
    flags.resume->excludes(flag);
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("compare",
                                     "Compares solvers, laws, steps and tolerances on a scene or on stored contact "
                                     "problems. Tables and a page show what "
                                     "accuracy costs.");
  auto options = std::make_shared<CompareOptions>();
  auto* scene = command->add_option("scene", options->scene.file, "Compares on the scene in this XML file.");
  auto* problems =
      command->add_option("--problems", options->problems,
                          "Compares on the stored contact problems (FCLIB files) in this folder instead of on a "
                          "scene.");
  auto* ablate = add_grid_flags(*command, options->study.grid);
  auto* tolerance = add_effort_flags(*command, options->study);
  auto* resume = add_output_flags(*command, *options);
  exclude_flags({scene, problems, ablate, resume});
  command->callback([&action, options, scene, tolerance] {
    if (options->study.resume.empty() && options->problems.empty() && scene->count() == 0)
      throw CLI::RequiredError("scene");
    options->study.fixed_reference_tolerance = tolerance->count() > 0;
    action = [options] { return compare(*options); };
  });
}

}  // namespace nilas::commands
