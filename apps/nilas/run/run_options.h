#pragma once
/// The options of `nilas run`.
#include <CLI/CLI.hpp>
#include <string>

#include "apps/nilas/commands/scene_flags.h"
#include "apps/view/live_server.h"

namespace nilas::commands {

struct RunOptions {
  SceneFlags scene;
  std::string out, resume, log_level = "info";
  int threads = 1, twins = 0;
  bool force = false, json = false, quiet = false, open_water = false;
  std::string open_water_run;
  bool view = false;
  view::LiveAddress view_address;
};

/// Adds SCENE and all flags to the command. Returns the option SCENE, which is not required with --resume.
CLI::Option* add_run_options(CLI::App& command, RunOptions& options);
/// Throws InputError for flags of a continued run that would change what it has done already.
void demand_resumable(const CLI::App& command);

}  // namespace nilas::commands
