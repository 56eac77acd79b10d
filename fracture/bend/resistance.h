#pragma once
/// Ice resistance of ships by published formulas, for comparison with simulations.
#include "core/choices/defaults.h"

namespace nilas::fracture {

/// The properties of level ice that these formulas need.
struct LevelIce {
  double thickness = 1;                              ///< h [m]
  double flexural_strength = 5e5;                    ///< [Pa]
  double youngs_modulus = 2e9;                       ///< E [Pa]
  double poisson = 0.3;                              ///< nu
  double density = 920;                              ///< [kg/m^3]
  double water_density = defaults::k_water_density;  ///< [kg/m^3]
  double friction = 0.1;                             ///< mu: hull on ice.
  double gravity = defaults::k_gravity;              ///< [m/s^2]
};

/// The hull of a ship, in the letters of the formulas. Lengths [m], angles [rad].
struct IcebreakingHull {
  double length = 100, beam = 20, draught = 7;
  double stem_angle = 0.5236;       ///< phi: of the stem from the horizontal.
  double waterline_angle = 0.5236;  ///< alpha: of the waterline's entrance from the centreline.
};

/// The components of the resistance at rest, and the resistance at speed [N].
struct LindqvistResistance {
  double crushing = 0, bending = 0, submersion = 0;  ///< R_C, R_B, R_S
  double total = 0;                                  ///< R
};
/// The resistance of a ship in level ice after Lindqvist (1989). The paper was not available, so that brackets and
/// factors are choices of this program where no other source supports them (docs/theory/fracture.md, "For comparison").
/// With psi = atan(tan phi / sin alpha):
///   R_C = sigma h^2 / 2 (tan phi + mu cos phi / cos psi) / (1 - mu sin phi / cos psi)
///   R_B = 27/64 sigma B h^1.5 / sqrt(E / (12 (1 - nu^2) rho_w g))
///         (tan psi + mu cos phi / (sin alpha cos psi)) (1 + 1 / cos psi)
///   R_S = (rho_w - rho_i) g h B (T (B + T) / (B + 2 T) + mu (0.7 L - T / tan phi - B / (4 tan alpha)
///         + T cos phi cos psi sqrt(1 / sin^2 phi + 1 / tan^2 alpha)))
///   R = (R_C + R_B) (1 + 1.4 v / sqrt(g h)) + R_S (1 + 9.4 v / sqrt(g L)).
/// `speed` is in [m/s]. Throws ContractError unless speed >= 0, sizes are positive, ice is lighter than water, both
/// angles lie in (0, pi/2) and mu sin phi < cos psi.
LindqvistResistance lindqvist_resistance(const IcebreakingHull& hull, const LevelIce& ice, double speed);

/// The resistance [N] in broken ice of concentration S in [0, 1] after Zuev, as in the function R_Zuev of the open code
/// IceTech. With Fr = v / sqrt(g h):
///   R = rho_i g B h^2 (0.13 B / h + 1.3 Fr + 0.5 Fr^2) (2 - S) S^2.
/// Throws ContractError for impossible values.
double zuev_resistance(double beam, const LevelIce& ice, double concentration, double speed);

}  // namespace nilas::fracture
