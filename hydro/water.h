#pragma once
/// Still water with a uniform current, and other parts of its motion.
#include "core/base/math.h"
#include "core/choices/defaults.h"
#include "hydro/flow/flow.h"

namespace nilas::hydro {

struct Water {
  double density = defaults::k_water_density;  ///< [kg/m^3]
  double level = 0;                            ///< z of the free surface [m]
  Vec3 current = Vec3::Zero();                 ///< The uniform current [m/s].
  Flows flows;                                 ///< What varies in place or time; it adds to the uniform current.
  double gravity = defaults::k_gravity;        ///< Magnitude; acts along -Z [m/s^2].
};

}  // namespace nilas::hydro
