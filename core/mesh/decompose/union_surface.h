#pragma once
/// The surface of a union of convex parts.
#include "core/mesh/decompose/surface_distance.h"

namespace nilas {

using Loop = std::vector<Vec3>;  ///< convex plane polygon

/// What lies below a plane.
struct HalfSpace {
  Vec3 normal;    ///< outward
  double offset;  ///< inside: normal . x < offset [m]
  /// Of a point over the plane; below 0 inside [m].
  double height(const Vec3& p) const { return normal.dot(p) - offset; }
};

/// What of a polygon lies outside the region between the planes, as polygons, added to `outside`. The polygon is
/// placed as if moved by `shift`.
void subtract(const Loop& polygon, const Vec3& shift, const std::vector<HalfSpace>& region, std::vector<Loop>& outside);

/// Triangles of the parts' faces without what lies inside another part or against its face. Faces closer than `skin`
/// [m] count as touching.
std::vector<Corners> union_surface(const std::vector<TriangleMesh>& parts, double skin);

}  // namespace nilas
