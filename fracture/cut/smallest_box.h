#pragma once
/// The smallest rectangle around a floe.
#include <vector>

#include "core/base/math.h"

namespace nilas::fracture {

struct SmallestBox {
  double length = 0, width = 0;  ///< length >= width [m]
  double angle = 0;              ///< Direction of the hull edge that it lies along, from x [rad].
  double aspect() const;         ///< length / width; infinite when the width is zero
};

/// The rectangle of least area around the points. One of its sides lies along an edge of their convex hull (Freeman and
/// Shapira 1975, Commun. ACM 18(7)). The width is 0 for fewer than three points, or for points on one line.
SmallestBox smallest_box(const std::vector<Vec2>& points);

}  // namespace nilas::fracture
