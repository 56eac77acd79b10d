#pragma once
/// checkpoint.h5: a state on disk with what it belongs to. Layout: docs/reference/outputs.md.
#include <filesystem>
#include <string>

#include "core/base/state.h"

namespace nilas {

/// The only version of the layout that is read.
constexpr int k_checkpoint_version = 12;

/// What a state is worth nothing without.
struct CheckpointOrigin {
  std::string program;  ///< versions of it and its libraries, compiler, flags: others round otherwise
  std::string build;    ///< SHA-256 of the program's file
  std::string scene;    ///< Scene::fingerprint
};

/// Replaces the file at once: a reader finds the old one or the new one, whole, even after the machine stopped. Throws
/// FileError.
void write_checkpoint(const std::filesystem::path& path, const CheckpointOrigin& origin, const State& state);

/// Throws FileError when the file cannot be opened, InputError when it is no checkpoint, is damaged or cut short, or is
/// of another version, program, build or scene.
State read_checkpoint(const std::filesystem::path& path, const CheckpointOrigin& origin);

}  // namespace nilas
