#pragma once
/// Finds the axis along which two polytopes are farthest apart, or overlap least.
#include "contact/detect/search/fcl_query.h"
#include "contact/detect/surface/edge_axes.h"
#include "contact/detect/surface/manifold.h"

namespace nilas::detect {

struct AxisSearchCounts {
  int fcl_queries = 0;  ///< pairs for which FCL was asked
  int fallbacks = 0;    ///< FCL gave no usable answer
  int kept = 0;         ///< the remembered axis served again
  int by_fcl = 0;       ///< FCL's answer was the pair's axis, as the exact search proved
  int corrected = 0;    ///< the exact search found a better axis than FCL, or FCL gave none
  int searched =
      0;  ///< the exact search alone gave the axis: for a pair that touched before, or where FCL was not asked first
};

/// Storage that one thread reuses from pair to pair.
struct AxisSearchRoom {
  FacingSurfaces facing;
  EdgeChoice edges;
  std::vector<int> vertices;
  std::vector<Axis> rivals;
};

/// FCL's direction counts as the axis itself within a thousandth of a radian [cosine].
constexpr double k_same_direction = 1 - 5e-7;

/// Largest number of pairs of facing edges up to which all are combined as a last resort (about 100 us).
constexpr std::size_t k_most_edge_pairs = 20000;

/// The features that made a pair's axis at the last call, where the pair was within the margin and the axis proven.
struct RememberedAxis {
  AxisKind kind = AxisKind::direction;  ///< `direction` where the pair had no such axis
  int feature_a = -1, feature_b = -1;
};

/// Finds the best axis. Where axis.s <= margin on return, room.facing holds the surfaces along it. Where axis.s >
/// margin, the axis separates the pair and need not be the best.
///
/// The remembered axis serves again while it is proven or separates by more than the margin: of two axes that tie, the
/// pair keeps the one it had. Otherwise FCL is asked first, unless the remembered axis is unnamed or `ask_first` is
/// false. When its direction separates by more than the margin, the search is over. Otherwise the separation along the
/// faces that its direction names is a lower bound, which leaves few faces in question. The faces of both parts are
/// then searched exactly. When their best is not proven, all pairs of edges that face each other follow, so that the
/// answer is the best of all axes whatever FCL returned. Where these are too many (hulls of many facets), edges near
/// the support are tried, then those near FCL's direction.
Axis find_axis(const PairView& pair, const RememberedAxis& remembered, FclShapes& fcl, bool ask_first,
               AxisSearchRoom& room, AxisSearchCounts& counts);

}  // namespace nilas::detect
