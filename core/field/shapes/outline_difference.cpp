/// Includes CGAL, whose kernels need directed rounding: see core/CMakeLists.txt.
#include "core/field/shapes/outline_difference.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/geometry/mass_properties.h"

namespace nilas::field {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;

Polygon polygon_of(const std::vector<Vec2>& outline) {
  Polygon polygon;
  for (const Vec2& p : outline) polygon.push_back({p.x(), p.y()});
  return polygon;
}

/// The outline with coordinates rounded to doubles; corners that coincide after rounding become one.
std::vector<Vec2> outline_of(const Polygon& polygon) {
  std::vector<Vec2> outline;
  for (auto v = polygon.vertices_begin(); v != polygon.vertices_end(); ++v) {
    const Vec2 corner(CGAL::to_double(v->x()), CGAL::to_double(v->y()));
    if (outline.empty() || outline.back() != corner) outline.push_back(corner);
  }
  while (outline.size() > 1 && outline.front() == outline.back()) outline.pop_back();
  return outline;
}

}  // namespace

std::vector<std::vector<Vec2>> outline_difference(const std::vector<Vec2>& outline,
                                                  const std::vector<std::vector<Vec2>>& holes) {
  CGAL::Polygon_set_2<Kernel> left(polygon_of(outline));
  for (const auto& hole : holes) left.difference(polygon_of(hole));
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> parts;
  left.polygons_with_holes(std::back_inserter(parts));
  std::vector<std::vector<Vec2>> pieces;
  for (const auto& part : parts) {
    if (part.has_holes()) throw InputError("ice field: a sheet would surround a keep-out outline; move the region");
    std::vector<Vec2> piece = outline_of(part.outer_boundary());
    if (piece.size() >= 3) pieces.push_back(std::move(piece));
  }
  const auto larger = [](const auto& a, const auto& b) {
    return geometry::polygon_moments(a).area > geometry::polygon_moments(b).area;
  };
  std::stable_sort(pieces.begin(), pieces.end(), larger);
  return pieces;
}

}  // namespace nilas::field
