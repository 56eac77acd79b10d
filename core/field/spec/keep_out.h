#pragma once
/// Outlines that ice keeps clear of, with a margin.
#include <vector>

#include "core/base/math.h"

namespace nilas::field {

/// The convex counter-clockwise outline grown by `margin` [m] on all sides; round corners become short edges outside
/// the circle, so that the result holds every point within the margin.
std::vector<Vec2> grown_outline(const std::vector<Vec2>& outline, double margin);
/// All outlines grown. Throws InputError naming an outline that is not convex and counter-clockwise, or the margin.
std::vector<std::vector<Vec2>> grown_outlines(const std::vector<std::vector<Vec2>>& outlines, double margin);

/// Area of the rectangle that no outline covers [m^2]; convex counter-clockwise outlines, which may overlap.
double free_area(const Vec2& low, const Vec2& high, const std::vector<std::vector<Vec2>>& outlines);

/// The part of the convex counter-clockwise outline where normal . x <= offset; empty when nothing is left.
std::vector<Vec2> cut_outline(const std::vector<Vec2>& outline, const Vec2& normal, double offset);

}  // namespace nilas::field
