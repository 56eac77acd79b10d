#pragma once
/// Contact of convex outlines in the still-water plane, for the overlap relaxation.
#include <vector>

#include "core/base/math.h"

namespace nilas::field {

/// Convex counter-clockwise outline with the outward unit normal of each edge (i, i + 1).
struct ConvexOutline {
  std::vector<Vec2> corners;  ///< frame G [m]
  std::vector<Vec2> normals;
};

/// Computes the normals of the present corners.
void fill_normals(ConvexOutline& outline);

/// Axis of largest separation of two outlines: the normal of edge `edge` of the first or the second outline.
struct SeparatingAxis {
  double gap = 0;  ///< gap along the axis; < 0: overlap depth [m]
  int edge = 0;
  bool of_first = true;
};
SeparatingAxis best_axis(const ConvexOutline& first, const ConvexOutline& second);
/// Gap along one given edge normal [m].
double gap_on_axis(const ConvexOutline& first, const ConvexOutline& second, int edge, bool of_first);

/// Up to two touching points of two outlines; both points share the normal.
struct Touching {
  Vec2 normal = Vec2::UnitX();  ///< unit, from the first outline to the second
  int count = 0;
  Vec2 point[2];           ///< [m]
  double gap[2] = {0, 0};  ///< < 0: overlap [m]
};
/// The ends of the incident edge whose gap is below `reach` [m], moved along it to the span of the reference edge where
/// they exceed it. For overlapping outlines one point has the overlap depth of the axis.
Touching touching_points(const ConvexOutline& first, const ConvexOutline& second, const SeparatingAxis& axis,
                         double reach);

}  // namespace nilas::field
