/// Hull folders and single hull files.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/vessel/hull.h"

namespace nilas {

namespace fs = std::filesystem;

namespace {

/// Convex within this share of half the longest side: STL files hold float32 coordinates.
constexpr double k_convex_tolerance = 1e-5;

TriangleMesh read_sound(const fs::path& file) {
  if (!fs::exists(file)) throw FileError(file.string() + ": no such file");
  TriangleMesh mesh = read_stl(file);
  const MeshDefects defects = find_defects(mesh);
  if (!defects.sound()) throw InputError(file.string() + ": not a closed outward solid: " + defects.text());
  return mesh;
}

void demand_convex(const TriangleMesh& mesh, const fs::path& file, const std::string& advice) {
  Vec3 low = mesh.vertices.front(), high = low;
  for (const auto& p : mesh.vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  try {
    make_polytope(mesh, k_convex_tolerance * 0.5 * (high - low).maxCoeff());
  } catch (const InputError& e) {
    throw InputError(file.string() + ": " + e.what() + advice);
  }
}

/// part-NN.stl files of a folder, by name.
std::vector<fs::path> part_files(const fs::path& folder) {
  std::vector<fs::path> parts;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("part-", 0) == 0 && entry.path().extension() == ".stl") parts.push_back(entry.path());
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

/// A folder that lost a part would float right and touch wrongly; the description knows how many there were.
void demand_described_parts(const fs::path& description, std::size_t parts) {
  if (!fs::exists(description)) return;
  std::ifstream in(description);
  if (!in) throw FileError(description.string() + ": cannot be read");
  const nlohmann::json json = nlohmann::json::parse(in, nullptr, false);
  if (!json.is_object()) throw InputError(description.string() + ": not a JSON object, or cut short");
  if (!json.contains("parts")) return;
  if (json["parts"] != parts)
    throw InputError(fmt::format("{}: parts: found {}, but the folder holds {} part-NN.stl files", description.string(),
                                 json["parts"].dump(), parts));
}

}  // namespace

Hull read_hull(const fs::path& path) {
  Hull hull;
  if (!fs::exists(path)) throw FileError(path.string() + ": no such hull folder or file");
  if (!fs::is_directory(path)) {
    hull.fluid = read_sound(path);
    demand_convex(hull.fluid, path, "; `nilas hull` cuts such a file into a hull folder with convex parts");
    hull.parts.push_back(hull.fluid);
    return hull;
  }
  hull.fluid = read_sound(path / "fluid.stl");
  const std::vector<fs::path> parts = part_files(path);
  if (parts.empty()) throw InputError(path.string() + ": the hull folder holds no part-NN.stl");
  demand_described_parts(path / "hull.json", parts.size());
  for (const auto& file : parts) {
    hull.parts.push_back(read_sound(file));
    demand_convex(hull.parts.back(), file, "");
  }
  return hull;
}

void write_hull(const Hull& hull, const fs::path& folder, const std::string& json) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw FileError(folder.string() + ": cannot be created: " + error.message());
  // parts of an earlier hull must not be taken for parts of this one
  for (const auto& file : part_files(folder)) fs::remove(file, error);
  write_stl(hull.fluid, folder / "fluid.stl");
  for (std::size_t k = 0; k < hull.parts.size(); ++k)
    write_stl(hull.parts[k], folder / fmt::format("part-{:02}.stl", k + 1));
  std::ofstream out(folder / "hull.json");
  out << json;
  out.close();
  if (!out) throw FileError((folder / "hull.json").string() + ": cannot be written");
}

}  // namespace nilas
