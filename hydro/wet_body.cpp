#include "hydro/wet_body.h"

namespace nilas {

bool takes_water(const Bodies& bodies, int b) {
  const auto i = static_cast<std::size_t>(b);
  if (bodies.shape[i]->kind == ShapeKind::plane) return false;
  if (bodies.kind[i] == BodyKind::vessel) return true;
  return bodies.is_free(b) && (bodies.kind[i] == BodyKind::floe || bodies.kind[i] == BodyKind::rigid);
}

WetGeometry prepare_geometry(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::prism:
      return PrismWater(shape);
    case ShapeKind::box:
    case ShapeKind::cylinder:
    case ShapeKind::mesh:
      return MeshWater(shape.surface);
    case ShapeKind::sphere:
    case ShapeKind::plane:
      break;
  }
  return {};
}

}  // namespace nilas
