#include <algorithm>
#include <thread>

#include "apps/compare/problems/challenge_export.h"
#include "apps/nilas/commands/commands.h"
#include "apps/verify/setting.h"
#include "core/base/stop_request.h"

namespace nilas::commands {

namespace {

struct ProblemsFlags {
  compare::ProblemExportOptions shared;
  bool no_scenes = false;
};

int problems(ProblemsFlags flags) {
  if (flags.no_scenes)
    flags.shared.scenes.clear();
  else if (flags.shared.scenes.empty())
    flags.shared.scenes = verify::verify_scenes().parent_path();
  listen_for_stop();
  return compare::export_problems(flags.shared, stop_requested);
}

}  // namespace

void add_problems(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("problems", "Writes hard contact problems with certified solutions.");
  auto flags = std::make_shared<ProblemsFlags>();
  compare::ProblemExportOptions& shared = flags->shared;
  shared.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  command->add_option("--export", shared.out, "Writes the FCLIB files and problems.csv into this folder.")->required();
  auto* scenes = command->add_option("--scenes", shared.scenes,
                                     "Writes the hardest step of each scene in this folder. The default is the folder "
                                     "of the scenes that are shipped.");
  command->add_flag("--no-scenes", flags->no_scenes, "Writes the generated problems alone.")->excludes(scenes);
  command->add_option("--until", shared.until_s, "Simulates each scene up to this time [s].")
      ->check(at_least(0))
      ->capture_default_str();
  command
      ->add_option("--threads", shared.threads,
                   "Makes this many problems at a time, at least 1. The files do not depend on the number.")
      ->check(at_least(1))
      ->capture_default_str();
  command->add_flag("--json", shared.json, "Prints the table as JSON on standard output.");
  command->add_flag("--quiet", shared.quiet, "Prints no progress.");
  command->add_flag("--force", shared.force, "Writes into the folder even if it is not empty.");
  command->callback([&action, flags] { action = [flags] { return problems(*flags); }; });
}

}  // namespace nilas::commands
