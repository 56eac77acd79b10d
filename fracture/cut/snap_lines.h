#pragma once
/// An outline and cracks brought to common points, so that they meet nowhere else.
#include <vector>

#include "core/base/math.h"

namespace nilas {

/// Lines as sequences of indices of `points`; no two points of a new line and an old one are closer than `resolution`,
/// except where the outline has them so.
struct SnappedLines {
  std::vector<Vec2> points;              ///< first those of the outline, bit for bit [m]
  std::vector<char> given;               ///< per point: a vertex of the outline or a crack, not an intersection
  std::vector<int> outline;              ///< closed: its vertices, and where cracks meet its edges
  std::vector<std::vector<int>> cracks;  ///< open
  int num_corners = 0;                   ///< vertices of the outline given
  bool settled = false;                  ///< no two lines cross; false when the passes did not suffice
};

/// Distance below which points and lines are taken for one: 2^-46 of the largest coordinate, 64 units in its last
/// place [m].
double snap_resolution(const std::vector<Vec2>& outline);

/// Iterated snap rounding (Halperin and Packer 2002, Comput. Geom. 23(2)): crossings are computed exactly and rounded
/// once, crack vertices within `resolution` of the outline are moved onto it, and lines that pass a point within
/// `resolution` go through it; again until nothing changes. The outline's own vertices stay. All points finite.
SnappedLines snap_lines(const std::vector<Vec2>& outline, const std::vector<std::vector<Vec2>>& cracks,
                        double resolution);

}  // namespace nilas
