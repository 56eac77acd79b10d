#pragma once
/// Writes scene.xml: the scene as run, with every default and override. Running it again gives the same bits.
#include <filesystem>

#include "core/scene/scene.h"

namespace nilas {

/// Throws FileError.
void write_scene_xml(const std::filesystem::path& path, const Scene& scene);

}  // namespace nilas
