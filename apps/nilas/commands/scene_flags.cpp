#include "apps/nilas/commands/scene_flags.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/scene/spec/values.h"

namespace nilas::commands {

void add_value_flags(CLI::App& command, SceneFlags& flags) {
  command.add_option("--seed", flags.seed, "Uses this random seed, a whole number, instead of the scene's.");
  command
      .add_option("--scale", flags.scale,
                  "Multiplies all lengths of the scene by this number, above 0, and all other values by Froude's and "
                  "Cauchy's laws. Values of other flags are those before.")
      ->check([](const std::string& text) -> std::string {
        const auto value = scene::parse_number(text);
        return value && *value > 0 ? "" : "found '" + text + "'; allowed: a finite number > 0";
      });
  command
      .add_option(
          "--set", flags.set,
          "Overrides attributes of the scene, each given as PATH=VALUE. Examples are contact/@tolerance=1e-8 and "
          "\"body[@name='box']/@mass=2\".")
      ->allow_extra_args(false)
      ->check([](const std::string& text) -> std::string {
        return text.find('=') != std::string::npos
                   ? ""
                   : "found '" + text + "'; allowed: PATH=VALUE, such as contact/@tolerance=1e-8";
      });
}

CLI::Option* add_scene_flags(CLI::App& command, SceneFlags& flags) {
  auto* scene = command.add_option("scene", flags.file, "Reads the scene from this XML file.")->required();
  command.add_option("--until", flags.until, "Ends at this simulated time [s] instead of the scene's end.");
  command.add_option("--dt", flags.dt, "Uses this time step [s], above 0, instead of the scene's.");
  command.add_option("--statistics", flags.statistics,
                     "Takes means, deviations and peaks over this window, FROM:TO in seconds, instead of the scene's.");
  command.add_option("--solver", flags.solver,
                     "Uses this contact solver instead of the scene's. `nilas solvers` lists the names.");
  command.add_option("--law", flags.law,
                     "Uses this contact law instead of the scene's. `nilas solvers` lists the names.");
  add_value_flags(command, flags);
  return scene;
}

/// Turns "FROM:TO" into "FROM TO", as the scene's attribute has it. Throws InputError without a colon.
static std::string window_words(const std::string& text) {
  const auto colon = text.find(':');
  if (colon == std::string::npos)
    throw InputError("--statistics: found '" + text + "'; allowed: FROM:TO in seconds, such as 10:60");
  return text.substr(0, colon) + " " + text.substr(colon + 1);
}

/// Flags that set one attribute, with the place that faults of it name.
static std::vector<std::pair<const char*, const char*>> given_flags(const SceneFlags& flags) {
  std::vector<std::pair<const char*, const char*>> given;
  if (flags.until) given.emplace_back("--until", "<time end>");
  if (flags.dt) given.emplace_back("--dt", "<time step>");
  if (flags.statistics) given.emplace_back("--statistics", "<output statistics>");
  if (flags.solver) given.emplace_back("--solver", "<contact solver>");
  if (flags.law) given.emplace_back("--law", "<contact law>");
  if (flags.checkpoint_every) given.emplace_back("--checkpoint-every", "<output checkpoint_every>");
  if (flags.seed) given.emplace_back("--seed", "<seed value>");
  return given;
}

/// Throws FileError for a folder, which is often that of a run.
static void demand_scene_file(const std::filesystem::path& file) {
  if (!is_folder(file)) return;
  const std::filesystem::path scene = file / "scene.xml";
  std::error_code ignored;
  const std::string hint =
      std::filesystem::exists(scene, ignored)
          ? ". It holds a run: " + scene.string() + " is its scene, and `nilas run --resume` continues it"
          : "";
  throw FileError(file.string() + ": is a folder; allowed: the XML file of a scene" + hint);
}

scene::Scene read_flagged_scene(const SceneFlags& flags) {
  demand_scene_file(flags.file);
  scene::Overrides overrides;
  for (const auto& text : flags.set) overrides.push_back(scene::split_override(text));
  if (flags.until) overrides.emplace_back("time/@end", fmt::format("{}", *flags.until));
  if (flags.statistics) overrides.emplace_back("output/@statistics", window_words(*flags.statistics));
  if (flags.dt) overrides.emplace_back("time/@step", fmt::format("{}", *flags.dt));
  if (flags.solver) overrides.emplace_back("contact/@solver", *flags.solver);
  if (flags.law) overrides.emplace_back("contact/@law", *flags.law);
  if (flags.checkpoint_every)
    overrides.emplace_back("output/@checkpoint_every", fmt::format("{}", *flags.checkpoint_every));
  if (flags.seed) overrides.emplace_back("seed/@value", fmt::format("{}", *flags.seed));
  try {
    return scene::read_scene(flags.file, overrides, flags.scale);
  } catch (const SceneError& e) {
    // A flag of its own overrides what --set gives to the same attribute, so a fault there is the flag's.
    std::vector<Fault> faults = e.faults();
    for (Fault& fault : faults)
      for (const auto& [flag, where] : given_flags(flags))
        if (fault.file == "--set" && fault.where == where) fault.file = flag;
    throw SceneError(std::move(faults));
  }
}

}  // namespace nilas::commands
