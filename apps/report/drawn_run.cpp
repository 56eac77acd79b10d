#include "apps/report/drawn_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/report/floe_outlines.h"
#include "core/base/csv.h"
#include "core/base/error.h"
#include "core/output/loads/ice_load_text.h"
#include "core/output/tables/contact_rows.h"

namespace nilas::report {

namespace {

/// The bodies to draw, by index: either the vessel alone or structures.
struct Choice {
  std::vector<std::size_t> bodies;
  bool is_vessel = false;
};

Choice choose(const std::string& run, const sim::Simulation& simulation, const std::string& name) {
  const bodies::Bodies& bodies = simulation.bodies();
  const output::LoadedBodies loaded = output::loaded_bodies(bodies, simulation.info());
  std::vector<std::size_t> candidates;
  if (loaded.vessel >= 0) candidates.push_back(static_cast<std::size_t>(loaded.vessel));
  for (const std::int64_t id : loaded.structures) candidates.push_back(bodies.index_of(id));
  if (candidates.empty())
    throw InputError(run +
                     ": there is nothing to draw contacts on, because the scene has neither a vessel nor a body with "
                     "fixed=\"true\"");
  Choice choice;
  std::string names;
  for (const std::size_t b : candidates) {
    names += (names.empty() ? "" : ", ") + bodies.name[b];
    const bool is_vessel = static_cast<int>(b) == loaded.vessel;
    if (name.empty() ? is_vessel || loaded.vessel < 0 : bodies.name[b] == name) {
      choice.bodies.push_back(b);
      choice.is_vessel = is_vessel;
    }
  }
  if (choice.bodies.empty()) throw InputError(run + ": --body: found '" + name + "'; allowed: " + names);
  return choice;
}

/// The surface of a body: a hull's in V, although its body has the centre of mass as origin, a structure's in G.
geometry::TriangleMesh mesh_of(const sim::Simulation& simulation, std::size_t b, bool is_vessel) {
  const bodies::Bodies& bodies = simulation.bodies();
  geometry::TriangleMesh mesh = bodies.shape[b]->surface;
  for (Vec3& p : mesh.vertices)
    p = is_vessel ? Vec3(p + simulation.info().vessel_mass.com) : Vec3(bodies.p_GB[b] + bodies.R_GB[b] * p);
  return mesh;
}

/// The columns of vessel.csv that drawings need.
class VesselRows {
 public:
  explicit VesselRows(const std::filesystem::path& file)
      : columns_(csv_columns(file, {"time_s", "x_m", "y_m", "z_m", "yaw_deg", "pitch_deg", "roll_deg",
                                    "ice_resistance_N", "ice_side_N", "contact_fz_N"})) {}

  /// The pose of the centre of mass in the row nearest to t [s]; the identity without rows.
  Pose pose_near(double t) const {
    const auto& time = columns_[0];
    if (time.empty()) return {};
    std::size_t k = 0;
    for (std::size_t i = 0; i < time.size(); ++i)
      if (std::abs(time[i] - t) < std::abs(time[k] - t)) k = i;
    Pose pose;
    pose.p = Vec3(columns_[1][k], columns_[2][k], columns_[3][k]);
    pose.q = Quat(Eigen::AngleAxisd(columns_[4][k] * k_deg, Vec3::UnitZ()) *
                  Eigen::AngleAxisd(columns_[5][k] * k_deg, Vec3::UnitY()) *
                  Eigen::AngleAxisd(columns_[6][k] * k_deg, Vec3::UnitX()));
    return pose;
  }

  /// The mean load astern, to port and up over the rows from `low` to `high` [s], in newton.
  Vec3 mean_load(double low, double high) const {
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (std::size_t k = 0; k < columns_[0].size(); ++k) {
      if (columns_[0][k] < low || columns_[0][k] > high) continue;
      sum += Vec3(columns_[7][k], columns_[8][k], columns_[9][k]);
      ++count;
    }
    return count > 0 ? Vec3(sum / count) : sum;
  }

 private:
  std::vector<std::vector<double>> columns_;
};

/// A component of a load as text. It is given as 0 where it is negligible, because rounding leaves such values.
std::string part_text(double part, const Vec3& load, const output::LoadSides& sides) {
  constexpr double k_nothing = 1e-4;
  return output::sided_force(std::abs(part) < k_nothing * load.norm() ? 0 : part, sides);
}

std::string vessel_loads(const VesselRows& rows, const ContactWindow& window, double step) {
  const double reach = window.half_width + 0.5 * step;
  const Vec3 load = rows.mean_load(window.t - reach, window.t + reach);
  return fmt::format("mean load {}, {}, {}", part_text(load.x(), load, output::k_astern),
                     part_text(load.y(), load, output::k_to_port), part_text(load.z(), load, output::k_upward));
}

std::string structure_loads(const Vec2& course, const Vec3& force) {
  const Vec2 horizontal = force.head<2>();
  return fmt::format("mean load {}, {}, {}", part_text(-horizontal.dot(course), force, {"along"}),
                     part_text(horizontal.dot(sim::to_port(course)), force, {"across the drift"}),
                     part_text(force.z(), force, output::k_upward));
}

}  // namespace

ContactPictureInput contact_picture(const std::filesystem::path& run_folder, const scene::Scene& scene,
                                    const sim::Simulation& simulation, const std::string& body,
                                    const std::vector<double>& times, double half_width,
                                    std::vector<std::string>& notes) {
  const Choice choice = choose(run_folder.string(), simulation, body);
  if (scene.output.contacts == StoredContacts::none)
    throw InputError(run_folder.string() +
                     ": the run stored no contacts; set <output contacts=\"hull\"> and run it "
                     "again");
  const sim::RunInfo& info = simulation.info();
  const Vec3& com_V = info.vessel_mass.com;
  ContactPictureInput picture;
  DrawnBodies drawn{.ids = {}, .is_vessel = choice.is_vessel};
  std::string names;
  for (const std::size_t b : choice.bodies) {
    drawn.ids.push_back(simulation.bodies().id[b]);
    picture.bodies.push_back(mesh_of(simulation, b, choice.is_vessel));
    names += (names.empty() ? "" : ", ") + simulation.bodies().name[b];
  }
  picture.title = "Contacts on " + names + ", scene " + scene.name;
  picture.water_level = scene.water ? scene.water->level : 0;
  std::optional<VesselRows> vessel;
  if (choice.is_vessel) vessel.emplace(run_folder / "vessel.csv");

  const auto windows = contact_windows(run_folder / "contacts.h5", drawn, scene.time, times, half_width);
  bool has_ice = true;
  for (const ContactWindow& window : windows) {
    PictureRow row{.window = window, .loads = {}, .floes = {}};
    row.loads =
        vessel ? vessel_loads(*vessel, window, scene.time.step) : structure_loads(info.drift_course, window.mean_force);
    if (auto ice = ice_near(run_folder, window.t)) {
      row.floes = std::move(ice->outlines);
      if (vessel) {
        const Pose hull = vessel->pose_near(ice->t);
        for (auto& outline : row.floes)
          for (Vec3& p : outline) p = hull.q.inverse() * (p - hull.p) + com_V;
      }
    } else {
      has_ice = false;
    }
    picture.rows.push_back(std::move(row));
  }
  if (scene.ice && !has_ice)
    notes.emplace_back("The ice is not drawn, since the run stored none: set <output trajectory_every>.");
  picture.views = choice.is_vessel ? hull_views() : structure_views(info.drift_course);
  picture.frame = choice.is_vessel ? hull_frame(picture.bodies.front(), windows)
                                   : structure_frame(picture.bodies, windows, picture.water_level);
  if (!picture.frame.left_out.empty()) notes.push_back(picture.frame.left_out);
  return picture;
}

}  // namespace nilas::report
