#pragma once
/// An outline and cracks that meet at common points only.
#include <vector>

#include "core/base/math.h"

namespace nilas::fracture {

/// Lines as sequences of indices of `points`. A point was added only where the line could use no known point within the
/// resolution. Given vertices of the outline stay, however close to each other they are.
struct SnappedLines {
  std::vector<Vec2> points;  ///< All points, first those of the outline, bit for bit [m].
  std::vector<char> given;   ///< A flag per point: a given vertex of the outline or of a crack, not an intersection.
  std::vector<int> outline;  ///< Closed line: its vertices, and the points where cracks meet its edges.
  std::vector<std::vector<int>> cracks;  ///< Open lines.
  int num_corners = 0;                   ///< Number of vertices of the given outline.
  bool settled = false;                  ///< No two lines cross. False where the passes did not suffice.
};

/// The distance below which points and lines are the same [m]: 2^-46 of the largest coordinate, 64 units in its last
/// place.
double snap_resolution(const std::vector<Vec2>& outline);

/// Iterated snap rounding (Halperin and Packer 2002, Comput. Geom. 23(2)). Crossings are computed exactly and rounded
/// once. Crack vertices within `resolution` [m] of the outline are moved onto it. Lines that pass a point within
/// `resolution` go through it. This is repeated until nothing changes. The outline's own vertices stay. All points must
/// be finite.
SnappedLines snap_lines(const std::vector<Vec2>& outline, const std::vector<std::vector<Vec2>>& cracks,
                        double resolution);

}  // namespace nilas::fracture
