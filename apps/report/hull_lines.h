#pragma once
/// A hull as lines for drawings.
#include <array>
#include <vector>

#include "core/geometry/mesh.h"

namespace nilas {

using Segment = std::array<Vec3, 2>;

/// What a draughtsman draws of a closed mesh seen from far away along -`from`: its silhouette and the sharp edges on
/// the near side.
std::vector<Segment> visible_lines(const TriangleMesh& mesh, const Vec3& from);

/// Where the mesh meets the plane z = level.
std::vector<Segment> waterline(const TriangleMesh& mesh, double level);

}  // namespace nilas
