#pragma once
/// What drives a ship ahead: a propeller with its open-water curve, or a curve of net thrust.
#include "hydro/manoeuvring/planar_motion.h"

namespace nilas::hydro {

/// A propeller behind a hull [Yasukawa & Yoshimura 2015, eqs. 10 to 16]:
///   J = u (1 - w_P)/(n D),  K_T = k_0 + k_1 J + k_2 J^2,  T = rho n^2 D^4 K_T,  X = (1 - t_P) T
///   (1 - w_P)/(1 - w_P0) = 1 + (1 - exp(-C_1 |b|)) (C_2 - 1),  b = beta - x_P r L/U
/// with the drift angle beta = atan(-v/u), and C_2 by the sign of b.
struct OpenWaterPropeller {
  double diameter = 0;  ///< D [m]
  double k_0 = 0, k_1 = 0, k_2 = 0;
  double t_P = 0, w_P0 = 0;
  double C_1 = 0, C_2_plus = 1, C_2_minus = 1;  ///< as published by default: no change of the wake
  double x_P = -0.5;                            ///< position over L
};

/// Velocity of the water that reaches the propeller, (1 - w_P) u [m/s]; zero where the ship goes astern. `length`: L.
double propeller_inflow(const OpenWaterPropeller& propeller, double length, const PlanarMotion& motion);
/// T at n >= 0 [1/s] and that inflow [N]. With k_2 < 0 a propeller at rest brakes.
double propeller_thrust(const OpenWaterPropeller& propeller, double density, double inflow, double rps);

/// Net thrust of an icebreaker: what is left of the thrust after the open-water resistance, by share s of the largest
/// rate of revolutions and speed x over the open-water speed,
///   T_net = pull (s|s| - a_1 |s| x - a_2 x|x|)
/// At s = 1 it is T_pull (1 - x/3 - 2/3 x^2) [Juva & Riska 2002]. Thrust and resistance both go with the square of the
/// speed at equal x/s, so with a_1 + a_2 = 1 the ship goes at x = s in open water.
struct ThrustCurve {
  double pull = 0;       ///< bollard pull [N]
  double max_speed = 0;  ///< open-water speed at the largest rate of revolutions [m/s]
  double max_rps = 1;    ///< [1/s]
  double diameter = 0;   ///< of the propeller whose jet meets the rudder; 0: the rudder feels no jet [m]
  double a_1 = 1.0 / 3, a_2 = 2.0 / 3;
};
/// `u`: velocity ahead through the water [m/s].
double net_thrust(const ThrustCurve& curve, double u, double rps);
/// The bollard pull K_e (P D)^(2/3) of 1, 2 or 3 screws [N], with P in kW, D in m, and K_e 0.78, 0.98 and 1.12 in
/// kN/(kW m)^(2/3) [Juva & Riska 2002]. `power`: delivered [W]; `diameter`: of the propellers [m]. Throws InputError
/// for another number of screws.
double bollard_pull(double power, double diameter, int screws);

}  // namespace nilas::hydro
