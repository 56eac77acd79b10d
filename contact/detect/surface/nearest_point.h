#pragma once
/// Finds the point of a part's surface nearest to a given point.
#include "contact/detect/broad/contact_key.h"
#include "contact/detect/broad/part.h"

namespace nilas::detect {

struct NearestPoint {
  Vec3 point = Vec3::Zero();    ///< point on the surface, in the part's frame
  Vec3 normal = Vec3::UnitX();  ///< outward unit normal, along the line through both points
  double distance = 0;          ///< signed: < 0 when the given point is inside [m]
  Feature feature;              ///< face, edge or vertex on which it lies
};

/// Returns the nearest point exactly, for a polytope, cylinder or sphere. For a point inside it is the one on the
/// nearest face (cap, side).
NearestPoint nearest_point(const Part& part, const Vec3& x);

}  // namespace nilas::detect
