#pragma once
#include <vector>

#include "core/geometry/mass_properties.h"

namespace nilas::test {

/// The outline moved so that its centroid is the origin, as prism_shape requires.
inline std::vector<Vec2> about_centroid(std::vector<Vec2> outline) {
  const Vec2 centroid = geometry::polygon_moments(outline).centroid;
  for (Vec2& x : outline) x -= centroid;
  return outline;
}

}  // namespace nilas::test
