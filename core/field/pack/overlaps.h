#pragma once
/// Pairs of floes that are near each other, and the deepest overlap of a field.
#include <vector>

#include "core/field/spec/loose_floe.h"

namespace nilas::field {

struct NearPair {
  int a, b;
};
/// Pairs of floes, scaled by `scale` about their centroids, whose circles come within `distance` [m] of each other.
/// Uses a sorted sweep along X; the order depends only on the positions.
std::vector<NearPair> near_pairs(const std::vector<LooseFloe>& floes, double scale, double distance);

/// Deepest overlap between two floes, or of a floe with an obstacle or the region's edge; 0 when none overlap [m].
double deepest_overlap(const std::vector<LooseFloe>& floes, const FieldBounds& bounds);

/// Largest distance of a corner beyond the region's rectangle; < 0: all inside [m].
double beyond_edge(const ConvexOutline& outline, const FieldBounds& bounds);

}  // namespace nilas::field
