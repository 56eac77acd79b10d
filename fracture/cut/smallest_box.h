#pragma once
/// Smallest rectangle around a floe.
#include <vector>

#include "core/base/math.h"

namespace nilas {

struct SmallestBox {
  double length = 0, width = 0;  ///< length >= width [m]
  double angle = 0;              ///< of the edge that it lies along, from x [rad]
  double aspect() const;         ///< length / width; infinite when the width is zero
};

/// Rectangle of least area around the points: one of its sides lies along an edge of their convex hull (Freeman and
/// Shapira 1975, Commun. ACM 18(7)). Fewer than three points, or all on a line: width 0.
SmallestBox smallest_box(const std::vector<Vec2>& points);

}  // namespace nilas
