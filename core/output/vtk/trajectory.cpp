#include "core/output/vtk/trajectory.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/output/vtk/vtp_document.h"
#include "core/output/vtk/vtp_forces.h"

namespace nilas::output {

namespace {

constexpr const char* k_list_head =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
    "byte_order=\"LittleEndian\">\n<Collection>\n";
constexpr const char* k_list_tail = "</Collection>\n</VTKFile>\n";
constexpr const char *k_water = "water.vtp", *k_walls = "walls.vtp";

/// Horizontal box around everything but planes; empty where there is nothing.
Eigen::AlignedBox2d plan_box(const bodies::Bodies& bodies, const std::vector<PolygonSurface>& surfaces) {
  Eigen::AlignedBox2d box;
  for (std::size_t b = 0; b < surfaces.size(); ++b)
    for (const Vec3& x : surfaces[b].points) box.extend((bodies.p_GB[b] + bodies.R_GB[b] * x).head<2>());
  return box;
}

}  // namespace

Trajectory::Trajectory(const std::filesystem::path& run_folder, const scene::Scene& scene, bool has_forces,
                       std::optional<std::int64_t> keep)
    : folder_(run_folder / "trajectory"),
      has_forces_(has_forces),
      has_walls_(scene.tank && scene.output.tank_walls),
      has_damage_(scene.fracture && scene.fracture->damage),
      water_level_(scene.water ? std::optional(scene.water->level) : std::nullopt),
      tank_(scene.tank),
      unflushed_(scene.contact.integrator != Integrator::reference),
      list_(run_folder / "trajectory.pvd", k_list_tail, keep) {
  if (scene.ice) moving_.push_back({"ice floes", "ice", bodies::BodyKind::floe});
  if (scene.vessel) moving_.push_back({"vessel", "vessel", bodies::BodyKind::vessel});
  if (!scene.bodies.empty()) moving_.push_back({"bodies", "bodies", bodies::BodyKind::rigid});
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw FileError(folder_.string() + ": cannot create the folder: " + error.message());
  if (!keep) list_.append(k_list_head);
}

void Trajectory::frame(double t, long step, const bodies::Bodies& bodies, const ShownStep& shown) {
  follow_shapes(bodies);
  if (step == 0) write_what_stays(bodies);
  std::string entries;
  int part = 0;
  const auto list = [&](const char* name, const std::string& file) {
    entries += fmt::format("<DataSet timestep=\"{}\" part=\"{}\" name=\"{}\" file=\"trajectory/{}\"/>\n", t, part++,
                           name, file);
  };
  for (const Part& moving : moving_) {
    const std::string file = fmt::format("step-{:06d}-{}.vtp", step, moving.stem);
    write(file, surfaces_of(moving.kind, bodies, shown.damage));
    list(moving.name, file);
  }
  if (has_forces_) {
    const std::string file = fmt::format("step-{:06d}-forces.vtp", step);
    write(file, contact_forces_document(shown.contacts, shown.h));
    list("contact forces", file);
  }
  if (water_level_) list("water surface", k_water);
  if (has_walls_) list("tank walls", k_walls);
  list_.append(entries);
}

void Trajectory::write(const std::string& name, const std::string& document) {
  write_whole(folder_ / name, document);
  unflushed_.add(folder_ / name);
}

const std::string& Trajectory::surfaces_of(bodies::BodyKind kind, const bodies::Bodies& bodies,
                                           const FloeDamage& damage) {
  const bool with_damage = has_damage_ && kind == bodies::BodyKind::floe;
  frame_.clear(with_damage);
  for (std::size_t b = 0; b < surfaces_.size(); ++b)
    if (bodies.kind[b] == kind && !surfaces_[b].ends.empty())
      frame_.add(bodies, b, surfaces_[b], with_damage && damage ? damage(bodies.id[b]) : 0);
  return frame_.document();
}

void Trajectory::write_what_stays(const bodies::Bodies& bodies) {
  if (water_level_) write(k_water, water_document(bodies));
  if (has_walls_) write(k_walls, surfaces_of(bodies::BodyKind::wall, bodies, {}));
}

/// The water surface over the tank, else around the bodies at the start.
std::string Trajectory::water_document(const bodies::Bodies& bodies) const {
  const double level = water_level_.value();
  if (tank_) return rectangle_document(0, -0.5 * tank_->width, tank_->length, 0.5 * tank_->width, level);
  constexpr double k_margin = 0.1;  // share of the larger side
  const Eigen::AlignedBox2d box = plan_box(bodies, surfaces_);
  if (box.isEmpty()) return rectangle_document(0, 0, 0, 0, level);
  const Vec2 margin = Vec2::Constant(k_margin * box.sizes().maxCoeff());
  const Vec2 low = box.min() - margin, high = box.max() + margin;
  return rectangle_document(low.x(), low.y(), high.x(), high.y(), level);
}

void Trajectory::follow_shapes(const bodies::Bodies& bodies) {
  shapes_.resize(bodies.shape.size());
  surfaces_.resize(bodies.shape.size());
  for (std::size_t b = 0; b < bodies.shape.size(); ++b) {
    if (shapes_[b] == bodies.shape[b]) continue;
    shapes_[b] = bodies.shape[b];
    surfaces_[b] = polygon_surface(*bodies.shape[b]);
  }
}

}  // namespace nilas::output
