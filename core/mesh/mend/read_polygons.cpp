#include <algorithm>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/geometry/mesh.h"
#include "core/mesh/mend/soup_formats.h"

namespace nilas::mesh {

namespace {

PolygonSoup from_triangles(const geometry::TriangleMesh& mesh) {
  PolygonSoup soup{mesh.vertices, {}};
  for (const auto& t : mesh.triangles) soup.polygons.push_back({t[0], t[1], t[2]});
  return soup;
}

}  // namespace

PolygonSoup read_polygons(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (ending == ".stl") return from_triangles(geometry::read_stl(file));
  if (ending != ".obj" && ending != ".off" && ending != ".ply")
    throw InputError(file.string() + ": found the ending '" + ending + "'; allowed: .stl, .obj, .off, .ply");
  const std::string bytes = file_bytes(file);
  PolygonSoup soup = ending == ".obj"   ? parse_obj(bytes, file.string())
                     : ending == ".off" ? parse_off(bytes, file.string())
                                        : parse_ply(bytes, file.string());
  if (soup.polygons.empty()) throw InputError(file.string() + ": holds no polygons");
  return soup;
}

}  // namespace nilas::mesh
