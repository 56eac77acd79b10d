/// Proves that an axis is the best one, from the points of the surfaces along it.
#include <algorithm>
#include <cmath>

#include "contact/detect/surface/edge_axes.h"
#include "contact/detect/surface/manifold.h"

namespace nilas::detect {

namespace {

/// Required reach, in depths, of the Minkowski difference's face of two crossing edges. Its neighbours may then turn by
/// up to 2 atan(8) = 166 degrees before their planes come nearer.
constexpr double k_crossing_reach = 8.0;
/// Required reach of both parts together along the axis, in depths, from the crossing on. Planes that turn farther then
/// stay away too: 1 + 1 / cos(180 - 166 degrees), rounded up.
constexpr double k_crossing_thickness = 2.04;
/// Required distance of a point of a gentle slope from the other faces, in depths.
constexpr double k_slope_reach = 2.0;

/// The part whose face is the axis, and points of the other part in its frame.
struct FaceOwner {
  const FacetedGeometry& facets;
  int face;
  RelativePose a_in_own;

  /// Returns how far inside all other faces a point lies [m].
  double inset(const Vec3& point_in_a) const {
    const Vec3 x = a_in_own.point(point_in_a);
    double highest = -std::numeric_limits<double>::infinity();
    for (int f = 0; f < static_cast<int>(facets.offsets.size()); ++f)
      if (f != face) highest = std::max(highest, facets.normal(f).dot(x) - facets.offsets[f]);
    return -highest;
  }
};

/// Proves the axis of a face. Take a point of the other part that lies as deep under the face as any, and at least as
/// deep under all other faces. It is the centre of a ball of that depth inside the owner, so the parts overlap less
/// along no direction. Where the other part slopes over the face, take a point `rise` above its deepest one, but
/// `reach` inside the other faces. It bounds the depth along all directions by depth (1 - (rise / reach)^2 / 2).
bool face_is_proven(const PairView& pair, const Axis& axis, const FacingSurfaces& facing) {
  const bool of_a = axis.kind == AxisKind::face_a;
  const FaceOwner owner =
      of_a ? FaceOwner{*pair.a.facets, axis.feature_a, {}} : FaceOwner{*pair.b.facets, axis.feature_b, pair.a_in_b};
  const ContactPlane& plane = facing.plane;
  const double depth = -axis.s;
  Vec3 mean = Vec3::Zero();
  double mean_gap = 0;
  for (const OverlayPoint& p : facing.points) {
    const double height = of_a ? p.height_a + p.gap : p.height_a;
    const Vec3 x = p.u * plane.t1 + p.v * plane.t2 + height * plane.n;
    if (p.gap <= axis.s + pair.tolerance && owner.inset(x) >= depth) return true;
    mean += x;
    mean_gap += p.gap;
  }
  const auto count = static_cast<double>(facing.points.size());
  const double reach = owner.inset(mean / count) - depth;
  const double rise = mean_gap / count - axis.s;
  return reach >= (k_slope_reach - 1) * depth && 0.5 * depth * rise * rise <= pair.tolerance * reach * reach;
}

/// Returns how far a part reaches from a point of its surface along the unit vector d, both in its frame [m].
double reach_inside(const FacetedGeometry& facets, const Vec3& x, const Vec3& d) {
  double reach = std::numeric_limits<double>::infinity();
  for (int f = 0; f < static_cast<int>(facets.offsets.size()); ++f) {
    const Vec3 n = facets.normal(f);
    const double rate = n.dot(d);
    if (rate > 0) reach = std::min(reach, (facets.offsets[f] - n.dot(x)) / rate);
  }
  return std::max(reach, 0.0);
}

bool crossing_is_proven(const PairView& pair, const Axis& axis) {
  const FacetedGeometry &a = *pair.a.facets, &b = *pair.b.facets;
  const PartEdge &edge_a = a.edges[axis.feature_a], &edge_b = b.edges[axis.feature_b];
  const Vec3 along_a = a.along(edge_a), along_b = pair.b_in_a.R * b.along(edge_b);
  const Vec3 start_a = a.vertex(edge_a.v0), start_b = pair.b_in_a.point(b.vertex(edge_b.v0));
  // The edges' common perpendicular is the axis, so the nearest points of their lines are the crossing.
  const NearestOnSegments nearest = nearest_on_segments(start_a, along_a, start_b, along_b);
  const double area = along_a.cross(along_b).norm();
  const double from_b = std::min(nearest.t, 1.0 - nearest.t) * area / along_b.norm();
  const double from_a = std::min(nearest.u, 1.0 - nearest.u) * area / along_a.norm();
  const double depth = -axis.s;
  if (std::min(from_a, from_b) < k_crossing_reach * depth) return false;
  const Vec3 on_b = pair.a_in_b.point(start_b + nearest.u * along_b);
  const double thickness = reach_inside(a, start_a + nearest.t * along_a, -axis.n) +
                           reach_inside(b, on_b, pair.b_in_a.R.transpose() * axis.n);
  return thickness >= k_crossing_thickness * depth;
}

}  // namespace

bool is_proven(const PairView& pair, const Axis& axis, const FacingSurfaces& facing) {
  if (!(facing.smallest_gap <= axis.s + pair.tolerance)) return false;
  if (axis.s >= 0) return true;
  switch (axis.kind) {
    case AxisKind::face_a:
    case AxisKind::face_b:
      return face_is_proven(pair, axis, facing);
    case AxisKind::edges:
      return crossing_is_proven(pair, axis);
    default:
      return false;
  }
}

}  // namespace nilas::detect
