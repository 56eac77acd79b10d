#pragma once
/// The folder inputs/ of a run folder: copies of the files that the run reads, so that it can run again anywhere.
#include <filesystem>
#include <vector>

#include "core/scene/scene.h"

namespace nilas::output {

/// Throws InputError where a copy of one of `inputs` would replace another of them, or a file in `folder` that no run
/// copied there. Changes nothing.
void demand_room_for_inputs(const std::filesystem::path& folder, const std::vector<scene::InputFile>& inputs);

/// Removes the copies that an earlier run made in `folder`, and half-written ones. All other files and those of `kept`
/// stay. Throws FileError.
void remove_inputs(const std::filesystem::path& folder, const std::vector<scene::InputFile>& kept);

/// Whether `folder`/inputs, if it exists, holds only copies that a run made.
bool holds_copies_only(const std::filesystem::path& folder);

/// Copies missing files and lists all in inputs/nilas-inputs.sha256. Without inputs, no folder is made. Throws
/// FileError. Throws InputError where a file has changed since the scene was read, after removing its copies.
void copy_inputs(const std::filesystem::path& folder, const std::vector<scene::InputFile>& inputs);

}  // namespace nilas::output
