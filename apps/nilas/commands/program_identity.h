#pragma once
/// The identity of the program: its versions for people, and that by which checkpoints tell that another one wrote
/// them.
#include <string>

#include "core/sim/checkpoint.h"

namespace nilas::commands {

/// What `nilas --version` prints: name and version in the first line; then the build, and the versions of compiler and
/// libraries that it was built with.
std::string version_text();

/// The origin of the checkpoints that this program writes and reads for a scene. Reads the program's file. Throws
/// FileError.
sim::CheckpointOrigin checkpoint_origin(const std::string& scene_fingerprint);

}  // namespace nilas::commands
