#pragma once
/// Pictures of a hull.
#include <filesystem>

#include "core/hull/hull.h"
#include "core/mesh/mend/mend.h"

namespace nilas {

/// Writes hull.png into the folder: the mesh from above and from below with the waterline at `level` [m, frame V], and
/// the parts, each in its colour; the end that a scene takes as the bow is marked. Throws FileError where gnuplot is
/// missing.
void draw_hull(const Hull& hull, double level, const std::filesystem::path& folder);

/// Writes faults.png into the folder: the mesh as it is, the places of what could not be mended marked. Throws
/// FileError.
void draw_faults(const MendedMesh& mesh, const std::filesystem::path& folder);

}  // namespace nilas
