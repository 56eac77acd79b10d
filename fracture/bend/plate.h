#pragma once
/// Stiffness of a floating ice sheet as an elastic plate (or beam) on water, a Winkler foundation of modulus k.
#include "core/choices/defaults.h"

namespace nilas::fracture {

/// Elastic ice sheet on water.
struct IcePlate {
  double thickness = 1;                              ///< h [m]
  double youngs_modulus = 5e9;                       ///< E [Pa]
  double poisson = 0.3;                              ///< nu, in [0, 0.5]
  double water_density = defaults::k_water_density;  ///< [kg/m^3]
  double gravity = defaults::k_gravity;              ///< [m/s^2]
};

/// The bending stiffness D = E h^3 / (12 (1 - nu^2)) [N m]. This and the next two functions throw ContractError unless
/// thickness, modulus, density and gravity are positive and 0 <= nu <= 0.5.
double flexural_rigidity(const IcePlate& plate);
/// The characteristic length of a plate, l = (D / (rho_w g))^(1/4) [m] (Hertz 1884), for sheets and their edges.
double characteristic_length(const IcePlate& plate);
/// The characteristic length of a beam, l = (E h^3 / (12 rho_w g))^(1/4) [m], for wedges. They bend as beams, without
/// (1 - nu^2).
double beam_characteristic_length(const IcePlate& plate);

}  // namespace nilas::fracture
