#include "core/output/trajectory.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace nilas {

namespace {

constexpr const char* k_list_head =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
    "byte_order=\"LittleEndian\">\n<Collection>\n";
constexpr const char* k_list_tail = "</Collection>\n</VTKFile>\n";

}  // namespace

Trajectory::Trajectory(const std::filesystem::path& run_folder, std::optional<std::int64_t> keep)
    : folder_(run_folder / "trajectory"), list_(run_folder / "trajectory.pvd", k_list_tail, keep) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw FileError(folder_.string() + ": cannot create the folder: " + error.message());
  if (!keep) list_.append(k_list_head);
}

void Trajectory::frame(double t, long step, const Bodies& bodies) {
  follow_shapes(bodies);
  frame_.clear();
  for (std::size_t b = 0; b < surfaces_.size(); ++b) frame_.add(bodies, b, surfaces_[b]);
  const std::string name = fmt::format("step-{:06d}.vtp", step);
  write_whole(folder_ / name, frame_.document());
  list_.append(fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"trajectory/{}\"/>\n", t, name));
}

void Trajectory::follow_shapes(const Bodies& bodies) {
  shapes_.resize(bodies.shape.size());
  surfaces_.resize(bodies.shape.size());
  for (std::size_t b = 0; b < bodies.shape.size(); ++b) {
    if (shapes_[b] == bodies.shape[b]) continue;
    shapes_[b] = bodies.shape[b];
    surfaces_[b] = polygon_surface(*bodies.shape[b]);
  }
}

}  // namespace nilas
