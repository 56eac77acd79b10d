#pragma once
/// Writes scene.xml: the scene as run, with every default and override. Running it again gives the same bits.
#include <filesystem>

#include "core/scene/scene.h"

namespace nilas::output {

/// Throws FileError.
void write_scene_xml(const std::filesystem::path& path, const scene::Scene& scene);

}  // namespace nilas::output
