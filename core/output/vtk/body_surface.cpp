#include "core/output/vtk/body_surface.h"

#include <cmath>
#include <numeric>

namespace nilas::output {

namespace {

PolygonSurface prism_surface(const geometry::Shape& shape) {
  PolygonSurface surface;
  const auto n = static_cast<std::int32_t>(shape.outline.size());
  for (const double z : {-0.5 * shape.thickness, 0.5 * shape.thickness})
    for (const Vec2& x : shape.outline) surface.points.emplace_back(x.x(), x.y(), z);
  std::vector<std::int32_t> bottom(shape.outline.size()), top(shape.outline.size());
  std::iota(bottom.rbegin(), bottom.rend(), 0);
  std::iota(top.begin(), top.end(), n);
  surface.add_polygon(bottom);
  surface.add_polygon(top);
  for (std::int32_t i = 0; i < n; ++i) {
    const std::int32_t next = (i + 1) % n;
    surface.add_polygon({i, next, n + next, n + i});
  }
  return surface;
}

/// A sphere with the points: south pole, the rings from south to north, north pole.
PolygonSurface sphere_surface(double radius) {
  constexpr std::int32_t k_meridians = 24, k_rings = 11;  // facets of 15 degrees
  PolygonSurface surface;
  surface.points.emplace_back(0, 0, -radius);
  for (int ring = 1; ring <= k_rings; ++ring) {
    const double latitude = k_pi * (static_cast<double>(ring) / (k_rings + 1) - 0.5);
    for (int m = 0; m < k_meridians; ++m) {
      const double longitude = 2 * k_pi * m / k_meridians;
      surface.points.emplace_back(radius * std::cos(latitude) * std::cos(longitude),
                                  radius * std::cos(latitude) * std::sin(longitude), radius * std::sin(latitude));
    }
  }
  surface.points.emplace_back(0, 0, radius);
  const auto at = [](std::int32_t ring, std::int32_t m) { return 1 + ring * k_meridians + m % k_meridians; };
  const std::int32_t north = 1 + k_rings * k_meridians;
  for (std::int32_t m = 0; m < k_meridians; ++m) {
    surface.add_polygon({0, at(0, m + 1), at(0, m)});
    for (std::int32_t ring = 0; ring + 1 < k_rings; ++ring)
      surface.add_polygon({at(ring, m), at(ring, m + 1), at(ring + 1, m + 1), at(ring + 1, m)});
    surface.add_polygon({at(k_rings - 1, m), at(k_rings - 1, m + 1), north});
  }
  return surface;
}

PolygonSurface triangle_surface(const geometry::TriangleMesh& mesh) {
  PolygonSurface surface;
  surface.points = mesh.vertices;
  for (const auto& t : mesh.triangles) surface.add_polygon({t[0], t[1], t[2]});
  return surface;
}

}  // namespace

void PolygonSurface::add_polygon(const std::vector<std::int32_t>& loop) {
  corners.insert(corners.end(), loop.begin(), loop.end());
  ends.push_back(static_cast<std::int32_t>(corners.size()));
}

PolygonSurface polygon_surface(const geometry::Shape& shape) {
  switch (shape.kind) {
    case geometry::ShapeKind::prism:
      return prism_surface(shape);
    case geometry::ShapeKind::sphere:
      return sphere_surface(shape.radius);
    case geometry::ShapeKind::plane:
      return {};
    case geometry::ShapeKind::box:
    case geometry::ShapeKind::cylinder:
    case geometry::ShapeKind::mesh:
      return triangle_surface(shape.surface);
  }
  return {};
}

}  // namespace nilas::output
