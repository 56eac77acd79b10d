#pragma once
/// Outlines of real floes to draw a field's floes from.
#include <filesystem>
#include <vector>

#include "core/base/math.h"

namespace nilas {

/// Outlines to draw floes from, counter-clockwise: JSON list of outlines, or an object with such a list "bodies" (as
/// IceFieldCreator's), each a list of numbers x y x y ... or of pairs [x, y] in metres; or a GeoJSON field. Throws
/// FileError, InputError naming file and outline (counted from 1).
std::vector<std::vector<Vec2>> read_outlines(const std::filesystem::path& file);

}  // namespace nilas
