#pragma once
/// The axis along which two polytopes are farthest apart, or overlap least.
#include "contact/detect/edge_axes.h"
#include "contact/detect/fcl_query.h"
#include "contact/detect/manifold.h"

namespace nilas {

struct AxisSearchCounts {
  int fcl_queries = 0;
  int fallbacks = 0;  ///< FCL gave no direction
};

/// Storage that one thread reuses from pair to pair.
struct AxisSearchRoom {
  FacingSurfaces facing;
  EdgeChoice edges;
};

/// Finds the best axis; on return with axis.s <= margin, room.facing holds the surfaces along it. With axis.s > margin
/// the axis separates and need not be the best.
///
/// The faces of both come first, exactly. When their best is not proven, all pairs of edges that face each other, so
/// that the answer is the best of all axes. Where these are too many (hulls of many facets): edges near the support,
/// then FCL's direction as a further start.
Axis find_axis(const PairView& pair, FclShapes& fcl, AxisSearchRoom& room, AxisSearchCounts& counts);

}  // namespace nilas
