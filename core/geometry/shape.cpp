#include "core/geometry/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/error.h"
#include "core/geometry/polygon.h"
#include "core/geometry/prism_surface.h"

namespace nilas::geometry {

namespace {

double reach(const std::vector<Vec3>& points) {
  double r = 0;
  for (const auto& p : points) r = std::max(r, p.norm());
  return r;
}

/// Surface over a convex outline.
TriangleMesh convex_prism_surface(const std::vector<Vec2>& outline, double half) {
  std::vector<int> all(outline.size());
  std::iota(all.begin(), all.end(), 0);
  return prism_surface(outline, {all}, half);
}

/// Corners of a convex piece; fewer than three where it has no width, as the ice between the sides of a needle.
std::vector<Vec2> turning_points(const std::vector<Vec2>& outline, const std::vector<int>& piece) {
  std::vector<Vec2> points, turning;
  for (const int i : piece) points.push_back(outline[i]);
  for (const int k : corners(points)) turning.push_back(points[k]);
  return turning;
}

/// The sides of a convex piece that are sides of the outline, by their first vertices.
std::vector<int> outer_sides(const std::vector<Vec2>& outline, const std::vector<int>& piece) {
  const auto n = static_cast<int>(outline.size());
  std::vector<int> sides;
  for (std::size_t k = 0; k < piece.size(); ++k)
    if (piece[(k + 1) % piece.size()] == (piece[k] + 1) % n) sides.push_back(piece[k]);
  return sides;
}

/// Whether two of these sides bound a strip or a needle: they face each other, or meet in less than 30 degrees.
bool has_facing_sides(const std::vector<Vec2>& outline, const std::vector<int>& sides) {
  constexpr double k_facing = -0.5, k_needle_tip = -0.866;  // cosines between the directions of the sides
  const auto n = static_cast<int>(outline.size());
  const auto direction = [&](int side) -> Vec2 { return (outline[(side + 1) % n] - outline[side]).normalized(); };
  for (const int a : sides)
    for (const int b : sides) {
      const bool meet = b == (a + 1) % n || a == (b + 1) % n;
      if (direction(a).dot(direction(b)) < (meet ? k_needle_tip : k_facing)) return true;
    }
  return false;
}

/// Ice that is narrower than this share of its thickness is a needle, as cracks that meet under rounding leave them.
/// Nothing is lost where a body passes it.
constexpr double k_needle = 1e-3;

/// The smallest width of the ice where the sides of one of several convex pieces bound it; infinite for needles and for
/// pieces that only cuts bound. Behind a sliver, as cuts along a curved crack leave them, the ice goes on. Between two
/// sides that face each other it does not.
double width_of_ice(const std::vector<Vec2>& outline, const std::vector<int>& piece, const ConvexPolytope& part,
                    double thickness) {
  constexpr double k_none = std::numeric_limits<double>::infinity();
  const std::vector<int> sides = outer_sides(outline, piece);
  double width = sides.empty() ? k_none : part.smallest_width;
  if (!has_facing_sides(outline, sides)) {
    double behind = k_none;
    for (const int side : sides) behind = std::min(behind, width_behind(outline, side));
    width = std::max(width, behind);
  }
  return width > k_needle * thickness ? width : k_none;
}

double smallest_width_of(const std::vector<ConvexPolytope>& parts) {
  double width = std::numeric_limits<double>::infinity();
  for (const auto& part : parts) width = std::min(width, part.smallest_width);
  return width;
}

}  // namespace

Shape prism_shape(const std::vector<Vec2>& outline, double thickness) {
  const auto pieces = convex_piece_indices(outline);
  NILAS_DEMAND(thickness > 0);
  Shape s;
  s.kind = ShapeKind::prism;
  s.outline = outline;
  s.thickness = thickness;
  s.smallest_width = thickness;
  for (const auto& piece : pieces) {
    const auto loop = turning_points(outline, piece);
    if (loop.size() < 3) continue;
    const ConvexPolytope& part = s.parts.emplace_back(make_prism(loop, -0.5 * thickness, 0.5 * thickness));
    if (part.smallest_width >= s.smallest_width) continue;
    const double width = pieces.size() > 1 ? width_of_ice(outline, piece, part, thickness) : part.smallest_width;
    s.smallest_width = std::min(s.smallest_width, width);
  }
  NILAS_DEMAND(!s.parts.empty());
  s.surface = prism_surface(outline, pieces, 0.5 * thickness);
  s.bounding_radius = reach(s.surface.vertices);
  return s;
}

Shape box_shape(const Vec3& size) {
  NILAS_DEMAND(size.minCoeff() > 0);
  Shape s;
  s.kind = ShapeKind::box;
  s.parts.push_back(make_box(size));
  s.smallest_width = smallest_width_of(s.parts);
  const double x = 0.5 * size.x(), y = 0.5 * size.y();
  s.surface = convex_prism_surface({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, 0.5 * size.z());
  s.bounding_radius = 0.5 * size.norm();
  return s;
}

Shape sphere_shape(double radius) {
  NILAS_DEMAND(radius > 0);
  Shape s;
  s.kind = ShapeKind::sphere;
  s.radius = radius;
  s.bounding_radius = radius;
  s.smallest_width = 2 * radius;
  return s;
}

Shape cylinder_shape(double radius, double height) {
  NILAS_DEMAND(radius > 0 && height > 0);
  Shape s;
  s.kind = ShapeKind::cylinder;
  s.radius = radius;
  s.half_height = 0.5 * height;
  s.smallest_width = std::min(2 * radius, height);
  constexpr int k_quarter = 16, k_sides = 4 * k_quarter;  // corners then stand 0.08 % of the radius outside the circle
  constexpr double k_step = 2 * k_pi / k_sides;
  const double corner_radius = radius * std::sqrt(k_step / std::sin(k_step));  // polygon of the circle's area
  // From one quarter of the cosine, so that corners which are images of each other have the same bits.
  const auto cosine = [](int i) {
    const int k = i % k_sides, past = k <= 2 * k_quarter ? k : k_sides - k;
    if (past == k_quarter) return 0.0;
    return past < k_quarter ? std::cos(k_step * past) : -std::cos(k_step * (2 * k_quarter - past));
  };
  std::vector<Vec2> outline;
  for (int i = 0; i < k_sides; ++i)
    outline.emplace_back(corner_radius * cosine(i), corner_radius * cosine(i + k_sides - k_quarter));
  s.surface = convex_prism_surface(outline, s.half_height);
  s.bounding_radius = std::max(std::hypot(radius, s.half_height), reach(s.surface.vertices));
  return s;
}

Shape plane_shape() {
  Shape s;
  s.kind = ShapeKind::plane;
  s.smallest_width = std::numeric_limits<double>::infinity();
  s.bounding_radius = std::numeric_limits<double>::infinity();
  return s;
}

Shape mesh_shape(TriangleMesh surface, std::vector<ConvexPolytope> parts) {
  Shape s;
  s.kind = ShapeKind::mesh;
  s.bounding_radius = reach(surface.vertices);
  for (const auto& part : parts) s.bounding_radius = std::max(s.bounding_radius, reach(part.vertices));
  s.surface = std::move(surface);
  s.smallest_width = smallest_width_of(parts);
  s.parts = std::move(parts);
  return s;
}

}  // namespace nilas::geometry
