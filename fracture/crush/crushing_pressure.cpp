#include "fracture/crush/crushing_pressure.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace nilas::fracture {

static void check(const PressureArea& law) {
  NILAS_DEMAND(law.coefficient > 0);
  NILAS_DEMAND(law.exponent > -1 && law.exponent <= 0);
}

double crushing_pressure(const PressureArea& law, double area) {
  check(law);
  NILAS_DEMAND(area > 0);
  return law.coefficient * std::pow(area, law.exponent);
}

double crushing_force(const PressureArea& law, double area) {
  check(law);
  NILAS_DEMAND(area >= 0);
  return law.coefficient * std::pow(area, 1 + law.exponent);
}

double iso_local_pressure(double area) {
  NILAS_DEMAND(area > 0);
  return area <= 10 ? 7.40e6 * std::pow(area, -0.70) : 1.48e6;
}

double iso_global_pressure(double C_R, double h, double w) {
  NILAS_DEMAND(C_R > 0 && h > 0 && w > 0);
  const double n = std::min(-0.30, -0.50 + h / 5);
  return C_R * std::pow(h, n) * std::pow(w / h, -0.16);
}

CrushingStop stop_by_crushing(const CrushingImpact& impact) {
  NILAS_DEMAND(impact.mass > 0 && impact.area_growth > 0 && impact.speed >= 0);
  const PressureArea law{impact.pressure, impact.exponent};
  check(law);
  const double order = 3 + 2 * impact.exponent;
  const double stiffness = impact.pressure * std::pow(impact.area_growth, 1 + impact.exponent);
  const double depth = std::pow(order * impact.mass * impact.speed * impact.speed / (2 * stiffness), 1 / order);
  return {depth, crushing_force(law, impact.area_growth * depth * depth)};
}

}  // namespace nilas::fracture
