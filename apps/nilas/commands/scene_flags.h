#pragma once
/// Flags that name a scene and override parts of it, shared by the commands that read one.
#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/read/read_scene.h"
#include "core/scene/time_steps.h"

namespace nilas::commands {

struct SceneFlags {
  std::string file;
  std::vector<std::string> set;
  std::optional<double> until, dt, checkpoint_every;
  std::optional<std::string> solver, law, statistics;
  std::optional<long> seed;
  double scale = 1;
};

/// Adds SCENE and the override flags to a command. Returns the option SCENE.
CLI::Option* add_scene_flags(CLI::App& command, SceneFlags& flags);
/// Adds --seed, --scale and --set alone, for a command that simulates nothing.
void add_value_flags(CLI::App& command, SceneFlags& flags);
/// Reads the scene with the overrides applied. Throws InputError for a --set that is not PATH=VALUE.
scene::Scene read_flagged_scene(const SceneFlags& flags);

}  // namespace nilas::commands
