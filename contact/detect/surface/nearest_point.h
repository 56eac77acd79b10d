#pragma once
/// The point of a part's surface nearest to a given point.
#include "contact/detect/broad/contact_key.h"
#include "contact/detect/broad/part.h"

namespace nilas {

struct NearestPoint {
  Vec3 point = Vec3::Zero();    ///< on the surface, in the part's frame
  Vec3 normal = Vec3::UnitX();  ///< unit, outward, along the line through both points
  double distance = 0;          ///< signed: < 0 when the given point is inside [m]
  Feature feature;              ///< the face, edge or vertex it lies on
};

/// Exact for polytope, cylinder and sphere. Inside, the way out through the nearest face (cap, side).
NearestPoint nearest_point(const Part& part, const Vec3& x);

}  // namespace nilas
