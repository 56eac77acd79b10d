#pragma once
/// Fits polygon floes to their neighbours. Beyond about 86 % random polygons block each other; real ice is denser
/// because neighbouring floes broke from each other and share edges.
#include <vector>

#include "core/field/spec/loose_floe.h"

namespace nilas::field {

struct FittingLimits {
  double gap = 0;        ///< required gap between outlines [m]
  int vertices_min = 3;  ///< corners of a floe
  int vertices_max = 9;
};

/// Limits the number of corners by removing ice only. While there are too many, or some of negligible area, it drops
/// the smallest corners; while there are too few, it chamfers the sharpest. `area`: that of the floe [m^2].
void limit_corners(std::vector<Vec2>& outline, double area, const FittingLimits& limits);

/// Fits floes to cells that do not overlap. A cell is bounded by the region's edge, the obstacles, and lines between
/// near floes. Each line lies on the axis of their largest separation, closer to the smaller floe. A floe that exceeds
/// its cell is scaled about its centroid and cut to the cell until it has its area again, so that it grows into free
/// water nearby. Corners are removed or added to keep their number in range. A floe with too small a cell keeps its
/// area and still overlaps: relaxation then makes room, and the fitting is repeated. Returns the indices of changed
/// floes.
std::vector<std::size_t> fit_outlines(std::vector<LooseFloe>& floes, const FieldBounds& bounds,
                                      const FittingLimits& limits);

}  // namespace nilas::field
