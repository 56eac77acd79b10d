#include "hydro/wet_body.h"

#include <numeric>
#include <vector>

namespace nilas::hydro {

bool takes_water(const bodies::Bodies& bodies, int b) {
  const auto i = static_cast<std::size_t>(b);
  if (bodies.shape[i]->kind == geometry::ShapeKind::plane) return false;
  if (bodies.kind[i] == bodies::BodyKind::vessel) return true;
  return bodies.is_free(b) && (bodies.kind[i] == bodies::BodyKind::floe || bodies.kind[i] == bodies::BodyKind::rigid);
}

namespace {

/// Adds a face as triangles around its middle.
void add_around(const Vec3& middle, const std::vector<int>& face, geometry::TriangleMesh& mesh) {
  const int m = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back(middle);
  for (std::size_t k = 0; k < face.size(); ++k) mesh.triangles.push_back({m, face[k], face[(k + 1) % face.size()]});
}

geometry::TriangleMesh box_around_middles(const geometry::ConvexPolytope& box) {
  geometry::TriangleMesh mesh;
  mesh.vertices = box.vertices;
  for (const auto& face : box.faces) {
    Vec3 sum = Vec3::Zero();
    for (const int v : face) sum += box.vertices[v];
    add_around(sum / static_cast<double>(face.size()), face, mesh);
  }
  return mesh;
}

/// `surface`: that of cylinder_shape(), whose vertices are the corners of the lower cap and then those of the upper.
geometry::TriangleMesh cylinder_around_middles(const geometry::TriangleMesh& surface, double half_height) {
  geometry::TriangleMesh mesh;
  mesh.vertices = surface.vertices;
  const int n = static_cast<int>(surface.vertices.size()) / 2;
  std::vector<int> lower(n), upper(n);
  std::iota(upper.begin(), upper.end(), n);
  std::iota(lower.rbegin(), lower.rend(), 0);  // seen from outside, corners go round to the left
  add_around({0, 0, -half_height}, lower, mesh);
  add_around({0, 0, half_height}, upper, mesh);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    // Opposite corners give a middle that is the same to the last bit in the mirror.
    const Vec3 middle = 0.5 * (surface.vertices[i] + surface.vertices[n + next]);
    add_around(middle, {i, next, n + next, n + i}, mesh);
  }
  return mesh;
}

}  // namespace

geometry::TriangleMesh water_surface(const geometry::Shape& shape) {
  if (shape.kind == geometry::ShapeKind::box) return box_around_middles(shape.parts.front());
  if (shape.kind == geometry::ShapeKind::cylinder) return cylinder_around_middles(shape.surface, shape.half_height);
  return shape.surface;
}

WetGeometry prepare_geometry(const geometry::Shape& shape) {
  switch (shape.kind) {
    case geometry::ShapeKind::prism:
      return PrismWater(shape);
    case geometry::ShapeKind::box:
    case geometry::ShapeKind::cylinder:
    case geometry::ShapeKind::mesh:
      return MeshWater(water_surface(shape));
    case geometry::ShapeKind::sphere:
    case geometry::ShapeKind::plane:
      break;
  }
  return {};
}

}  // namespace nilas::hydro
