#include <algorithm>
#include <thread>

#include "apps/compare/problems/challenge_export.h"
#include "apps/nilas/commands/commands.h"
#include "apps/verify/setting.h"

namespace nilas {

namespace {

struct ProblemsFlags {
  ProblemExportOptions shared;
  bool no_scenes = false;
};

int problems(ProblemsFlags flags) {
  if (flags.no_scenes)
    flags.shared.scenes.clear();
  else if (flags.shared.scenes.empty())
    flags.shared.scenes = verify_scenes().parent_path();
  return export_problems(flags.shared);
}

}  // namespace

void add_problems(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("problems", "writes hard contact problems with certified solutions");
  auto flags = std::make_shared<ProblemsFlags>();
  ProblemExportOptions& shared = flags->shared;
  shared.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  command->add_option("--export", shared.out, "folder to write FCLIB files and problems.csv into")->required();
  auto* scenes =
      command->add_option("--scenes", shared.scenes, "folder of scenes whose hardest steps are written (the shipped)");
  command->add_flag("--no-scenes", flags->no_scenes, "the generated challenges alone")->excludes(scenes);
  command->add_option("--until", shared.until_s, "simulated time of each scene at most [s]")
      ->check(at_least(0))
      ->capture_default_str();
  command->add_option("--threads", shared.threads, "problems at a time; the files do not depend on it")
      ->check(at_least(1))
      ->capture_default_str();
  command->add_flag("--json", shared.json, "the table as JSON on stdout");
  command->add_flag("--quiet", shared.quiet, "no progress");
  command->add_flag("--force", shared.force, "write into a folder that is not empty");
  command->callback([&action, flags] { action = [flags] { return problems(*flags); }; });
}

}  // namespace nilas
