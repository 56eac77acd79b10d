#include "fracture/model/crushing_surface.h"

#include "contact/detect/broad/part.h"
#include "fracture/crush/ice_columns.h"

namespace nilas::fracture {

namespace {

/// The facets of a cylinder are flat within this share of its radius [-].
constexpr double k_facet_tolerance = 1e-9;

}  // namespace

bool has_crushing_surface(const geometry::Shape& shape) {
  return shape.kind == geometry::ShapeKind::cylinder || !shape.parts.empty();
}

std::optional<CrushingSurface> crushing_surface(const bodies::Bodies& bodies, int body) {
  const auto b = static_cast<std::size_t>(body);
  const geometry::Shape& shape = *bodies.shape[b];
  if (!has_crushing_surface(shape)) return std::nullopt;
  CrushingSurface surface;
  surface.body = body;
  surface.id = bodies.id[b];
  if (shape.kind == geometry::ShapeKind::cylinder) {
    surface.parts.push_back(geometry::make_polytope(shape.surface, k_facet_tolerance * shape.radius));
    for (const auto& face : surface.parts.front().faces) {
      std::vector<Vec3> loop;
      for (const int v : face) loop.push_back(surface.parts.front().vertices[v]);
      surface.faces.push_back(make_hull_face(0, std::move(loop)));
    }
    surface.outer = outer_faces(surface.parts, surface.faces);
    return surface;
  }
  surface.parts = shape.parts;
  for (const detect::Part& part : detect::make_parts(bodies, body))
    for (std::size_t f = 0; f < part.facets->polytope->faces.size(); ++f)
      for (auto& loop : detect::shown_pieces(part, f))
        surface.faces.push_back(make_hull_face(part.index, std::move(loop)));
  surface.outer = outer_faces(surface.parts, surface.faces);
  return surface;
}

}  // namespace nilas::fracture
