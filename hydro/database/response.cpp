#include "hydro/database/response.h"

#include "core/base/error.h"

namespace nilas::hydro {

Mat6 rigid_mass(double mass, const Vec3& centre_of_gravity, const Vec3& radii) {
  Mat6 matrix = Mat6::Zero();
  matrix.topLeftCorner<3, 3>() = mass * Mat3::Identity();
  matrix.bottomRightCorner<3, 3>() = mass * Mat3(radii.cwiseAbs2().asDiagonal());
  matrix.topRightCorner<3, 3>() = -mass * skew(centre_of_gravity);
  matrix.bottomLeftCorner<3, 3>() = mass * skew(centre_of_gravity);
  return matrix;
}

ComplexVec6 response(double frequency, const Mat6& mass, const Mat6& added_mass, const Mat6& damping,
                     const Mat6& restoring, const ComplexVec6& excitation) {
  const Mat6 in_phase = restoring - frequency * frequency * (mass + added_mass);
  Eigen::Matrix<std::complex<double>, 6, 6> system;
  system.real() = in_phase;
  system.imag() = frequency * damping;
  return system.fullPivLu().solve(excitation);
}

std::vector<std::vector<ComplexVec6>> responses(const Database& database, const Mat6& mass) {
  if (database.excitation.empty())
    throw InputError(database.source + ": has no wave excitation, so there is no response to compute");
  if (!database.restoring)
    throw InputError(database.source + ": has no hydrostatic stiffness, so there is no response to compute");
  std::vector<std::vector<ComplexVec6>> motions;
  for (std::size_t k = 0; k < database.frequency.size(); ++k) {
    motions.emplace_back();
    for (const ComplexVec6& load : database.excitation[k])
      motions.back().push_back(response(database.frequency[k], mass, database.added_mass[k], database.damping[k],
                                        *database.restoring, load));
  }
  return motions;
}

}  // namespace nilas::hydro
