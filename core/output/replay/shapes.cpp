#include "core/output/replay/shapes.h"

#include "core/output/replay/byte_text.h"
#include "core/output/vtk/body_surface.h"

namespace nilas::output::replay {

namespace {

enum ShapeType { floe = 0, fluid = 1, collision = 2 };

void add_shape(std::uint64_t number, ShapeType type, std::uint64_t owner, const PolygonSurface& surface,
               std::string& content) {
  add_varint(number, content);
  add_byte(type, content);
  add_varint(owner, content);
  add_varint(surface.points.size(), content);
  for (const Vec3& x : surface.points)
    for (int k = 0; k < 3; ++k) add_float(x[k], content);
  add_varint(surface.ends.size(), content);
  std::int32_t begin = 0;
  for (const std::int32_t end : surface.ends)
    add_varint(static_cast<std::uint64_t>(end - std::exchange(begin, end)), content);
  for (const std::int32_t corner : surface.corners) add_varint(static_cast<std::uint64_t>(corner), content);
}

PolygonSurface surface_of(const geometry::ConvexPolytope& part) {
  PolygonSurface surface;
  surface.points = part.vertices;
  for (const auto& face : part.faces) surface.add_polygon({face.begin(), face.end()});
  return surface;
}

}  // namespace

std::uint64_t Shapes::number_of(const std::shared_ptr<const geometry::Shape>& shape, bool is_floe,
                                std::string& content) {
  if (shape->kind == geometry::ShapeKind::plane) return 0;
  const auto [place, is_new] = numbers_.try_emplace(shape, next_);
  if (!is_new) return place->second + 1;
  const std::uint64_t number = next_++;
  add_shape(number, is_floe ? floe : fluid, number, polygon_surface(*shape), content);
  if (!is_floe)
    for (const auto& part : shape->parts) add_shape(next_++, collision, number, surface_of(part), content);
  return number + 1;
}

void Shapes::forget_unused() {
  std::erase_if(numbers_, [](const auto& entry) { return entry.first.use_count() == 1; });
}

}  // namespace nilas::output::replay
