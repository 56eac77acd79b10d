/// Cost of `nilas hull` and deviation of its convex pieces for five shapes as drawing programs export them. The stages
/// are timed one by one, with the default settings of the command.
/// usage: bench_hull FOLDER THREADS [SHAPE ...]     meshes and hull folders go into FOLDER; without SHAPE all
/// The exit code is 1 where a mesh of 18 000 triangles takes over a minute, or pieces deviate more than recorded here.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "apps/nilas/reports/hull_picture.h"
#include "apps/nilas/reports/prepare_hull.h"
#include "core/mesh/decompose/surface_distance.h"
#include "tests/core/mesh/hull_shapes.h"

namespace {

using namespace nilas;

constexpr double k_most_seconds = 60;   // Upper limit of the time of all stages together [s].
constexpr std::size_t k_timed = 18000;  // Number of triangles of a mesh for which the limit holds.
constexpr double k_mm = 1e-3;

/// A shape and the deviation of its convex pieces in docs/evidence/validation-contacts.md, rounded up.
struct Shape {
  const char* name;
  std::vector<geometry::TriangleMesh> shells;
  double deviation;  ///< Largest deviation of the pieces from the mesh [m].
};

std::vector<Shape> shapes() {
  return {
      {"wedge", {mesh::wedge_mesh()}, 0.01 * k_mm},
      {"cone", {mesh::cone_mesh(1, 1.5, 24)}, 0.01 * k_mm},
      {"moon-pool", {mesh::moonpool_mesh()}, 0.02 * k_mm},
      {"semi-submersible", mesh::semisubmersible_shells(64), 0.01 * k_mm},
      {"ship-with-bulb", {mesh::ship_mesh(120, 36), mesh::bulb_mesh({5.9, 0, 0.12}, {0.5, 0.09, 0.1}, 16)}, 5.7 * k_mm},
  };
}

/// Seconds of each stage, in the order of execution.
class Stages {
 public:
  void done(const char* name) {
    const auto now = std::chrono::steady_clock::now();
    seconds_.emplace_back(name, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }
  double total() const {
    double sum = 0;
    for (const auto& [name, seconds] : seconds_) sum += seconds;
    return sum;
  }
  std::string text() const {
    std::string line;
    for (const auto& [name, seconds] : seconds_) line += fmt::format("{} {:.1f}, ", name, seconds);
    return line + fmt::format("all {:.1f}", total());
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::vector<std::pair<const char*, double>> seconds_;
};

/// Writes the shells into one file, as a drawing program exports them, and returns its path.
std::filesystem::path written(const Shape& shape, const std::filesystem::path& folder) {
  mesh::SolidBuilder all;
  for (const auto& shell : shape.shells)
    for (const auto& c : mesh::corners_of(shell)) all.triangle(c[0], c[1], c[2]);
  const std::filesystem::path file = folder / (std::string(shape.name) + ".stl");
  geometry::write_stl(all.take(), file);
  return file;
}

/// Prints a row. False where the shape takes too long or its pieces deviate more than recorded.
bool measure(const Shape& shape, const std::filesystem::path& folder, int threads) {
  const auto file = written(shape, folder);
  hull::NewHullFolder out(folder / shape.name, true);
  Stages stages;
  commands::HullPreparation how;
  how.threads = threads;
  how.stage_done = [&](const char* stage) { stages.done(stage); };
  const commands::PreparedHull made = commands::prepare_hull(file, how, out);
  const auto report = commands::hull_report(made);
  stages.done("report");
  commands::draw_hull(made.hull, commands::waterline_level(made.hull.fluid, made.draught), out.staging());
  stages.done("pictures");
  const std::size_t triangles = made.hull.fluid.triangles.size();
  const double deviation = made.deviation->largest;
  const bool quick = triangles < k_timed || stages.total() <= k_most_seconds, close = deviation <= shape.deviation;
  fmt::print("| {} | {} | {} | {:.3f} | {:.3f} | {} |{}{}\n", shape.name, triangles, made.hull.parts.size(),
             deviation / k_mm, *made.tolerance / k_mm, stages.text(), quick ? "" : " TOO SLOW",
             close ? "" : fmt::format(" RECORDED: {} mm", shape.deviation / k_mm));
  std::fflush(stdout);
  return quick && close;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: bench_hull FOLDER THREADS [SHAPE ...]\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const std::vector<std::string> asked(argv + 3, argv + argc);
  std::filesystem::create_directories(folder);
  fmt::print("| shape | triangles | parts | deviation [mm] | tolerance [mm] | time [s] |\n|---|---|---|---|---|---|\n");
  bool good = true;
  for (const auto& shape : shapes())
    if (asked.empty() || std::find(asked.begin(), asked.end(), shape.name) != asked.end())
      good = measure(shape, folder, std::atoi(argv[2])) && good;
  return good ? 0 : 1;
}
