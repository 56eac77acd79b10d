#pragma once
/// Where, how wide and how hard structures press on the edge of a floe.
#include <vector>

#include "core/base/math.h"

namespace nilas {

/// Force of one contact point on a floe, in its frame B.
struct PointLoad {
  Vec3 x = Vec3::Zero();      ///< [m]
  Vec3 force = Vec3::Zero();  ///< [N]
  double speed = 0;           ///< at which the structure closes in along the contact's normal, times how far that is
                              ///< from level: the speed at which it pushes the ice down or up [m/s]
  bool of_area = false;       ///< stands, with others, for an area: by its second moments
};

/// Points that press together, in the frame B of the floe.
struct EdgeContact {
  Vec2 edge_point = Vec2::Zero();  ///< of the outline, where the load came in [m]
  Vec2 inward =
      Vec2::UnitX();          ///< direction of the load in the plane; of a vertical one the edge's normal into the ice
  bool pushes_in = false;     ///< the load is not vertical: a splitting crack runs along `inward`
  double from_edge = 0;       ///< of the middle of the load to `edge_point` [m]
  Vec3 force = Vec3::Zero();  ///< [N]
  double width = 0;           ///< 2 b: across `inward` [m]
  double depth = 0;           ///< a: along it [m]
  double opening = 0;         ///< F_Y: half the sum of the forces' amounts across `inward` [N]
  double speed = 0;           ///< mean over the load [m/s]
};

/// Groups of points: the strongest with all within `link` [m] of it in the plane, then of what is left again. Width and
/// depth are those of an even pressure with the same second moments, sqrt(12) times the force's radius of gyration;
/// where points do not stand for areas, the distance between the outermost. `outline` counter-clockwise. Points without
/// force count for nothing.
std::vector<EdgeContact> edge_contacts(const std::vector<Vec2>& outline, const std::vector<PointLoad>& loads,
                                       double link);

}  // namespace nilas
