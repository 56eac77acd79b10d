#pragma once
/// Faces between snapped lines.
#include <vector>

#include "fracture/cut/snap_lines.h"

namespace nilas {

/// Boundary of one face inside the outline, counter-clockwise.
struct CrackFace {
  std::vector<int> points;      ///< indices of SnappedLines::points
  std::vector<int> along;       ///< edge i: its place in SnappedLines::outline, or -1 for a crack
  bool surrounds_more = false;  ///< other faces lie inside it
};

struct CrackFaces {
  std::vector<CrackFace> faces;  ///< in an order that depends on the geometry alone
  std::vector<char> needless;    ///< per point: no corner of the outline, turn of a crack or junction any more
  int slivers = 0;               ///< faces joined to a neighbour
};

/// Faces inside the outline, without what separates nothing. Faces whose mean width, twice the area over the
/// perimeter, is below `least_width` [m], below which a crack counts as straight too, join the neighbour with which
/// they share most crack length. `lines` settled, its outline simple and counter-clockwise. Throws
/// CGAL::Failure_exception where CGAL gives up.
CrackFaces crack_faces(const SnappedLines& lines, double least_width);

}  // namespace nilas
