#pragma once
/// From an XML file to a Scene, all faults reported at once.
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/scene.h"

namespace nilas {

/// Overrides from the command line: (path, value) as in --set contact/@tolerance=1e-8.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// Splits PATH=VALUE as --set takes it; the '=' inside [@name='box'] separates nothing. Throws InputError.
std::pair<std::string, std::string> split_override(const std::string& text);

/// Throws SceneError with every fault (file:line:column, element, found, allowed, nearest name), FileError when the
/// file cannot be opened.
Scene read_scene(const std::filesystem::path& file, const Overrides& overrides = {});

}  // namespace nilas
