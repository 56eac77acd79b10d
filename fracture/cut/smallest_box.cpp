#include "fracture/cut/smallest_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/polygon.h"

namespace nilas::fracture {

double SmallestBox::aspect() const { return width > 0 ? length / width : std::numeric_limits<double>::infinity(); }

SmallestBox smallest_box(const std::vector<Vec2>& points) {
  const std::vector<Vec2> hull = geometry::convex_hull(points);
  SmallestBox best;
  double least = std::numeric_limits<double>::infinity();
  // All hull edges are tried: rotating calipers lose their place at edges of a few roundings.
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 along = (hull[(i + 1) % hull.size()] - hull[i]).normalized(), across(-along.y(), along.x());
    Vec2 low = Vec2::Zero(), high = low;
    for (const Vec2& p : hull) {
      const Vec2 seen(along.dot(p - hull[i]), across.dot(p - hull[i]));
      low = low.cwiseMin(seen);
      high = high.cwiseMax(seen);
    }
    const Vec2 sides = high - low;
    if (sides.prod() >= least) continue;
    least = sides.prod();
    best = {sides.maxCoeff(), hull.size() < 3 ? 0 : sides.minCoeff(), std::atan2(along.y(), along.x())};
  }
  return best;
}

}  // namespace nilas::fracture
