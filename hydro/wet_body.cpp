#include "hydro/wet_body.h"

namespace nilas::hydro {

bool takes_water(const bodies::Bodies& bodies, int b) {
  const auto i = static_cast<std::size_t>(b);
  if (bodies.shape[i]->kind == geometry::ShapeKind::plane) return false;
  if (bodies.kind[i] == bodies::BodyKind::vessel) return true;
  return bodies.is_free(b) && (bodies.kind[i] == bodies::BodyKind::floe || bodies.kind[i] == bodies::BodyKind::rigid);
}

WetGeometry prepare_geometry(const geometry::Shape& shape) {
  switch (shape.kind) {
    case geometry::ShapeKind::prism:
      return PrismWater(shape);
    case geometry::ShapeKind::box:
    case geometry::ShapeKind::cylinder:
    case geometry::ShapeKind::mesh:
      return MeshWater(shape.surface);
    case geometry::ShapeKind::sphere:
    case geometry::ShapeKind::plane:
      break;
  }
  return {};
}

}  // namespace nilas::hydro
