#pragma once
/// The water plane seen from a body frame B.
#include "core/base/math.h"

namespace nilas::hydro {

/// The plane of still water in the frame B. A body point x is at the height up . x + offset above it.
struct WaterPlane {
  Vec3 up = Vec3::UnitZ();  ///< G's Z axis in B
  double offset = 0;        ///< height of B's origin [m]

  double height(const Vec3& x) const { return up.dot(x) + offset; }
  /// Foot of x on the plane [m].
  Vec3 foot(const Vec3& x) const { return x - height(x) * up; }
};

/// The plane z = level [m] in the frame of a body at the pose (R, p).
inline WaterPlane water_plane(const Mat3& R, const Vec3& p, double level) {
  return {R.row(2).transpose(), p.z() - level};
}

/// The point where an edge leaves the water. It is computed from the wet end, so that both faces of an edge get the
/// same bits. The heights obey wet < 0 <= dry.
template <class Point>
Point leaves_water(const Point& wet, double wet_height, const Point& dry, double dry_height) {
  return wet + wet_height / (wet_height - dry_height) * (dry - wet);
}

}  // namespace nilas::hydro
