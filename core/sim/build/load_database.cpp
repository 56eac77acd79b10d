#include "core/sim/build/load_database.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.h"
#include "hydro/database/read_database.h"
#include "hydro/database/scaled_database.h"
#include "hydro/database/self_check.h"
#include "hydro/wetted.h"

namespace nilas::sim {

namespace {

/// The settings of the file as it was computed. Its lengths in the scene are those of the scaled vessel.
hydro::DatabaseSettings settings_of(const scene::DatabaseScene& given, double scale) {
  hydro::DatabaseSettings settings;
  if (given.length) settings.length = *given.length / scale;
  settings.density = given.density;
  settings.gravity = given.gravity;
  if (given.depth) settings.depth = *given.depth / scale;
  if (given.reference) settings.reference = *given.reference / scale;
  return settings;
}

/// Frame D in V: level with the still water at the start where the scene does not place it.
Pose frame_of(const scene::DatabaseScene& given, const WorldParts& parts) {
  Pose frame;
  frame.q = Quat(Eigen::AngleAxisd(given.rotation_deg * k_deg, Vec3::UnitZ()));
  if (given.origin) {
    frame.p = *given.origin;
    return frame;
  }
  const auto hull = static_cast<std::size_t>(parts.vessel_index);
  const Mat3& R = parts.bodies.R_GB[hull];
  const Vec3 origin_V = parts.bodies.p_GB[hull] - R * parts.info.vessel_mass.com;
  const double level = parts.water ? parts.water->level : 0;
  frame.p = Vec3(0, 0, (level - origin_V.z()) / R(2, 2));
  return frame;
}

double displaced_volume(const WorldParts& parts) {
  const auto hull = static_cast<std::size_t>(parts.vessel_index);
  return hydro::submerged_mesh(parts.bodies.shape[hull]->surface, parts.bodies.R_GB[hull], parts.bodies.p_GB[hull],
                               parts.water->level)
      .volume;
}

/// Doubts whether the database is that of this hull in this water.
void compare(const scene::Scene& scene, const WorldParts& parts, VesselDatabase& database) {
  if (!parts.water) return;
  constexpr double k_volume = 0.05, k_density = 0.02;  // shares beyond which the two hardly mean the same
  const hydro::Database& values = *database.values;
  const double density = parts.water->density, off = values.density / density - 1;
  if (std::abs(off) > k_density)
    database.doubts.push_back(
        fmt::format("The database was computed for a density of {:g} kg/m^3, but the water of the scene has {:g} "
                    "kg/m^3. Its loads are those of its own density{}.",
                    values.density, density,
                    scene.hydro->restoring ? ", but its hydrostatics are those of the scene's water" : ""));
  if (parts.water->gravity > 0 && std::abs(values.gravity / parts.water->gravity - 1) > k_density)
    database.doubts.push_back(
        fmt::format("The database was computed for a gravity of {:g} m/s^2, but the scene has "
                    "{:g} m/s^2.",
                    values.gravity, parts.water->gravity));
  if (!values.volume || !scene.hydro->buoyancy) return;
  const double hull = displaced_volume(parts);
  if (std::abs(*values.volume - hull) > k_volume * hull)
    database.doubts.push_back(
        fmt::format("The database is that of a body that displaces {:.5g} m^3, but the hull displaces {:.5g} m^3 when "
                    "the run starts, {:.3g} times as much.",
                    *values.volume, hull, hull / *values.volume));
}

}  // namespace

VesselDatabase load_database(const scene::Scene& scene, const WorldParts& parts) {
  NILAS_DEMAND(scene.hydro && scene.hydro->database && parts.vessel_index >= 0);
  const scene::DatabaseScene& given = *scene.hydro->database;
  VesselDatabase database;
  database.values = std::make_shared<const hydro::Database>(
      hydro::scaled(hydro::read_database(given.file, settings_of(given, scene.scale)), scene.scale));
  database.in_V = frame_of(given, parts);
  for (const hydro::Finding& finding : hydro::findings(*database.values, hydro::check_database(*database.values))) {
    if (finding.severe)
      throw InputError(scene.file.string() + ": <hydro><database file='" + given.file + "'>: " + finding.text);
    database.doubts.push_back(finding.text);
  }
  compare(scene, parts, database);
  return database;
}

}  // namespace nilas::sim
