/// Meshes of all forms, and a hull of one file.
#include "core/base/file_bytes.h"
#include "core/geometry/mesh.h"
#include "core/hull/hull.h"
#include "core/mesh/mend/soup_formats.h"
#include "tests/fuzz/targets.h"

namespace nilas::fuzz {

void mesh_obj(std::string_view bytes) {
  read_or_refuse([&] { mesh::parse_obj(std::string(bytes), "mesh.obj"); });
}

void mesh_off(std::string_view bytes) {
  read_or_refuse([&] { mesh::parse_off(std::string(bytes), "mesh.off"); });
}

void mesh_ply(std::string_view bytes) {
  read_or_refuse([&] { mesh::parse_ply(std::string(bytes), "mesh.ply"); });
}

void mesh_stl(std::string_view bytes) {
  const auto file = file_with("mesh.stl", bytes);
  read_or_refuse([&] { geometry::read_stl(file); });
}

void hull(std::string_view bytes) {
  const auto file = file_with("hull.stl", bytes);
  read_or_refuse([&] { hull::read_hull(file, 1); });
}

}  // namespace nilas::fuzz
