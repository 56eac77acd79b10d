#pragma once
/// How much of an area the ice covers.
#include <vector>

#include "core/base/math.h"

namespace nilas::report {

/// A rectangle on the water.
struct WaterWindow {
  Vec2 middle = Vec2::Zero();    ///< [m]
  Vec2 ahead = Vec2::UnitX();    ///< unit vector along its length
  double length = 1, width = 1;  ///< [m]
};

/// The share of the window that ice covers, from the outlines of floes seen from above, in either sense of rotation.
/// Area that two floes cover counts for each, so floes that override can give more than 1. Outlines that cross
/// themselves, as steeply tilted floes may seem to, count by their convex hull.
double ice_cover(const std::vector<std::vector<Vec3>>& outlines, const WaterWindow& window);

}  // namespace nilas::report
