#pragma once
/// Measures of a hull's shape that tell its sides, ends and faces from each other.
#include "core/geometry/mesh.h"

namespace nilas::hull {

/// Measures of a mesh in its own axes, taken as forward, port and up. All are ratios of lengths or areas, except the
/// box.
struct HullMeasures {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< box around the triangles [m]
  /// How far the solid is from symmetric about a plane across each axis. Lines along the axis enter the solid and leave
  /// it; the middles between lie in one plane where it is symmetric. Their mean distance from it over the extent.
  Vec3 lopsided = Vec3::Zero();
  double flat_top = 0, flat_bottom = 0;  ///< share of the plan area, from above and below, within 15 deg of level
  double full_fore = 0, full_aft = 0;  ///< share of the end view that lies within a twentieth of the length of the end
  double broad_fore = 0, broad_aft = 0;    ///< breadth in plan beside the foremost and aftmost point, over the beam
  double square_fore = 0, square_aft = 0;  ///< the same over the breadth a twentieth of the length further in

  Vec3 size() const { return high - low; }
};

/// The mesh must be closed and outward, with an extent along every axis.
HullMeasures measure_hull(const geometry::TriangleMesh& mesh);

}  // namespace nilas::hull
