#pragma once
/// What the program is and was built with.
#include <map>
#include <string>

#include "core/sim/checkpoint.h"

namespace nilas {

/// Of the program, its libraries and the compiler, by name.
std::map<std::string, std::string> program_versions();

/// Of checkpoints that this program writes and reads for a scene. Reads the program's file. Throws FileError.
CheckpointOrigin checkpoint_origin(const std::string& scene_fingerprint);

}  // namespace nilas
