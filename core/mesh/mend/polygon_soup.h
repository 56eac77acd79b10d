#pragma once
/// Surfaces as users' files give them.
#include <filesystem>
#include <vector>

#include "core/base/math.h"

namespace nilas::mesh {

/// Polygons that need not fit together: gaps, doubles and any winding are allowed.
struct PolygonSoup {
  std::vector<Vec3> points;                ///< finite [unit of the file]
  std::vector<std::vector<int>> polygons;  ///< corner loops of at least three indices into points
};

/// Reads STL (both forms), OBJ, OFF or PLY (all three forms), by the ending of the name. Throws FileError (cannot be
/// opened), or InputError naming the file and, where the format has them, the line: other endings, content that is
/// wrong or cut short, numbers not finite, indices that name no point, no polygons.
PolygonSoup read_polygons(const std::filesystem::path& file);

}  // namespace nilas::mesh
