#include "fracture/bend/plate.h"

#include <cmath>

#include "core/base/error.h"

namespace nilas::fracture {

static void check(const IcePlate& plate) {
  NILAS_DEMAND(plate.thickness > 0 && plate.youngs_modulus > 0);
  NILAS_DEMAND(plate.water_density > 0 && plate.gravity > 0);
  NILAS_DEMAND(plate.poisson >= 0 && plate.poisson <= 0.5);
}

/// The bending stiffness of a beam per width, E h^3 / 12 [N m].
static double beam_rigidity(const IcePlate& plate) { return plate.youngs_modulus * std::pow(plate.thickness, 3) / 12; }

static double foundation_modulus(const IcePlate& plate) { return plate.water_density * plate.gravity; }

double flexural_rigidity(const IcePlate& plate) {
  check(plate);
  return beam_rigidity(plate) / (1 - plate.poisson * plate.poisson);
}

double characteristic_length(const IcePlate& plate) {
  return std::pow(flexural_rigidity(plate) / foundation_modulus(plate), 0.25);
}

double beam_characteristic_length(const IcePlate& plate) {
  check(plate);
  return std::pow(beam_rigidity(plate) / foundation_modulus(plate), 0.25);
}

}  // namespace nilas::fracture
