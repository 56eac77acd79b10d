#include "hydro/database/reference_point.h"

namespace nilas::hydro {

static void move(std::optional<Mat6>& matrix, const Mat6& t) {
  if (matrix) matrix = Mat6(t.transpose() * *matrix * t);
}

Database about_origin(Database database, const Vec3& reference) {
  if (reference.isZero(0)) return database;
  Mat6 to_point = Mat6::Identity();
  to_point.topRightCorner<3, 3>() = -skew(reference);
  Mat6 to_origin = Mat6::Identity();
  to_origin.topRightCorner<3, 3>() = skew(reference);
  for (auto* matrices : {&database.added_mass, &database.damping})
    for (Mat6& matrix : *matrices) matrix = Mat6(to_point.transpose() * matrix * to_point);
  for (auto* matrix : {&database.added_mass_zero, &database.added_mass_infinite, &database.restoring, &database.mass})
    move(*matrix, to_point);
  for (auto& of_frequency : database.excitation)
    for (ComplexVec6& load : of_frequency) load = ComplexVec6(to_point.transpose() * load);
  for (auto& of_frequency : database.motion)
    for (ComplexVec6& motion : of_frequency) motion = ComplexVec6(to_origin * motion);
  for (auto& of_frequency : database.drift)
    for (Vec6& load : of_frequency) load = Vec6(to_point.transpose() * load);
  return database;
}

}  // namespace nilas::hydro
