/// Hull folders and single hull files.
#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/base/json_text.h"
#include "core/geometry/mesh_box.h"
#include "core/hull/hull.h"
#include "core/hull/hull_parts.h"

namespace nilas::hull {

namespace fs = std::filesystem;

namespace {

/// Tolerance of convexity as a share of half the longest side: STL files hold float32 coordinates.
constexpr double k_convex_tolerance = 1e-5;

geometry::TriangleMesh read_sound(const fs::path& file) {
  geometry::TriangleMesh mesh = geometry::read_stl(file);
  const geometry::MeshDefects defects = geometry::find_defects(mesh);
  if (!defects.sound()) throw InputError(file.string() + ": not a closed outward solid: " + defects.text());
  return mesh;
}

void demand_convex(const geometry::TriangleMesh& mesh, const fs::path& file, const std::string& advice) {
  try {
    geometry::make_polytope(mesh, k_convex_tolerance * 0.5 * geometry::box_of(mesh).sizes().maxCoeff());
  } catch (const InputError& e) {
    throw InputError(file.string() + ": " + e.what() + advice);
  }
}

/// Throws where parts are missing: such a hull would float correctly but have wrong contacts. The description states
/// their number.
void demand_described_parts(const fs::path& description, std::size_t parts) {
  std::error_code ignored;
  if (!fs::exists(description, ignored)) return;
  const nlohmann::json json = nlohmann::json::parse(json_file_text(description), nullptr, false);
  if (!json.is_object()) throw InputError(description.string() + ": not a JSON object, or cut short");
  if (!json.contains("parts")) return;
  if (json["parts"] != parts)
    throw InputError(fmt::format("{}: parts: found {}, but the folder holds {} part-NNNN.stl files",
                                 description.string(), json["parts"].dump(), parts));
}

Hull as_stored(const fs::path& path) {
  Hull hull;
  if (!is_folder(path)) {
    hull.fluid = read_sound(path);
    demand_convex(hull.fluid, path, "; `nilas hull` cuts such a file into a hull folder with convex parts");
    hull.parts.push_back(hull.fluid);
    return hull;
  }
  hull.fluid = read_sound(path / "fluid.stl");
  const std::vector<fs::path> parts = part_files(path);
  if (parts.empty()) throw InputError(path.string() + ": the hull folder holds no part-NNNN.stl");
  demand_described_parts(path / "hull.json", parts.size());
  for (const auto& file : parts) {
    hull.parts.push_back(read_sound(file));
    demand_convex(hull.parts.back(), file, "");
  }
  return hull;
}

}  // namespace

Hull read_hull(const fs::path& path, double scale) {
  NILAS_DEMAND(scale > 0);
  Hull hull = as_stored(path);
  for (Vec3& p : hull.fluid.vertices) p *= scale;
  for (geometry::TriangleMesh& part : hull.parts)
    for (Vec3& p : part.vertices) p *= scale;
  return hull;
}

void write_hull(const Hull& hull, const fs::path& folder, const std::string& json) {
  geometry::write_stl(hull.fluid, folder / "fluid.stl");
  for (std::size_t k = 0; k < hull.parts.size(); ++k) geometry::write_stl(hull.parts[k], folder / part_name(k + 1));
  std::ofstream out(folder / "hull.json");
  out << json;
  out.close();
  if (!out) throw FileError((folder / "hull.json").string() + ": cannot be written");
}

}  // namespace nilas::hull
