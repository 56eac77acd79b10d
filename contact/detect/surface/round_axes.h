#pragma once
/// Axes that a cylinder's rim makes with an edge.
#include "core/base/math.h"

namespace nilas {

/// A cylinder in some frame.
struct RoundBody {
  Vec3 centre = Vec3::Zero(), axis = Vec3::UnitZ();
  double radius = 0, half_height = 0;  ///< [m]
  /// Largest n . (x - centre) over it, n a unit vector.
  double extent(const Vec3& n) const;
};

/// Directions cos(t) start + sin(t) side, 0 <= t <= angle <= pi; start and side are square unit vectors.
struct Arc {
  Vec3 start = Vec3::UnitX(), side = Vec3::UnitY();
  double angle = 0;  ///< [rad]
};

/// From one unit vector to another, the short way; they are not opposite.
Arc arc_between(const Vec3& from, const Vec3& to);

struct RoundAxis {
  Vec3 n = Vec3::UnitX();
  double s = 0;  ///< [m]
};

/// Upper bound of what the directions of the arc separate `body` from the point p.
double most_over_arc(const Arc& arc, const Vec3& p, double inner_radius, const RoundBody& body);
/// The direction of the arc that separates `body` most from the point p.
RoundAxis best_over_arc(const Arc& arc, const Vec3& p, const RoundBody& body);

}  // namespace nilas
