#pragma once
/// The stopped run that `nilas run --resume` finds in a run folder.
#include <filesystem>
#include <optional>
#include <string>

#include "apps/nilas/commands/scene_flags.h"
#include "core/output/run/run_lock.h"
#include "core/sim/checkpoint.h"

namespace nilas::commands {

struct StoppedRun {
  std::filesystem::path folder;
  scene::Scene scene;  ///< the folder's scene, with the flags' end, statistics window and checkpoint interval
  std::optional<State> checkpoint;              ///< none: the run stopped before its first one and begins again
  std::optional<sim::CheckpointOrigin> origin;  ///< the origin of the checkpoint
  std::string summary;                          ///< the text of summary.json of a run that is done; else empty
  std::optional<output::RunLock> lock;          ///< holds the folder; none if the run is done
};

/// Reads a stopped run. Only `until`, `statistics` and `checkpoint_every` of `flags` count. Throws FileError for a
/// folder that is no run folder, that another program writes into, or that has no checkpoint because none were asked
/// for. Throws InputError or SceneError for a checkpoint or a scene from which the run cannot continue.
StoppedRun find_stopped_run(const std::filesystem::path& folder, const SceneFlags& flags);

}  // namespace nilas::commands
