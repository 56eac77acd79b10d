#pragma once
/// The forces of a rudder behind a propeller.
#include "hydro/manoeuvring/planar_motion.h"

namespace nilas::hydro {

/// Coefficients of a rudder [Yasukawa & Yoshimura 2015, eqs. 17 to 24]. Positions are over L.
struct MmgRudder {
  double area = 0;     ///< A_R, movable [m^2]
  double f_alpha = 0;  ///< slope of the lift over sin of the angle of attack
  double eta = 0;      ///< propeller diameter over rudder span
  double kappa = 0, epsilon = 1;
  double t_R = 0, a_H = 0, x_H = 0, x_R = -0.5;
  double l_R = 0, gamma_plus = 1, gamma_minus = 1;
};

/// X_R, Y_R, N_R:
///   F_N = 0.5 rho A_R f_alpha (u_R^2 + v_R^2) sin(delta - atan(v_R/u_R))
///   u_R = epsilon sqrt(eta (u_P + kappa (sqrt(u_P^2 + 8 T/(pi rho D^2)) - u_P))^2 + (1 - eta) u_P^2)
///   v_R = gamma (U beta - l_R L r), gamma by the sign of that bracket
///   X = -(1 - t_R) F_N sin delta,  Y = -(1 + a_H) F_N cos delta,  N = -(x_R + a_H x_H) L F_N cos delta
/// `angle`: delta, positive with the trailing edge to starboard, which turns the bow to starboard [rad]. `inflow`: u_P,
/// of the propeller [m/s]. `jet`: T/(rho D^2) of the propeller [m^2/s^2]. A drift angle beyond that of the hull's
/// polynomials counts as if the ship went ahead at that angle's speed, so the rudder of a ship astern only feels the
/// propeller.
PlanarLoads mmg_rudder_loads(const MmgRudder& rudder, double density, double length, const PlanarMotion& motion,
                             double angle, double inflow, double jet);

}  // namespace nilas::hydro
