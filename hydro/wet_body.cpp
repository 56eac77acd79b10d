#include "hydro/wet_body.h"

namespace nilas::hydro {

bool takes_water(const bodies::Bodies& bodies, int b) {
  const auto i = static_cast<std::size_t>(b);
  if (bodies.shape[i]->kind == geometry::ShapeKind::plane) return false;
  if (bodies.kind[i] == bodies::BodyKind::vessel) return true;
  return bodies.is_free(b) && (bodies.kind[i] == bodies::BodyKind::floe || bodies.kind[i] == bodies::BodyKind::rigid);
}

geometry::TriangleMesh water_surface(const geometry::Shape& shape) {
  if (shape.kind != geometry::ShapeKind::box) return shape.surface;
  const geometry::ConvexPolytope& box = shape.parts.front();
  geometry::TriangleMesh mesh;
  mesh.vertices = box.vertices;
  for (const auto& face : box.faces) {
    Vec3 sum = Vec3::Zero();
    for (const int v : face) sum += box.vertices[v];
    const int middle = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(sum / static_cast<double>(face.size()));
    for (std::size_t k = 0; k < face.size(); ++k)
      mesh.triangles.push_back({middle, face[k], face[(k + 1) % face.size()]});
  }
  return mesh;
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
