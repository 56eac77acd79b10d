#pragma once
/// Fills a checked tree with what the scene leaves to defaults, so that it says everything that a run depends on.
#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/document/document.h"

namespace nilas {

/// What a user should know of what was filled in, as whole sentences.
struct SceneNotes {
  std::vector<std::string> said_once;  ///< what has no effect, and stand-ins
  std::vector<std::string> derived;    ///< defaults that follow from the scene's scale, and why
};

/// Adds defaults (those of the preset, or the built stand-in where a default's model does not exist yet, with a note),
/// makes paths absolute against the folder of `file` and spells values canonically. Notes say also what has no effect.
void resolve_defaults(SceneElement& root, const std::filesystem::path& file, SceneNotes& notes);

}  // namespace nilas
