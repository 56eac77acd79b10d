#include "hydro/waves/even_surface.h"

#include "core/base/error.h"

namespace nilas::hydro {

namespace {

/// Adds a fan about a new vertex at the origin of each cap, the centroid of the outline.
void add_convex_caps(int corners, double half, geometry::TriangleMesh& mesh) {
  for (const double z : {-half, half}) {
    const int first = z < 0 ? 0 : corners, middle = static_cast<int>(mesh.vertices.size());
    mesh.vertices.emplace_back(0, 0, z);
    for (int i = 0; i < corners; ++i) {
      const int a = first + i, b = first + (i + 1) % corners;
      if (z < 0)
        mesh.triangles.push_back({b, a, middle});
      else
        mesh.triangles.push_back({a, b, middle});
    }
  }
}

/// Adds the triangles of the caps that a surface has. Its vertices are the loops of both caps.
void add_caps_of(const geometry::TriangleMesh& surface, int corners, geometry::TriangleMesh& mesh) {
  for (const auto& triangle : surface.triangles) {
    int on_top = 0;
    for (const int v : triangle) on_top += v >= corners ? 1 : 0;
    if (on_top == 0 || on_top == 3) mesh.triangles.push_back(triangle);
  }
}

}  // namespace

geometry::TriangleMesh even_surface(const geometry::Shape& prism) {
  NILAS_DEMAND(prism.kind == geometry::ShapeKind::prism && prism.outline.size() > 2);
  const int n = static_cast<int>(prism.outline.size());
  const double half = 0.5 * prism.thickness;
  geometry::TriangleMesh mesh;
  for (const double z : {-half, half})
    for (const Vec2& x : prism.outline) mesh.vertices.emplace_back(x.x(), x.y(), z);
  if (prism.parts.size() == 1)
    add_convex_caps(n, half, mesh);
  else
    add_caps_of(prism.surface, n, mesh);
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n, middle = static_cast<int>(mesh.vertices.size());
    const Vec2 mean = 0.5 * (prism.outline[i] + prism.outline[j]);
    mesh.vertices.emplace_back(mean.x(), mean.y(), 0);
    mesh.triangles.push_back({i, j, middle});
    mesh.triangles.push_back({j, n + j, middle});
    mesh.triangles.push_back({n + j, n + i, middle});
    mesh.triangles.push_back({n + i, i, middle});
  }
  return mesh;
}

}  // namespace nilas::hydro
