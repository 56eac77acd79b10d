#pragma once
/// The outline of a hull or structure at the water, along which its surface is unrolled.
#include <vector>

#include "core/geometry/mesh.h"

namespace nilas::report {

/// The convex outline of a mesh at a level, measured along itself.
class WaterlineOutline {
 public:
  /// `level`: height of the water in the mesh's frame [m]; a mesh that does not reach it is taken as a whole. Lengths
  /// count from the place farthest in the direction `ahead`. Throws InputError where the mesh has no area seen from
  /// above.
  WaterlineOutline(const geometry::TriangleMesh& mesh, double level, const Vec2& ahead);

  double length() const { return length_; }  ///< all around [m]
  /// How far along the outline the nearest place to p lies [m]: from -length/2 to length/2, positive counter-clockwise
  /// seen from above, which is to port of the bow.
  double along(const Vec2& p) const;

 private:
  std::vector<Vec2> corners_;   ///< counter-clockwise
  std::vector<double> begins_;  ///< length up to each corner [m]
  double length_ = 0, zero_ = 0;
  double from_first_corner(const Vec2& p) const;
};

}  // namespace nilas::report
