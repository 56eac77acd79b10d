#pragma once
/// Difference of an outline and other outlines.
#include <vector>

#include "core/base/math.h"

namespace nilas::field {

/// Pieces of `outline` outside all `holes`, by CGAL's exact Boolean operations: simple, counter-clockwise, convex or
/// not, largest first. All outlines simple and counter-clockwise. Throws InputError when a piece surrounds a hole,
/// since a floe has none.
std::vector<std::vector<Vec2>> outline_difference(const std::vector<Vec2>& outline,
                                                  const std::vector<std::vector<Vec2>>& holes);

}  // namespace nilas::field
