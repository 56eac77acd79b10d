#pragma once
/// Fills a checked tree with all defaults, so that it contains everything that a run depends on.
#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/document/document.h"

namespace nilas::scene {

/// Notes for the user about filled-in values, as whole sentences.
struct SceneNotes {
  std::vector<std::string> said_once;  ///< settings without effect, and stand-ins
  std::vector<std::string> derived;    ///< defaults that follow from the scene's scale, with reasons
};

/// Adds defaults: those of the preset, or, with a note, a built model where that of the default does not exist yet.
/// Makes paths absolute relative to the folder of `file`, and writes values in canonical form. Notes also list settings
/// without effect.
void resolve_defaults(SceneElement& root, const std::filesystem::path& file, SceneNotes& notes);

}  // namespace nilas::scene
