#pragma once
/// Still water with a uniform current.
#include "core/base/math.h"
#include "core/choices/defaults.h"

namespace nilas::hydro {

struct Water {
  double density = defaults::k_water_density;  ///< [kg/m^3]
  double level = 0;                            ///< z of the free surface [m]
  Vec3 current = Vec3::Zero();                 ///< [m/s]
  double gravity = defaults::k_gravity;        ///< Magnitude; acts along -Z [m/s^2].
};

}  // namespace nilas::hydro
