#include "fracture/crush/crushing_law.h"

#include <cmath>

namespace nilas::fracture {

double CrushingLaw::pressure(double strength, double area) const {
  if (!(area > 0)) return 0;
  if (model != CrushingModel::pressure_area) return strength;
  return coefficient * (strength / reference_strength) * std::pow(area, exponent);
}

}  // namespace nilas::fracture
