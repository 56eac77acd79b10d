#pragma once
/// Polygon faces of a convex triangle surface.
#include <vector>

#include "core/geometry/mesh.h"

namespace nilas::geometry {

/// Joins neighbouring triangles that lie in one plane within `tolerance` [m] into polygons: vertex loops,
/// counter-clockwise from outside. A group whose outline is not convex within `tolerance` stays in triangles. Vertices
/// along a straight edge between two faces are left out. The mesh must be closed and manifold.
std::vector<std::vector<int>> coplanar_faces(const TriangleMesh& mesh, double tolerance);

}  // namespace nilas::geometry
