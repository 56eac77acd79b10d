#pragma once
/// Mirror images in the plane y = 0.
#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/base/math.h"

namespace nilas::test {

inline Vec3 mirrored(const Vec3& x) { return {x.x(), -x.y(), x.z()}; }

/// The mirror image of an axial vector, such as an angular velocity or a moment.
inline Vec3 mirrored_axial(const Vec3& x) { return {-x.x(), x.y(), -x.z()}; }

inline Quat mirrored(const Quat& q) { return {q.w(), -q.x(), q.y(), -q.z()}; }

/// The mirror image of an outline. Its corners have the reverse order, which keeps it counter-clockwise; `first` counts
/// how many places they are shifted, so that the image may begin at any corner.
inline std::vector<Vec2> mirrored(std::vector<Vec2> outline, std::size_t first = 0) {
  for (Vec2& x : outline) x.y() = -x.y();
  std::reverse(outline.begin(), outline.end());
  std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(first % outline.size()), outline.end());
  return outline;
}

}  // namespace nilas::test
