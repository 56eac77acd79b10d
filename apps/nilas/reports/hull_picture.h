#pragma once
/// Pictures of a hull.
#include <filesystem>

#include "core/hull/hull.h"
#include "core/mesh/mend/mend.h"

namespace nilas::commands {

/// Writes hull.png into the folder. It shows the mesh from above and from below with the waterline at the height
/// `level` [m, frame V], and the convex parts, each in its colour. The end that a scene takes as the bow is marked.
/// Throws FileError if gnuplot is missing.
void draw_hull(const hull::Hull& hull, double level, const std::filesystem::path& folder);

/// Writes faults.png into the folder. It shows the mesh as it is, with marks where it could not be mended. Throws
/// FileError.
void draw_faults(const mesh::MendedMesh& mesh, const std::filesystem::path& folder);

}  // namespace nilas::commands
