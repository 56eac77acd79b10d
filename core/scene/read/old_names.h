#pragma once
/// Former names of choices and of a shipped scene: old scenes, run folders and studies keep working.
#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/document/document.h"

namespace nilas::scene {

/// Replaces old names of choices by present ones. Returns a warning for each, with its place and the new name.
std::vector<Fault> replace_old_names(SceneElement& root);
/// Replaces the present name of each choice by its first one. The identity of a scene's text, as for a checkpoint, then
/// does not depend on the name that the scene used.
void restore_old_names(SceneElement& root);

/// The new place of a shipped scene with an old name: "; the scene is now ...". Empty for others.
std::string moved_scene(const std::filesystem::path& file);

}  // namespace nilas::scene
