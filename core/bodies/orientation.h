#pragma once
/// Exact sign of a plane triangle's area.
#include "core/base/math.h"

namespace nilas {

/// +1 when c lies left of the line from a to b, -1 when right of it, 0 when exactly on it (no rounding).
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

}  // namespace nilas
