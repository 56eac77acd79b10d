#pragma once
/// Exact signs of plane areas.
#include <vector>

#include "core/base/math.h"

namespace nilas::geometry {

/// +1 when c lies left of the line from a to b, -1 when right of it, 0 when exactly on it (no rounding).
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// Sense of a simple outline, decided exactly however thin it is.
bool is_clockwise(const std::vector<Vec2>& outline);

}  // namespace nilas::geometry
