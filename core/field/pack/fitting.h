#pragma once
/// Fits polygon floes to their neighbours: beyond about 86 % random polygons block each other, and real ice is denser
/// only because neighbouring floes broke from each other and share edges.
#include <vector>

#include "core/field/spec/loose_floe.h"

namespace nilas {

struct FittingLimits {
  double gap = 0;        ///< wanted between outlines [m]
  int vertices_min = 3;  ///< corners of a floe
  int vertices_max = 9;
};

/// Drops the corners that hold least ice while there are too many, or while they hold next to none, and chamfers the
/// sharpest while there are too few; takes ice away only. `area` is that of the floe [m^2].
void limit_corners(std::vector<Vec2>& outline, double area, const FittingLimits& limits);

/// Draws a line between every two near floes, on the axis where they lie furthest apart and nearer to the smaller one:
/// the lines, the region's edge and the obstacles bound a cell for each floe, and cells do not overlap. A floe that
/// reaches beyond its cell is scaled about its centroid and cut to the cell until it has its area again, so that it
/// grows into the free water beside it; corners are dropped or added to keep their number in range. A floe whose cell
/// is too small keeps its area and overlaps still: relaxation then makes room, and the fitting is repeated. Returns the
/// indices of the floes that changed.
std::vector<std::size_t> fit_outlines(std::vector<LooseFloe>& floes, const FieldBounds& bounds,
                                      const FittingLimits& limits);

}  // namespace nilas
