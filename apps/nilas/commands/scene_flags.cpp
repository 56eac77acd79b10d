#include "apps/nilas/commands/scene_flags.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.h"

namespace nilas {

void add_value_flags(CLI::App& command, SceneFlags& flags) {
  command.add_option("--seed", flags.seed, "random seed instead of the scene's");
  command
      .add_option("--set", flags.set,
                  "PATH=VALUE, one or several: each overrides an attribute of the scene, e.g. contact/@tolerance=1e-8 "
                  "or \"body[@name='box']/@mass=2\"")
      ->allow_extra_args(false)
      ->check([](const std::string& text) -> std::string {
        return text.find('=') != std::string::npos
                   ? ""
                   : "found '" + text + "'; allowed: PATH=VALUE, as in contact/@tolerance=1e-8";
      });
}

CLI::Option* add_scene_flags(CLI::App& command, SceneFlags& flags) {
  auto* scene = command.add_option("scene", flags.file, "scene file (XML)")->required();
  command.add_option("--until", flags.until, "end time instead of the scene's [s]");
  command.add_option("--dt", flags.dt, "time step instead of the scene's [s]");
  command.add_option("--statistics", flags.statistics,
                     "FROM:TO [s]: the window of means, deviations and peaks instead of the scene's");
  command.add_option("--solver", flags.solver, "contact solver instead of the scene's (see `nilas solvers`)");
  command.add_option("--law", flags.law, "contact law instead of the scene's");
  add_value_flags(command, flags);
  return scene;
}

/// "FROM TO" of "FROM:TO".
static std::string window_words(const std::string& text) {
  const auto colon = text.find(':');
  if (colon == std::string::npos)
    throw InputError("--statistics: found '" + text + "'; allowed: FROM:TO in seconds, as 10:60");
  return text.substr(0, colon) + " " + text.substr(colon + 1);
}

Scene read_flagged_scene(const SceneFlags& flags) {
  Overrides overrides;
  for (const auto& text : flags.set) overrides.push_back(split_override(text));
  if (flags.until) overrides.emplace_back("time/@end", fmt::format("{}", *flags.until));
  if (flags.statistics) overrides.emplace_back("output/@statistics", window_words(*flags.statistics));
  if (flags.dt) overrides.emplace_back("time/@step", fmt::format("{}", *flags.dt));
  if (flags.solver) overrides.emplace_back("contact/@solver", *flags.solver);
  if (flags.law) overrides.emplace_back("contact/@law", *flags.law);
  if (flags.checkpoint_every)
    overrides.emplace_back("output/@checkpoint_every", fmt::format("{}", *flags.checkpoint_every));
  if (flags.seed) overrides.emplace_back("seed/@value", fmt::format("{}", *flags.seed));
  return read_scene(flags.file, overrides);
}

}  // namespace nilas
