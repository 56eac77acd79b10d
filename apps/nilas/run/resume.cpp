#include "apps/nilas/run/resume.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/nilas/commands/program_identity.h"
#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/base/json_text.h"
#include "core/output/run/run_folder.h"

namespace nilas::commands {

namespace fs = std::filesystem;

/// The text of summary.json of a run that did all its steps, or all that its course allows; empty for other runs.
static std::string summary_of_done_run(const fs::path& file, long steps) {
  if (!fs::exists(file)) return "";
  const std::string text = json_file_text(file);
  const auto summary = nlohmann::json::parse(text, nullptr, false);
  const bool done = summary.is_object() && summary.value("status", nlohmann::json()) == "done" &&
                    (summary.value("steps", nlohmann::json()) == steps || summary.contains("ended_early"));
  return done ? text : "";
}

static long steps_of(const State& checkpoint) {
  long steps = 0;
  StateReader(checkpoint).group("simulation").get("steps", steps);
  return steps;
}

StoppedRun find_stopped_run(const fs::path& folder, const SceneFlags& flags) {
  demand_there(folder, "run folder");
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw FileError(folder.string() + ": it is no run folder");
  const fs::path scene_file = output::RunFolder::scene_file(folder),
                 checkpoint_file = output::RunFolder::checkpoint_file(folder);
  if (!fs::exists(scene_file, error))
    throw FileError(folder.string() +
                    ": it is no run folder because it has no scene.xml. A run that stopped before its first step is "
                    "begun again with nilas run SCENE.");
  StoppedRun found{.folder = folder, .scene = {}, .checkpoint = {}, .origin = {}, .summary = {}, .lock = {}};
  SceneFlags allowed;
  allowed.file = scene_file.string();
  allowed.until = flags.until;
  allowed.statistics = flags.statistics;
  allowed.checkpoint_every = flags.checkpoint_every;
  found.scene = read_flagged_scene(allowed);
  const long steps = scene::number_of_steps(found.scene.time);
  found.summary = summary_of_done_run(output::RunFolder::summary_file(folder), steps);
  if (!found.summary.empty()) return found;
  found.lock.emplace(folder);
  if (!fs::exists(checkpoint_file, error)) {
    if (scene::read_scene(scene_file).output.checkpoint_every > 0) return found;
    throw FileError(checkpoint_file.string() +
                    ": not found; the run was not asked for checkpoints (--checkpoint-every)");
  }
  found.origin = checkpoint_origin(found.scene.fingerprint);
  found.checkpoint = sim::read_checkpoint(checkpoint_file, *found.origin);
  if (const long done = steps_of(*found.checkpoint); done > steps)
    throw InputError(
        fmt::format("--until: found {:g} s; the run has reached {:g} s already, and only a later time is allowed",
                    found.scene.time.end, found.scene.time.start + static_cast<double>(done) * found.scene.time.step));
  return found;
}

}  // namespace nilas::commands
