#pragma once
/// Still water with a uniform current.
#include "core/base/math.h"

namespace nilas {

struct Water {
  double density = 1025;        ///< [kg/m^3]
  double level = 0;             ///< z of the free surface [m]
  Vec3 current = Vec3::Zero();  ///< [m/s]
  double gravity = 9.81;        ///< magnitude, acting along -Z [m/s^2]
};

}  // namespace nilas
