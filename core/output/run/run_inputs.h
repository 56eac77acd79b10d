#pragma once
/// inputs/ in a run folder: copies of the files that the run reads, so that the folder runs again wherever it stands.
#include <filesystem>
#include <vector>

#include "core/scene/scene.h"

namespace nilas {

/// Throws InputError where a copy of one of `inputs` would replace another of them, or a file in `folder` that no run
/// copied there. Touches nothing.
void demand_room_for_inputs(const std::filesystem::path& folder, const std::vector<InputFile>& inputs);

/// Removes the copies that an earlier run made in `folder`, and what one that was killed left half written. All other
/// files stay, and so do those of `kept`. Throws FileError.
void remove_inputs(const std::filesystem::path& folder, const std::vector<InputFile>& kept);

/// Whether `folder`/inputs, where there is one, holds copies that a run made and nothing else.
bool holds_copies_only(const std::filesystem::path& folder);

/// Copies what is not there already, and lists all in inputs/nilas-inputs.sha256. Without inputs it makes no folder.
/// Throws FileError, and InputError where a file has changed since the scene was read; what it copied is then removed.
void copy_inputs(const std::filesystem::path& folder, const std::vector<InputFile>& inputs);

}  // namespace nilas
