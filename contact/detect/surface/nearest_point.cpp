#include "contact/detect/surface/nearest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nilas::detect {

namespace {

NearestPoint on_sphere(const Part& part, const Vec3& x) {
  NearestPoint nearest;
  const Vec3 out = x - part.centre;
  const double distance = out.norm();
  if (distance > 0) nearest.normal = out / distance;
  nearest.point = part.centre + part.radius * nearest.normal;
  nearest.distance = distance - part.radius;
  return nearest;
}

/// Share of the radius below which a point counts as on the surface, where the line to its nearest point has no
/// direction.
constexpr double k_rounding = 1e-14;

const Feature k_side{FeatureKind::face, 0, -1}, k_cap{FeatureKind::face, 1, -1}, k_rim{FeatureKind::rim, 0, -1};

NearestPoint on_cylinder(const Part& part, const Vec3& x) {
  const double r = std::sqrt(x.x() * x.x() + x.y() * x.y());
  const Vec3 radial = r > 0 ? Vec3(x.x() / r, x.y() / r, 0) : Vec3::UnitX();
  const Vec3 axial = x.z() < 0 ? Vec3(-Vec3::UnitZ()) : Vec3::UnitZ();
  const double beyond_side = r - part.radius;
  const double beyond_cap = std::abs(x.z()) - part.half_height;
  if (beyond_side > 0 && beyond_cap > 0) {
    const Vec3 point = part.radius * radial + part.half_height * axial;
    const double distance = (x - point).norm();
    return {point, (x - point) / distance, distance, k_rim};
  }
  if (beyond_side > beyond_cap) return {x - beyond_side * radial, radial, beyond_side, k_side};
  return {x - beyond_cap * axial, axial, beyond_cap, k_cap};
}

/// Returns the nearest point of an edge, with the feature: the edge or one of its ends. From the middle the rounding is
/// the same whichever end comes first, as a mirrored part needs it.
NearestPoint on_edge(const FacetedGeometry& facets, int e, const Vec3& x) {
  const PartEdge& edge = facets.edges[e];
  const Vec3 middle = 0.5 * (facets.vertex(edge.v0) + facets.vertex(edge.v1)), half = 0.5 * facets.along(edge);
  const double t = std::clamp(half.dot(x - middle) / half.squaredNorm(), -1.0, 1.0);
  NearestPoint nearest;
  if (t > -1 && t < 1) {
    nearest.point = middle + t * half;
    nearest.feature = {FeatureKind::edge, e, -1};
  } else {
    const int end = t > 0 ? edge.v1 : edge.v0;
    nearest.point = facets.vertex(end);
    nearest.feature = {FeatureKind::vertex_a, end, -1};
  }
  nearest.distance = (x - nearest.point).norm();
  return nearest;
}

bool projects_inside(const geometry::ConvexPolytope& polytope, int face, const Vec3& x) {
  const auto& loop = polytope.faces[face];
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec3& p = polytope.vertices[loop[k]];
    const Vec3& q = polytope.vertices[loop[(k + 1) % loop.size()]];
    if ((q - p).cross(polytope.normals[face]).dot(x - p) > 0) return false;
  }
  return true;
}

/// Returns the nearest point for x outside the polytope. Only the faces that x can see count.
NearestPoint outside_polytope(const FacetedGeometry& facets, const Eigen::ArrayXd& heights, const Vec3& x) {
  const geometry::ConvexPolytope& polytope = *facets.polytope;
  NearestPoint best;
  best.distance = std::numeric_limits<double>::infinity();
  for (int f = 0; f < static_cast<int>(heights.size()); ++f) {
    const double height = heights[f];
    if (height <= 0 || height >= best.distance) continue;
    if (projects_inside(polytope, f, x))
      return {x - height * polytope.normals[f], polytope.normals[f], height, {FeatureKind::face, f, -1}};
    for (int e : facets.face_edges[f]) {
      const NearestPoint nearest = on_edge(facets, e, x);
      if (nearest.distance < best.distance) best = nearest;
    }
  }
  best.normal = (x - best.point) / best.distance;
  return best;
}

NearestPoint on_polytope(const FacetedGeometry& facets, const Vec3& x) {
  const Eigen::ArrayXd heights =
      facets.normals.col(0) * x.x() + facets.normals.col(1) * x.y() + facets.normals.col(2) * x.z() - facets.offsets;
  Eigen::Index nearest = 0;
  const double height = heights.maxCoeff(&nearest);
  if (height > k_rounding * facets.polytope->radius) return outside_polytope(facets, heights, x);
  const Vec3& n = facets.polytope->normals[nearest];
  return {x - height * n, n, height, {FeatureKind::face, static_cast<int>(nearest), -1}};
}

}  // namespace

NearestPoint nearest_point(const Part& part, const Vec3& x) {
  switch (part.kind) {
    case PartKind::sphere:
      return on_sphere(part, x);
    case PartKind::cylinder:
      return on_cylinder(part, x);
    default:
      return on_polytope(*part.facets, x);
  }
}

}  // namespace nilas::detect
