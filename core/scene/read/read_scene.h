#pragma once
/// Reads a Scene from an XML file and reports all faults at once.
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/scene.h"

namespace nilas::scene {

/// Overrides from the command line: (path, value), for example from --set contact/@tolerance=1e-8.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// Splits PATH=VALUE of --set; the '=' inside [@name='box'] does not count. Throws InputError.
std::pair<std::string, std::string> split_override(const std::string& text);

/// Reads a scene, with the overrides, and then scales its lengths by `scale` > 0 and all else by Froude's and Cauchy's
/// laws. Throws SceneError with every fault (file:line:column, element, found, allowed, nearest name), and FileError
/// when the file cannot be opened.
Scene read_scene(const std::filesystem::path& file, const Overrides& overrides = {}, double scale = 1);

/// The same from a text. `file`: the name of the text in messages, to whose folder its paths are relative.
Scene read_scene_text(std::string text, const std::filesystem::path& file, const Overrides& overrides = {},
                      double scale = 1);

}  // namespace nilas::scene
