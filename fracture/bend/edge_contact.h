#pragma once
/// The places where structures press on the edge of a floe, with width, depth and force of each load.
#include <vector>

#include "core/base/math.h"

namespace nilas::fracture {

/// Force of one contact point on a floe, in its frame B.
struct PointLoad {
  Vec3 x = Vec3::Zero();      ///< [m]
  Vec3 force = Vec3::Zero();  ///< [N]
  /// Closing speed along the contact's normal, times the vertical share of the normal: the speed at which the structure
  /// pushes the ice down or up [m/s].
  double speed = 0;
  bool of_area = false;  ///< The point is one of those that represent an area by its second moments.
};

/// A load: points that press together, in the frame B of the floe.
struct EdgeContact {
  Vec2 edge_point = Vec2::Zero();  ///< Point of the outline where the load came in [m].
  /// Direction of the load in the plane, unit. For a vertical load it is the edge's normal into the ice.
  Vec2 inward = Vec2::UnitX();
  bool pushes_in = false;     ///< The load is not vertical: a splitting crack runs along `inward`.
  double from_edge = 0;       ///< Distance from the middle of the load to `edge_point` [m].
  Vec3 force = Vec3::Zero();  ///< [N]
  double width = 0;           ///< 2 b: extent across `inward` [m].
  double depth = 0;           ///< a: extent along `inward` [m].
  double opening = 0;         ///< F_Y: half the sum of the forces' amounts across `inward` [N].
  double speed = 0;           ///< Mean of the points' speeds, weighted with the force [m/s].
};

/// How far the points of one load reach from the strongest of them.
struct LoadReach {
  double link = 0;        ///< Distance in the plane [m].
  double widest_gap = 0;  ///< Length of the way between both that is not in the ice, as across a notch [m].
};

/// The loads on a floe. The strongest point and all points within reach of it are one load; the strongest of the
/// remaining points begins the next. Width and depth are those of an even pressure with the same
/// second moments: sqrt(12) times the force's radius of gyration. Where not all points represent areas, they are the
/// distance of the outermost points. `outline` is counter-clockwise. Points without force do not count. Throws
/// ContractError for fewer than three vertices or a negative reach.
std::vector<EdgeContact> edge_contacts(const std::vector<Vec2>& outline, const std::vector<PointLoad>& loads,
                                       const LoadReach& reach);

}  // namespace nilas::fracture
