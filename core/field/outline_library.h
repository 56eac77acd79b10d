#pragma once
/// Outlines of real floes, from which a field's floes are drawn.
#include <filesystem>
#include <vector>

#include "core/base/math.h"

namespace nilas::field {

/// Reads outlines, counter-clockwise. The file is a JSON list of outlines, an object with such a list "bodies" (as
/// IceFieldCreator's), or a GeoJSON field. Each outline is a list of numbers x y x y ... or of pairs [x, y] in metres.
/// Throws FileError, and InputError naming file and outline (counted from 1).
std::vector<std::vector<Vec2>> read_outlines(const std::filesystem::path& file);

}  // namespace nilas::field
