#pragma once
/// Groups of neighbouring triangles in one plane.
#include <array>
#include <vector>

#include "core/geometry/mesh.h"

namespace nilas::geometry {

/// The triangle beyond the edge (k, k+1), k = 0, 1, 2, of each triangle of a closed manifold mesh.
std::vector<std::array<int, 3>> triangle_neighbours(const TriangleMesh& mesh);

/// Triangles grouped by plane: every vertex of a group lies within `tolerance` [m] of the group's plane. Triangles
/// lower than `tolerance` have no direction of their own and join any neighbour they fit.
std::vector<std::vector<int>> coplanar_groups(const TriangleMesh& mesh,
                                              const std::vector<std::array<int, 3>>& neighbours, double tolerance);

}  // namespace nilas::geometry
