#pragma once
/// Fits polygon floes to their neighbours: beyond about 84 % random polygons block each other, and real ice is denser
/// only because neighbouring floes broke from each other and share edges.
#include <vector>

#include "core/field/loose_floe.h"

namespace nilas {

struct FittingLimits {
  double gap = 0;        ///< wanted between outlines [m]
  int vertices_min = 3;  ///< corners of a floe
  int vertices_max = 9;
};

/// Cuts overlapping floes along the middle of their overlap and floes beyond the edge or in an obstacle along it, each
/// by a small depth at most; drops or adds corners to keep their number in range; then scales every cut floe about its
/// centroid back to its area, so that it grows into the free water beside it. To be repeated, with relaxation between.
/// Returns the indices of the floes that changed.
std::vector<std::size_t> fit_outlines(std::vector<LooseFloe>& floes, const FieldBounds& bounds,
                                      const FittingLimits& limits);

}  // namespace nilas
