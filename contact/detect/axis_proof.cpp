#include <cmath>

#include "contact/detect/edge_axes.h"
#include "contact/detect/manifold.h"

namespace nilas {

namespace {

/// Depths above this share of both parts' widths along the axis together are not proven: the far sides may be nearer.
constexpr double k_shallow = 0.05;
/// How far, in depths, the Minkowski difference's face must reach: its neighbours may then turn by up to
/// 2 atan(8) = 166 degrees, more than at any edge of a floe or hull part, before their planes come nearer.
constexpr double k_reach = 8.0;

bool is_shallow(const PairView& pair, const Axis& axis) {
  const double narrow = std::min(pair.a.smallest_width, pair.b.smallest_width);
  if (-axis.s <= k_shallow * narrow) return true;
  // Both widths are what the parts overlap by along -n, less the depth.
  return -axis.s <= k_shallow * -separation(pair, -axis.n);
}

/// The overlap shown at a point of both surfaces, `rise` above the support and `reach` inside the face, bounds the depth
/// along all directions from below by depth (1 - (rise / reach)^2 / 2).
bool bounds_depth(const PairView& pair, double depth, double rise, double reach) {
  if (reach < k_reach * depth) return false;
  const double slope = rise / reach;
  return rise <= pair.tolerance || 0.5 * depth * slope * slope <= pair.tolerance;
}

bool face_is_proven(const PairView& pair, const Axis& axis, const FacingSurfaces& facing) {
  const SurfaceLoop& face = axis.kind == AxisKind::face_a ? facing.a[0] : facing.b[0];
  const double depth = -axis.s;
  double u = 0, v = 0, gap = 0;
  for (const OverlayPoint& p : facing.points) {
    if (p.gap <= axis.s + pair.tolerance && bounds_depth(pair, depth, 0, inset(face, p.u, p.v))) return true;
    u += p.u;
    v += p.v;
    gap += p.gap;
  }
  if (facing.a.size() * facing.b.size() != 1) return false;
  const auto count = static_cast<double>(facing.points.size());
  return bounds_depth(pair, depth, gap / count - axis.s, inset(face, u / count, v / count));
}

bool crossing_is_proven(const PairView& pair, const Axis& axis) {
  const ConvexPolytope& a = *pair.a.facets->polytope;
  const ConvexPolytope& b = *pair.b.facets->polytope;
  const PartEdge& edge_a = pair.a.facets->edges[axis.feature_a];
  const PartEdge& edge_b = pair.b.facets->edges[axis.feature_b];
  const Vec3 along_a = a.vertices[edge_a.v1] - a.vertices[edge_a.v0];
  const Vec3 along_b = pair.b_in_a.R * (b.vertices[edge_b.v1] - b.vertices[edge_b.v0]);
  // The edges' common perpendicular is the axis, so the nearest points of their lines are the crossing.
  const NearestOnSegments nearest =
      nearest_on_segments(a.vertices[edge_a.v0], along_a, pair.b_in_a.point(b.vertices[edge_b.v0]), along_b);
  const double area = along_a.cross(along_b).norm();
  const double from_b = std::min(nearest.t, 1.0 - nearest.t) * area / along_b.norm();
  const double from_a = std::min(nearest.u, 1.0 - nearest.u) * area / along_a.norm();
  return bounds_depth(pair, -axis.s, 0, std::min(from_a, from_b));
}

}  // namespace

bool is_proven(const PairView& pair, const Axis& axis, const FacingSurfaces& facing) {
  if (!(facing.smallest_gap <= axis.s + pair.tolerance)) return false;
  if (axis.s >= 0) return true;
  if (!is_shallow(pair, axis)) return false;
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
