#pragma once
/// The outer faces of a body that ice crushes against, or of a floe.
#include <cstdint>
#include <optional>
#include <vector>

#include "core/bodies/bodies.h"
#include "fracture/crush/contact_area.h"

namespace nilas {

/// In the frame of the body. Faces, and parts of faces, inside or against other parts of the body are left out.
struct CrushingSurface {
  int body = -1;
  std::int64_t id = 0;
  std::vector<HullFace> faces;
  std::vector<ConvexPolytope> parts;
  std::vector<std::vector<char>> outer;  ///< per face of each part: whether the surface has pieces of it
};

/// Whether a shape has flat faces, or is a cylinder, which has its facets; spheres and planes have none.
bool has_crushing_surface(const Shape& shape);
/// Of a body whose shape has one.
std::optional<CrushingSurface> crushing_surface(const Bodies& bodies, int body);

}  // namespace nilas
