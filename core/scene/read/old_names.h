#pragma once
/// Names of choices, and of a shipped scene, that have changed: old scenes, run folders and studies keep working.
#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/document/document.h"

namespace nilas {

/// Replaces old names of choices by today's. Returns a warning for each, with its place and the new name.
std::vector<Fault> replace_old_names(SceneElement& root);
/// Puts the first name of each choice in place of today's. What is identified by the text of its scene, such as a
/// checkpoint, then stays the same whichever name the scene used.
void restore_old_names(SceneElement& root);

/// Where a shipped scene has gone that is asked for by an old name: "; the scene is now ...". Empty for others.
std::string moved_scene(const std::filesystem::path& file);

}  // namespace nilas
