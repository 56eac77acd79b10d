#include "core/sim/build/module/hull_water_modules.h"

#include "core/base/error.h"
#include "hydro/added_mass/added_mass.h"
#include "hydro/database/read_database.h"
#include "hydro/restoring/restoring.h"

namespace nilas::sim {

BuiltModule restoring(const ModuleSources& from) {
  if (!from.scene.hydro || !from.scene.hydro->restoring) return {};
  const WorldParts& parts = from.parts;
  const hydro::Database& database = *parts.database->values;
  if (!database.restoring)
    throw InputError(from.scene.file.string() + ": <hydro><restoring>: the database " + database.source +
                     " has no hydrostatic stiffness; WAMIT writes it to a file .hst");
  const geometry::MassProperties& mass = parts.vessel_model->mass;
  hydro::RestoredHull hull;
  hull.body = parts.vessel_index;
  hull.D_in_B.p = parts.database->in_V.p - mass.com;
  hull.D_in_B.q = parts.database->in_V.q;
  hull.mass = mass.mass;
  hull.gravity = parts.water->gravity;
  hull.level = parts.water->level;
  const Vec3 com = -(hull.D_in_B.q.conjugate() * hull.D_in_B.p);
  const double specific_weight = parts.water->density * hull.gravity;
  hull.lift = database.volume ? specific_weight * *database.volume : hull.mass * hull.gravity;
  hull.lift_centre = database.centre_of_buoyancy.value_or(com).head<2>();
  const Mat6 stiffness = hydro::restoring_with_weight_at(database, specific_weight, hull.mass * hull.gravity, com);
  return {hydro::make_restoring(hull, stiffness), "<hydro><restoring>"};
}

BuiltModule database_tilt(const ModuleSources& from) {
  const auto& given = from.scene.hydro;
  if (!given || !given->database) return {};
  const bool of_waves = given->wave_loads && (given->wave_loads->vessel == VesselWaveLoads::database ||
                                              given->wave_loads->diffraction == VesselDiffraction::database);
  if (!given->restoring && !given->radiation && !of_waves) return {};
  return {hydro::make_tilt_watch(from.parts.vessel_index, from.warnings), "loads of <hydro><database>"};
}

/// Added mass of the hull about its centre of mass; nothing where the scene asks for none.
static std::optional<Mat6> vessel_added_mass(const ModuleSources& from, const scene::AddedMassScene& added) {
  if (added.vessel == VesselAddedMass::none) return std::nullopt;
  if (added.vessel == VesselAddedMass::database) {
    const Mat6 of_file = from.parts.database->about(hydro::demand_infinite_added_mass(*from.parts.database->values),
                                                    from.parts.vessel_model->mass.com);
    return Mat6(0.5 * (of_file + of_file.transpose()));
  }
  Mat6 matrix = Mat6::Zero();
  if (added.matrix.size() == 6)
    matrix.diagonal() = Eigen::Map<const Vec6>(added.matrix.data());
  else
    matrix = Eigen::Map<const Mat6>(added.matrix.data());
  // Terms have different units, so the scene keeps the unscaled matrix.
  const double lambda = from.scene.scale;
  Vec6 levers;
  levers << Vec3::Ones(), Vec3::Constant(lambda);
  matrix = (lambda * lambda * lambda * (levers.asDiagonal() * matrix * levers.asDiagonal())).eval();
  const Vec3 com = from.parts.vessel_model->mass.com;
  return hydro::about_other_point(matrix, added.at.value_or(com) - com);
}

BuiltModule added_mass(const ModuleSources& from) {
  if (!from.scene.hydro || !from.scene.hydro->added_mass) return {};
  const scene::AddedMassScene& added = *from.scene.hydro->added_mass;
  return {hydro::make_added_mass(added.floes, from.parts.water->density, vessel_added_mass(from, added)),
          "<hydro><added_mass>: floes " + name_of(added.floes) + ", vessel " + name_of(added.vessel)};
}

}  // namespace nilas::sim
