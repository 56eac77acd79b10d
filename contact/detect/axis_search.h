#pragma once
/// The axis along which two polytopes are farthest apart, or overlap least.
#include "contact/detect/edge_axes.h"
#include "contact/detect/fcl_query.h"
#include "contact/detect/manifold.h"

namespace nilas {

struct AxisSearchCounts {
  int fcl_queries = 0;
  int fallbacks = 0;  ///< FCL gave no direction
  int kept = 0;       ///< the remembered axis served again
};

/// Storage that one thread reuses from pair to pair.
struct AxisSearchRoom {
  FacingSurfaces facing;
  EdgeChoice edges;
  std::vector<int> vertices;
};

/// What made a pair's axis at the last call, where the pair was then within the margin and the axis proven.
struct RememberedAxis {
  AxisKind kind = AxisKind::direction;  ///< direction: nothing is remembered
  int feature_a = -1, feature_b = -1;
};

/// Finds the best axis; on return with axis.s <= margin, room.facing holds the surfaces along it. With axis.s > margin
/// the axis separates and need not be the best.
///
/// The remembered axis serves again while it is proven or separates by more than the margin: of two axes within the
/// pair's tolerance of each other the pair keeps the one it had. Else the faces of both come first, exactly. When their
/// best is not proven, all pairs of edges that face each other, so that the answer is the best of all axes. Where these
/// are too many (hulls of many facets): edges near the support, then FCL's direction as a further start.
Axis find_axis(const PairView& pair, const RememberedAxis& remembered, FclShapes& fcl, AxisSearchRoom& room,
               AxisSearchCounts& counts);

}  // namespace nilas
