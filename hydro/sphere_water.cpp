#include <algorithm>

#include "hydro/wetted.h"

namespace nilas::hydro {

Submerged submerged_sphere(double radius, const Vec3& p, double level) {
  constexpr double
      k_three = 3,
      k_four = 4;  // spherical cap of height d: V = pi d^2 (3r - d)/3, centre 3(2r - d)^2/(4(3r - d)) from the sphere's
  const double depth = std::clamp(level - p.z() + radius, 0.0, 2 * radius);
  if (depth == 0) return {0, p};
  const double dry = 2 * radius - depth, slant = k_three * radius - depth;
  const double below = k_three * dry * dry / (k_four * slant);
  return {k_pi / k_three * depth * depth * slant, p - Vec3(0, 0, below)};
}

}  // namespace nilas::hydro
