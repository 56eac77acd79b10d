#pragma once
/// Pieces of a solid between cutting planes.
#include <vector>

#include "core/geometry/mesh.h"
#include "core/mesh/decompose/union_surface.h"

namespace nilas::mesh {

/// Convex hull of at least four points that are not in one plane, else empty. Its vertices are the hull's corners
/// alone; order and triangles follow from the points, to the bit.
geometry::TriangleMesh convex_hull(const std::vector<Vec3>& points);

/// An edge with the triangles on both sides of it.
struct SharedEdge {
  int a, b;                 ///< vertices
  std::size_t left, right;  ///< triangles in which it runs from a to b, and from b to a
};
/// The shared edges of a mesh. Where an edge has more than two triangles, they are taken in pairs.
std::vector<SharedEdge> shared_edges(const geometry::TriangleMesh& mesh);

/// The pieces of a closed mesh on both sides of a plane, with caps in the plane. Each is connected and encloses a
/// volume. Vertices within float32 rounding of the plane keep their place and count as in it. Empty where nothing is
/// cut off, or where volume would be lost.
std::vector<geometry::TriangleMesh> cut(const geometry::TriangleMesh& piece, const HalfSpace& plane);
/// The pieces below the plane; empty where nothing is cut off.
std::vector<geometry::TriangleMesh> below(const geometry::TriangleMesh& piece, const HalfSpace& plane);

/// The best cutting planes, the best first: those that leave the least volume between both sides and their convex
/// hulls. Candidates are evenly spaced planes across the axes, planes through sharp concave edges, and planes along
/// their faces.
std::vector<HalfSpace> promising_cuts(const geometry::TriangleMesh& piece, std::size_t most, int threads);

}  // namespace nilas::mesh
