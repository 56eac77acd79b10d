#include "fracture/bend/plate.h"

#include <cmath>

#include "core/base/error.h"

namespace nilas::fracture {

static void check(const IcePlate& plate) {
  NILAS_DEMAND(plate.thickness > 0 && plate.youngs_modulus > 0);
  NILAS_DEMAND(plate.water_density > 0 && plate.gravity > 0);
  NILAS_DEMAND(plate.poisson >= 0 && plate.poisson <= 0.5);
}

/// Unlike pow(), it has the same digits for x times 2^4: a scene at 16 times the scale breaks at 16 times the length.
static double fourth_root(double x) { return std::sqrt(std::sqrt(x)); }

/// The bending stiffness of a beam per width, E h^3 / 12 [N m].
static double beam_rigidity(const IcePlate& plate) {
  const double h = plate.thickness;
  return plate.youngs_modulus * (h * h * h) / 12;
}

static double foundation_modulus(const IcePlate& plate) { return plate.water_density * plate.gravity; }

double flexural_rigidity(const IcePlate& plate) {
  check(plate);
  return beam_rigidity(plate) / (1 - plate.poisson * plate.poisson);
}

double characteristic_length(const IcePlate& plate) {
  return fourth_root(flexural_rigidity(plate) / foundation_modulus(plate));
}

double beam_characteristic_length(const IcePlate& plate) {
  check(plate);
  return fourth_root(beam_rigidity(plate) / foundation_modulus(plate));
}

}  // namespace nilas::fracture
