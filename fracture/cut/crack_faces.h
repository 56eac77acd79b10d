#pragma once
/// The faces between snapped lines.
#include <vector>

#include "fracture/cut/snap_lines.h"

namespace nilas::fracture {

/// The boundary of one face inside the outline, counter-clockwise.
struct CrackFace {
  std::vector<int> points;      ///< indices of SnappedLines::points
  std::vector<int> along;       ///< Place of edge i in SnappedLines::outline, or -1 for a crack.
  bool surrounds_more = false;  ///< Other faces lie inside this one.
};

struct CrackFaces {
  std::vector<CrackFace> faces;  ///< The faces, in an order that depends on the geometry alone.
  std::vector<char> needless;    ///< A flag per point: no vertex of the outline, turn of a crack or junction.
  int slivers = 0;               ///< faces joined to a neighbour
};

/// The faces inside the outline, without cracks that separate nothing. The mean width of a face is twice its area over
/// its perimeter. A face with a mean width below `least_width` [m] joins the neighbour with which it shares most crack
/// length. A crack also counts as straight within `least_width`. `lines` must be settled, with a simple and
/// counter-clockwise outline. Throws CGAL::Failure_exception where CGAL fails.
CrackFaces crack_faces(const SnappedLines& lines, double least_width);

}  // namespace nilas::fracture
