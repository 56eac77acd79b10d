#pragma once
/// The water plane seen from a body frame B.
#include "core/base/math.h"

namespace nilas {

/// Height of the body point x above still water: up . x + offset.
struct WaterPlane {
  Vec3 up = Vec3::UnitZ();  ///< G's Z axis in B
  double offset = 0;        ///< height of B's origin [m]

  double height(const Vec3& x) const { return up.dot(x) + offset; }
  /// Foot of x on the plane [m].
  Vec3 foot(const Vec3& x) const { return x - height(x) * up; }
};

/// Plane z = level for a body at pose (R, p).
inline WaterPlane water_plane(const Mat3& R, const Vec3& p, double level) {
  return {R.row(2).transpose(), p.z() - level};
}

/// The point where an edge leaves the water. Always reckoned from the wet end, so both faces of an edge get the same
/// bits. Heights: wet < 0 <= dry.
template <class Point>
Point leaves_water(const Point& wet, double wet_height, const Point& dry, double dry_height) {
  return wet + wet_height / (wet_height - dry_height) * (dry - wet);
}

}  // namespace nilas
