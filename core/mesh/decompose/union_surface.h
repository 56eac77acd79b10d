#pragma once
/// The surface of a union of convex pieces.
#include "core/mesh/decompose/surface_distance.h"

namespace nilas::mesh {

using Loop = std::vector<Vec3>;  ///< convex plane polygon

/// The half space below a plane.
struct HalfSpace {
  Vec3 normal;    ///< outward
  double offset;  ///< inside: normal . x < offset [m]
  /// Height of a point above the plane; below 0 inside [m].
  double height(const Vec3& p) const { return normal.dot(p) - offset; }
};

/// Adds to `outside` the parts of a polygon outside the region below all planes, as polygons. The polygon is judged as
/// if it were moved by `shift` [m]; the parts themselves are not moved.
void subtract(const Loop& polygon, const Vec3& shift, const std::vector<HalfSpace>& region, std::vector<Loop>& outside);

/// Triangles of the pieces' faces, without areas inside another piece or against its face. Faces closer than `skin` [m]
/// count as touching.
std::vector<Corners> union_surface(const std::vector<geometry::TriangleMesh>& parts, double skin);

}  // namespace nilas::mesh
