#pragma once
/// The outer faces of a floe, or of a body that crushes ice.
#include <cstdint>
#include <optional>
#include <vector>

#include "core/bodies/bodies.h"
#include "fracture/crush/contact_area.h"

namespace nilas::fracture {

/// The surface in the frame of the body. Faces, and pieces of faces, inside or against other parts are left out.
struct CrushingSurface {
  int body = -1;
  std::int64_t id = 0;
  std::vector<HullFace> faces;
  std::vector<geometry::ConvexPolytope> parts;
  std::vector<std::vector<char>> outer;  ///< A flag per face of each part: the surface has pieces of it.
};

/// Whether a shape has flat faces, or the facets of a cylinder. Spheres and planes have none.
bool has_crushing_surface(const geometry::Shape& shape);
/// The surface of a body, or nothing where its shape has none.
std::optional<CrushingSurface> crushing_surface(const bodies::Bodies& bodies, int body);

}  // namespace nilas::fracture
