#include "fracture/ice_columns.h"

#include <algorithm>
#include <cmath>

namespace nilas {

namespace {

/// A face's normal and a piece of it agree to this, the sine of an angle.
constexpr double k_same_normal = 1e-6;
/// Below this share of the whole a normal has no part in the plane: the rounding of a turned frame.
constexpr double k_level = 1e-12;

/// What of a convex polygon lies where n . x <= offset.
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

}  // namespace

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
