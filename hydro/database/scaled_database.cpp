#include "hydro/database/scaled_database.h"

#include <cmath>

namespace nilas::hydro {

namespace {

/// A 6 x 6 matrix whose terms are `whole` times the scale for translations, and lambda more for each rotation.
Mat6 scaled_matrix(const Mat6& matrix, double whole, double lambda) {
  Vec6 levers;
  levers << Vec3::Ones(), Vec3::Constant(lambda);
  return whole * (levers.asDiagonal() * matrix * levers.asDiagonal());
}

template <class Vector>
void scale_loads(std::vector<std::vector<Vector>>& loads, double force, double lambda) {
  for (auto& of_frequency : loads)
    for (Vector& load : of_frequency) {
      load.template head<3>() *= force;
      load.template tail<3>() *= force * lambda;
    }
}

}  // namespace

Database scaled(Database database, double lambda) {
  if (lambda == 1) return database;
  const double area = lambda * lambda, volume = area * lambda, time = std::sqrt(lambda);
  if (database.depth) *database.depth *= lambda;
  if (database.volume) *database.volume *= volume;
  if (database.centre_of_buoyancy) *database.centre_of_buoyancy *= lambda;
  if (database.centre_of_gravity) *database.centre_of_gravity *= lambda;
  if (database.restoring) *database.restoring = scaled_matrix(*database.restoring, area, lambda);
  if (database.mass) *database.mass = scaled_matrix(*database.mass, volume, lambda);
  for (double& frequency : database.frequency) frequency /= time;
  for (Mat6& added : database.added_mass) added = scaled_matrix(added, volume, lambda);
  for (Mat6& damping : database.damping) damping = scaled_matrix(damping, volume / time, lambda);
  if (database.added_mass_zero) *database.added_mass_zero = scaled_matrix(*database.added_mass_zero, volume, lambda);
  if (database.added_mass_infinite)
    *database.added_mass_infinite = scaled_matrix(*database.added_mass_infinite, volume, lambda);
  scale_loads(database.excitation, area, lambda);  // per metre of amplitude
  scale_loads(database.drift, lambda, lambda);     // per square metre
  for (auto& of_frequency : database.motion)
    for (ComplexVec6& motion : of_frequency) motion.tail<3>() /= lambda;
  return database;
}

}  // namespace nilas::hydro
