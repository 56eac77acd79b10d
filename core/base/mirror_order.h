#pragma once
/// Which of several points to begin with so that a mirrored body begins with the mirrored one, however its points are
/// numbered.
#include <cmath>
#include <tuple>

#include "core/base/math.h"

namespace nilas {

/// An order of points that their images in the planes x = 0 and y = 0 share, but for points that are each other's
/// image.
inline bool comes_before(const Vec3& p, const Vec3& q) {
  const auto rank = [](const Vec3& x) { return std::tuple(std::abs(x.x()), std::abs(x.y()), x.z(), x.x(), x.y()); };
  return rank(p) < rank(q);
}

}  // namespace nilas
