#pragma once
/// Reads and writes checkpoint.h5: a state and its origin. Layout: docs/reference/outputs.md.
#include <filesystem>
#include <string>

#include "core/base/state.h"

namespace nilas::sim {

/// Version of the layout; no other version can be read.
constexpr int k_checkpoint_version = 15;

/// The program and scene that a state belongs to; it must not be used with others.
struct CheckpointOrigin {
  std::string program;  ///< versions of program and libraries, compiler and flags: others round differently
  std::string build;    ///< SHA-256 of the program's file
  std::string scene;    ///< Scene::fingerprint
};

/// Writes the state and replaces the file atomically: a reader finds the complete old or new file, even after a crash
/// of the machine. Throws FileError.
void write_checkpoint(const std::filesystem::path& path, const CheckpointOrigin& origin, const State& state);

/// Reads a state. Throws FileError when the file cannot be opened. Throws InputError when it is no checkpoint, is
/// damaged or truncated, or belongs to another version, program, build or scene.
State read_checkpoint(const std::filesystem::path& path, const CheckpointOrigin& origin);

}  // namespace nilas::sim
