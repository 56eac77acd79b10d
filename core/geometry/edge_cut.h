#pragma once
/// The cut of a straight edge by a horizontal plane.
#include <optional>

#include "core/base/math.h"

namespace nilas::geometry {

/// The point where the edge from a to b meets the plane z = level; nothing if both ends lie below it, or none does.
inline std::optional<Vec3> edge_cut(const Vec3& a, const Vec3& b, double level) {
  if ((a.z() < level) == (b.z() < level)) return std::nullopt;
  return Vec3(a + (level - a.z()) / (b.z() - a.z()) * (b - a));
}

}  // namespace nilas::geometry
