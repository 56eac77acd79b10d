#pragma once
/// The cone {x_0 >= |x_T|} of three dimensions as the squares of a Jordan algebra, and its Nesterov-Todd scaling.
///
///   x o z = (x.z, x_0 z_T + z_0 x_T),   e = (1, 0, 0),   det x = x_0^2 - |x_T|^2,   J = diag(1, -1, -1)
///
/// For x, z inside the cone the scaling is the symmetric P with P x = P^-1 z =: l. With x~ = x / sqrt(det x), z~ alike,
/// g^2 = (1 + x~.z~)/2, w = (z~ + J x~)/(2 g), v = (w + e)/sqrt(2 (w_0 + 1)) and c = (det z/det x)^(1/4):
///   P = c (2 v v^T - J),   P^-1 = (2 J v v^T J - J)/c,   P^2 = c^2 (2 w w^T - J),   P^2 x = z
/// A half line x_0 >= 0 is carried as a vector with x_T = 0; then P = sqrt(z_0/x_0) on the first entry.
/// Sources: Nesterov, Todd 1998 (self-scaled cones); Alizadeh, Goldfarb 2003 (second-order cone programming).
#include <cmath>
#include <limits>

#include "contact/law/cone.h"

namespace nilas::solvers {

/// x_0 - |x_T|: positive inside, in the units of x.
inline double cone_margin(const Vec3& x) { return x[0] - contact::tangential_norm(x); }

/// Factored, so that a point near the boundary keeps its digits.
inline double cone_determinant(const Vec3& x) { return cone_margin(x) * (x[0] + contact::tangential_norm(x)); }

inline Vec3 mirrored(const Vec3& x) { return {x[0], -x[1], -x[2]}; }

inline Vec3 jordan_product(const Vec3& x, const Vec3& z) {
  return {x.dot(z), x[0] * z[1] + z[0] * x[1], x[0] * z[2] + z[0] * x[2]};
}

/// y with x o y = b, for x inside the cone.
inline Vec3 jordan_quotient(const Vec3& b, const Vec3& x) {
  const double first = (x.dot(mirrored(b))) / cone_determinant(x);
  return {first, (b[1] - first * x[1]) / x[0], (b[2] - first * x[2]) / x[0]};
}

/// Largest t with x + t dx in the cone, for x inside; infinite when the ray stays.
inline double step_to_boundary(const Vec3& x, const Vec3& dx) {
  const double a = dx.dot(mirrored(dx)), b = x.dot(mirrored(dx)), c = cone_determinant(x);
  const double discriminant = b * b - a * c;
  const double divisor = discriminant < 0 ? 0 : std::sqrt(discriminant) - b;
  return divisor > 0 ? c / divisor : std::numeric_limits<double>::infinity();
}

struct NesterovTodd {
  Mat3 scaling;  ///< P
  Mat3 inverse;  ///< P^-1
  Vec3 scaled;   ///< l = P x = P^-1 z
};

/// Returns the scaling of x and z, both inside the cone.
inline NesterovTodd nesterov_todd(const Vec3& x, const Vec3& z) {
  const Vec3 signs(1, -1, -1);
  const double det_x = cone_determinant(x), det_z = cone_determinant(z);
  const Vec3 unit_x = x / std::sqrt(det_x), unit_z = z / std::sqrt(det_z);
  const double g = std::sqrt(0.5 * (1 + unit_x.dot(unit_z)));
  const Vec3 w = (unit_z + mirrored(unit_x)) / (2 * g);
  const Vec3 v = (w + Vec3::UnitX()) / std::sqrt(2 * (w[0] + 1));
  const double c = std::sqrt(std::sqrt(det_z / det_x));
  const Mat3 reflection = signs.asDiagonal();
  NesterovTodd nt;
  nt.scaling = c * (2 * v * v.transpose() - reflection);
  nt.inverse = (2 * mirrored(v) * mirrored(v).transpose() - reflection) / c;
  nt.scaled = nt.scaling * x;
  return nt;
}

}  // namespace nilas::solvers
