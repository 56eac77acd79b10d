#pragma once
/// Pieces of a solid between cutting planes. Includes CGAL.
#include <vector>

#include "core/mesh/surface_mesh.h"

namespace nilas {

using Plane = Kernel::Plane_3;

/// Convex hull of at least four points that are not in one plane, else empty.
SurfaceMesh convex_hull(const std::vector<Kernel::Point_3>& points);
/// All vertices, in the order of the mesh's indices [m].
std::vector<Kernel::Point_3> points_of(const SurfaceMesh& mesh);

/// Whether the two below can do their work: no faces that cross, none without area.
bool can_be_cut(const SurfaceMesh& piece);
/// The closed pieces on both sides of a plane; none where CGAL fails or nothing is cut off.
std::vector<SurfaceMesh> cut(const SurfaceMesh& piece, const Plane& plane);
/// Those on the plane's negative side.
std::vector<SurfaceMesh> below(const SurfaceMesh& piece, const Plane& through);

/// Planes worth cutting at, the best first: those that leave the least volume between the two sides and their convex
/// hulls, of evenly spaced ones across the axes, those through sharp hollow edges, and those along their faces.
std::vector<Plane> promising_cuts(const SurfaceMesh& piece, std::size_t most);

}  // namespace nilas
