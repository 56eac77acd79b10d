#pragma once
/// Two convex parts at their present poses, seen from part A's body frame. The whole search of a pair is done in that
/// frame, so that no digits are lost far from the origin.
#include <algorithm>
#include <limits>

#include "contact/detect/broad/part.h"

namespace nilas::detect {

/// A pose of one frame in another: x_to = R x_from + p.
struct RelativePose {
  Mat3 R = Mat3::Identity();
  Vec3 p = Vec3::Zero();

  Vec3 point(const Vec3& x) const { return R * x + p; }
  RelativePose inverse() const { return {R.transpose(), -(R.transpose() * p)}; }
};

inline RelativePose pose_of_b_in_a(const bodies::Bodies& bodies, int a, int b) {
  const Mat3 to_a = bodies.R_GB[a].transpose();
  return {to_a * bodies.R_GB[b], to_a * (bodies.p_GB[b] - bodies.p_GB[a])};
}

struct PairView {
  const Part& a;
  const Part& b;
  RelativePose b_in_a;
  RelativePose a_in_b;
  double margin = 0;     ///< gaps below this are contacts [m]
  double size = 0;       ///< bounding radius of the smaller part [m]
  double tolerance = 0;  ///< lengths below it are rounding or unevenness of the surfaces [m]
};

/// Resolution of lengths, as a share of the smaller part ...
constexpr double k_length_resolution = 1e-10;
/// ... and as a share of the larger one, about 50 units in the last place.
constexpr double k_coordinate_rounding = 1e-14;

inline PairView view_pair(const Part& a, const Part& b, const RelativePose& b_in_a, double margin) {
  PairView pair{a, b, b_in_a, b_in_a.inverse(), margin};
  pair.size = std::min(a.bounding_radius, b.bounding_radius);
  const double larger = std::max(a.bounding_radius, b.bounding_radius);
  pair.tolerance = k_length_resolution * pair.size + k_coordinate_rounding * (larger + b_in_a.p.norm());
  for (const Part* part : {&a, &b})
    if (part->facets) pair.tolerance += part->facets->roughness;
  return pair;
}

/// Returns the separation of the pair along the unit vector n from A to B, in A's frame: the least n . x over B minus
/// the largest over A [m].
inline double separation(const PairView& pair, const Vec3& n) {
  return n.dot(pair.b_in_a.p) - extent(pair.b, -(pair.b_in_a.R.transpose() * n)) - extent(pair.a, n);
}

/// Returns whether the line of centres separates the pair.
inline bool likely_apart(const PairView& pair) {
  const Vec3 line = pair.b_in_a.point(pair.b.centre) - pair.a.centre;
  return !line.isZero(0) && separation(pair, line.normalized()) > 0;
}

/// The features that made a candidate axis. `unnamed`: an axis of the last call that no feature makes again, because a
/// cylinder has none or because it was not proven.
enum class AxisKind { face_a, face_b, edges, direction, unnamed };

/// A direction in A's frame, from A to B, and the separation along it.
struct Axis {
  Vec3 n = Vec3::UnitX();
  double s = -std::numeric_limits<double>::infinity();  ///< [m]
  AxisKind kind = AxisKind::direction;
  int feature_a = -1;  ///< index of the face for face_a, of the edge for edges
  int feature_b = -1;
  bool proven = false;  ///< set by find_axis: no other axis is better by more than the pair's tolerance
};

}  // namespace nilas::detect
