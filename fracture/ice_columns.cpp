#include "fracture/ice_columns.h"

#include <algorithm>
#include <cmath>

#include "core/bodies/mass_properties.h"

namespace nilas {

namespace {

/// A face's normal and a piece of it agree to this, the sine of an angle.
constexpr double k_same_normal = 1e-6;
/// Below this share of the whole a normal has no part in the plane: the rounding of a turned frame.
constexpr double k_level = 1e-12;

/// What of a polygon lies where n . x <= offset; where that is several pieces, edges there and back join them.
std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, const Vec2& n, double offset) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double above_a = n.dot(a) - offset, above_b = n.dot(b) - offset;
    if (above_a <= 0) kept.push_back(a);
    if ((above_a < 0 && above_b > 0) || (above_a > 0 && above_b < 0))
      kept.emplace_back(a + above_a / (above_a - above_b) * (b - a));
  }
  return kept;
}

/// Of an outline and a convex polygon.
PolygonMoments common_part(std::vector<Vec2> outline, const std::vector<Vec2>& convex) {
  for (std::size_t i = 0; i < convex.size() && !outline.empty(); ++i) {
    const Vec2 edge = convex[(i + 1) % convex.size()] - convex[i];
    const Vec2 n(edge.y(), -edge.x());
    outline = clipped(outline, n, n.dot(convex[i]));
  }
  return polygon_moments(outline);
}

double common_area(const std::vector<std::vector<Vec2>>& polygons, const std::vector<Vec2>& outline) {
  double area = 0;
  for (const auto& polygon : polygons) area += common_part(outline, polygon).area;
  return area;
}

}  // namespace

ColumnArea column_area(const CrushedIce& ice, const std::vector<Vec2>& outline) {
  ColumnArea sum;
  for (const auto& column : ice.columns) {
    const PolygonMoments within = common_part(outline, column);
    sum.area += within.area;
    sum.outside += polygon_moments(column).area - within.area;
    sum.centroid += within.area * within.centroid;
  }
  if (sum.area > 0) sum.centroid /= sum.area;
  return sum;
}

bool is_squeezed_out(const CrushedIce& ice, const std::vector<Vec2>& piece) {
  constexpr double k_most = 0.5, k_all = 1 - 1e-6;  // shares of a piece that is, but for rounding, in or out as a whole
  const double area = polygon_moments(piece).area;
  return common_area(ice.columns, piece) > k_most * area || common_area(ice.sections, piece) > k_all * area;
}

std::vector<Vec2> columns_inside(const ConvexPolytope& part, const std::vector<char>& is_outer,
                                 const Placement& hull_in_floe, double thickness, double margin, const Vec2& low,
                                 const Vec2& high) {
  std::vector<Vec2> polygon{low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  for (std::size_t f = 0; f < part.normals.size() && polygon.size() >= 3; ++f) {
    const Vec3 n = hull_in_floe.R * part.normals[f];
    const Vec2 plan = n.head<2>();
    // the end of the column that is nearest to the face
    const double inside = part.offsets[f] + n.dot(hull_in_floe.p) - 0.5 * thickness * std::abs(n.z());
    if (plan.norm() <= k_level) {
      if (inside < 0) return {};
      continue;
    }
    polygon = clipped(polygon, plan, inside - (is_outer[f] ? margin * plan.norm() : 0));
  }
  return polygon.size() >= 3 ? polygon : std::vector<Vec2>();
}

std::vector<std::vector<char>> outer_faces(const std::vector<ConvexPolytope>& parts,
                                           const std::vector<HullFace>& faces) {
  std::vector<std::vector<char>> outer;
  for (const ConvexPolytope& part : parts) outer.emplace_back(part.normals.size(), 0);
  for (const HullFace& face : faces) {
    const auto k = static_cast<std::size_t>(face.part);
    for (std::size_t f = 0; f < parts[k].normals.size(); ++f)
      if (parts[k].normals[f].cross(face.normal).norm() < k_same_normal && parts[k].normals[f].dot(face.normal) > 0)
        outer[k][f] = 1;
  }
  return outer;
}

}  // namespace nilas
