/// Proofs that an axis is the best one, from what the surfaces along it show.
#include <algorithm>
#include <cmath>

#include "contact/detect/edge_axes.h"
#include "contact/detect/manifold.h"

namespace nilas {

namespace {

/// Depths above this share of both parts' widths along the axis together are not proven for crossing edges.
constexpr double k_shallow = 0.05;
/// How far, in depths, the Minkowski difference's face of two crossing edges must reach: its neighbours may then turn
/// by up to 2 atan(8) = 166 degrees before their planes come nearer.
constexpr double k_crossing_reach = 8.0;
/// How far, in depths, a point of a gentle slope must lie from the other faces.
constexpr double k_slope_reach = 2.0;

/// The part whose face is the axis, and points of the other part in its frame.
struct FaceOwner {
  const FacetedGeometry& facets;
  int face;
  RelativePose a_in_own;

  /// How far inside all other faces a point lies.
  double inset(const Vec3& point_in_a) const {
    const Vec3 x = a_in_own.point(point_in_a);
    double highest = -std::numeric_limits<double>::infinity();
    for (int f = 0; f < static_cast<int>(facets.offsets.size()); ++f)
      if (f != face) highest = std::max(highest, facets.polytope->normals[f].dot(x) - facets.offsets[f]);
    return -highest;
  }
};

/// A point of the other part that lies as deep under the face as any, and at least as deep under all other faces, is
/// the centre of a ball of that depth inside the owner: along no direction do the parts overlap less. Where the other
/// part slopes over the face, a point `rise` above its deepest one, but `reach` inside the other faces, bounds the
/// depth along all directions by depth (1 - (rise / reach)^2 / 2).
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

bool is_shallow(const PairView& pair, const Axis& axis) {
  const double narrow = std::min(pair.a.smallest_width, pair.b.smallest_width);
  if (-axis.s <= k_shallow * narrow) return true;
  // Both widths are what the parts overlap by along -n, less the depth.
  return -axis.s <= k_shallow * -separation(pair, -axis.n);
}

bool crossing_is_proven(const PairView& pair, const Axis& axis) {
  if (!is_shallow(pair, axis)) return false;
  const ConvexPolytope& a = *pair.a.facets->polytope;
  const ConvexPolytope& b = *pair.b.facets->polytope;
  const PartEdge& edge_a = pair.a.facets->edges[axis.feature_a];
  const PartEdge& edge_b = pair.b.facets->edges[axis.feature_b];
  const Vec3 along_b = pair.b_in_a.R * edge_b.along;
  // The edges' common perpendicular is the axis, so the nearest points of their lines are the crossing.
  const NearestOnSegments nearest =
      nearest_on_segments(a.vertices[edge_a.v0], edge_a.along, pair.b_in_a.point(b.vertices[edge_b.v0]), along_b);
  const double area = edge_a.along.cross(along_b).norm();
  const double from_b = std::min(nearest.t, 1.0 - nearest.t) * area / along_b.norm();
  const double from_a = std::min(nearest.u, 1.0 - nearest.u) * area / edge_a.along.norm();
  return std::min(from_a, from_b) >= k_crossing_reach * -axis.s;
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

}  // namespace nilas
