#pragma once
/// Bodies as polygons, for pictures.
#include <cstdint>
#include <vector>

#include "core/geometry/shape.h"

namespace nilas::output {

/// Polygons in a body frame: polygon k has the corners corners[ends[k-1]] .. corners[ends[k] - 1], counter-clockwise
/// from outside.
struct PolygonSurface {
  std::vector<Vec3> points;           ///< [m]
  std::vector<std::int32_t> corners;  ///< indices into points
  std::vector<std::int32_t> ends;

  void add_polygon(const std::vector<std::int32_t>& loop);
};

/// The surface of a shape. Prism: bottom, top and one quadrilateral per side. Sphere: a grid of parallels and
/// meridians. Plane: empty. Others: their triangles.
PolygonSurface polygon_surface(const geometry::Shape& shape);

}  // namespace nilas::output
