#include "core/geometry/prism_surface.h"

#include <array>
#include <limits>

#include "core/base/error.h"
#include "core/geometry/polygon.h"

namespace nilas::geometry {

namespace {

double twice_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Triangles of a convex piece. Always cutting the smallest true corner keeps straight vertices until a corner beside
/// them is gone, so that none ends up in a triangle without area; a fan could.
std::vector<std::array<int, 3>> cut_ears(const std::vector<Vec2>& outline, std::vector<int> piece) {
  std::vector<Vec2> points;
  for (const int i : piece) points.push_back(outline[i]);
  std::vector<std::array<int, 3>> triangles;
  while (piece.size() > 3) {
    const std::size_t n = piece.size();
    std::size_t best = n;
    double smallest = std::numeric_limits<double>::infinity();
    for (const int corner : corners(points)) {
      const std::size_t i = corner;
      const double area = twice_area(points[(i + n - 1) % n], points[i], points[(i + 1) % n]);
      if (area >= smallest) continue;
      smallest = area;
      best = i;
    }
    NILAS_DEMAND(best < n);
    triangles.push_back({piece[(best + n - 1) % n], piece[best], piece[(best + 1) % n]});
    piece.erase(piece.begin() + static_cast<std::ptrdiff_t>(best));
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(best));
  }
  triangles.push_back({piece[0], piece[1], piece[2]});
  return triangles;
}

}  // namespace

TriangleMesh prism_surface(const std::vector<Vec2>& outline, const std::vector<std::vector<int>>& pieces, double half) {
  const int n = static_cast<int>(outline.size());
  TriangleMesh mesh;
  for (const double z : {-half, half})
    for (const auto& x : outline) mesh.vertices.emplace_back(x.x(), x.y(), z);
  for (const auto& piece : pieces)
    for (const auto& [a, b, c] : cut_ears(outline, piece)) {
      mesh.triangles.push_back({a, c, b});
      mesh.triangles.push_back({n + a, n + b, n + c});
    }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    mesh.triangles.push_back({i, j, n + j});
    mesh.triangles.push_back({i, n + j, n + i});
  }
  return mesh;
}

}  // namespace nilas::geometry
