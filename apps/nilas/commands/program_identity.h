#pragma once
/// The identity of the program: its version and the libraries and compiler that it was built with.
#include <map>
#include <string>

#include "core/sim/checkpoint.h"

namespace nilas::commands {

/// The versions of the program, its libraries and the compiler, by name.
std::map<std::string, std::string> program_versions();

/// The origin of the checkpoints that this program writes and reads for a scene. Reads the program's file. Throws
/// FileError.
sim::CheckpointOrigin checkpoint_origin(const std::string& scene_fingerprint);

}  // namespace nilas::commands
