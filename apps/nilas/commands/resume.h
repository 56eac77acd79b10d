#pragma once
/// What `nilas run --resume` finds in a run folder.
#include <filesystem>
#include <optional>
#include <string>

#include "apps/nilas/commands/scene_flags.h"
#include "core/output/run/run_lock.h"
#include "core/sim/checkpoint.h"

namespace nilas {

struct StoppedRun {
  std::filesystem::path folder;
  Scene scene;                             ///< of the folder, with the flags' end and checkpoint interval
  std::optional<State> checkpoint;         ///< none: stopped before the first one, so it begins again
  std::optional<CheckpointOrigin> origin;  ///< of the checkpoint
  std::string summary;                     ///< of a run that is done; else empty
  std::optional<RunLock> lock;             ///< unless it is done
};

/// Of `flags` only `until` and `checkpoint_every` count. Throws FileError for a
/// folder that is no run or has no checkpoint where none were asked for, or that another program writes into,
/// InputError and SceneError for a checkpoint or a scene that cannot be gone on with.
StoppedRun find_stopped_run(const std::filesystem::path& folder, const SceneFlags& flags);

}  // namespace nilas
