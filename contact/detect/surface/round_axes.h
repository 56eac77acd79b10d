#pragma once
/// Finds axes that a cylinder's rim makes with an edge.
#include "core/base/math.h"

namespace nilas::detect {

/// A cylinder in some frame.
struct RoundBody {
  Vec3 centre = Vec3::Zero(), axis = Vec3::UnitZ();
  double radius = 0, half_height = 0;  ///< [m]
  /// Returns the largest n . (x - centre) over it, for a unit vector n.
  double extent(const Vec3& n) const;
};

/// The directions cos(t) start + sin(t) side, 0 <= t <= angle <= pi; start and side are perpendicular unit vectors.
struct Arc {
  Vec3 start = Vec3::UnitX(), side = Vec3::UnitY();
  double angle = 0;  ///< [rad]
};

/// Returns the shorter arc from one unit vector to another; they must not be opposite.
Arc arc_between(const Vec3& from, const Vec3& to);

struct RoundAxis {
  Vec3 n = Vec3::UnitX();
  double s = 0;  ///< [m]
};

/// Returns an upper bound on the separation of `body` from the point p along the directions of the arc.
double most_over_arc(const Arc& arc, const Vec3& p, double inner_radius, const RoundBody& body);
/// Returns the direction of the arc that separates `body` most from the point p.
RoundAxis best_over_arc(const Arc& arc, const Vec3& p, const RoundBody& body);

}  // namespace nilas::detect
