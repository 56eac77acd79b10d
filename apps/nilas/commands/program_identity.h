#pragma once
/// The identity of the program, by which checkpoints tell that another one wrote them.
#include <string>

#include "core/sim/checkpoint.h"

namespace nilas::commands {

/// The origin of the checkpoints that this program writes and reads for a scene. Reads the program's file. Throws
/// FileError.
sim::CheckpointOrigin checkpoint_origin(const std::string& scene_fingerprint);

}  // namespace nilas::commands
