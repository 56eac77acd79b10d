#pragma once
/// Planar outlines of floes.
#include <vector>

#include "core/base/math.h"

namespace nilas::geometry {

/// True when no two edges cross or touch except neighbours at their shared vertex, and no edge has length zero: none is
/// too short. Decided exactly.
bool is_simple(const std::vector<Vec2>& outline);
/// Simple, and turning one way only; turns below k_straight_angle count as straight.
bool is_convex(const std::vector<Vec2>& outline);
/// Turns smaller than this are rounding of a straight edge [rad].
constexpr double k_straight_angle = 1e-10;
/// Vertices where the outline turns by more than k_straight_angle, in order.
std::vector<int> corners(const std::vector<Vec2>& outline);
/// Point in a simple polygon (boundary counts as inside). Decided exactly.
bool contains(const std::vector<Vec2>& outline, const Vec2& point);
/// Exact partition of a simple counter-clockwise polygon into convex counter-clockwise pieces over the same vertices
/// (CGAL): the fewest possible for outlines of few corners (Greene 1983), else at most four times as many (Hertel and
/// Mehlhorn 1983). Throws InputError when the outline is not simple or runs clockwise.
std::vector<std::vector<Vec2>> convex_pieces(const std::vector<Vec2>& outline);
/// The same pieces as vertex indices of `outline`.
std::vector<std::vector<int>> convex_piece_indices(const std::vector<Vec2>& outline);
/// The least way straight inwards from edge i (from vertex i to the next) to the other side of a simple
/// counter-clockwise outline [m]: from its middle, and to vertices that lie before the edge, without those of its
/// neighbours.
double width_behind(const std::vector<Vec2>& outline, int i);
/// Convex hull, counter-clockwise, without collinear points.
std::vector<Vec2> convex_hull(std::vector<Vec2> points);
/// Overlap depth of two convex counter-clockwise polygons by separating axes: > 0 overlap, < 0 gap along the best edge
/// normal, at most the distance [m].
double convex_overlap(const std::vector<Vec2>& a, const std::vector<Vec2>& b);

}  // namespace nilas::geometry
