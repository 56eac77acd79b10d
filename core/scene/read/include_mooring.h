#pragma once
/// Mooring lines from a file of their own.
#include <filesystem>
#include <vector>

#include "core/scene/document/document.h"

namespace nilas::scene {

/// Puts the content of the file that <mooring file="..."> names in its place, before any check. Attributes that the
/// scene gives go first. Paths become relative to `scene_file`'s folder. The file's root must be <mooring>. A file
/// that cannot be read is left to the check of files. Throws SceneError where it is not well formed.
void include_mooring(SceneElement& root, const std::filesystem::path& scene_file, std::vector<Fault>& faults);

}  // namespace nilas::scene
