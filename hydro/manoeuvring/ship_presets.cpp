#include "hydro/manoeuvring/ship_presets.h"

namespace nilas::hydro {

const double k_kvlcc2_length = 320;
const double k_supply_length = 76.2;

ManoeuvringShip kvlcc2(double length) {
  MmgHull hull;
  hull.length = k_kvlcc2_length;
  hull.draught = 20.8;
  hull.m_x = 0.022;
  hull.m_y = 0.223;
  hull.J_z = 0.011;
  hull.R_0 = 0.022;
  hull.X_vv = -0.040;
  hull.X_vr = 0.002;
  hull.X_rr = 0.011;
  hull.X_vvvv = 0.771;
  hull.Y_v = -0.315;
  hull.Y_r = 0.083;
  hull.Y_vvv = -1.607;
  hull.Y_vvr = 0.379;
  hull.Y_vrr = -0.391;
  hull.Y_rrr = 0.008;
  hull.N_v = -0.137;
  hull.N_r = -0.049;
  hull.N_vvv = -0.030;
  hull.N_vvr = -0.294;
  hull.N_vrr = 0.055;
  hull.N_rrr = -0.013;
  OpenWaterPropeller propeller;
  propeller.diameter = 9.86;
  propeller.k_0 = 0.2931;
  propeller.k_1 = -0.2753;
  propeller.k_2 = -0.1359;
  propeller.t_P = 0.220;
  propeller.w_P0 = 0.35;
  propeller.C_1 = 2.0;
  propeller.C_2_plus = 1.6;
  propeller.C_2_minus = 1.1;
  MmgRudder rudder;
  rudder.area = 112.5;
  rudder.f_alpha = 2.747;
  rudder.eta = 0.626;
  rudder.kappa = 0.50;
  rudder.epsilon = 1.09;
  rudder.t_R = 0.387;
  rudder.a_H = 0.312;
  rudder.x_H = -0.464;
  rudder.l_R = -0.710;
  rudder.gamma_plus = 0.640;
  rudder.gamma_minus = 0.395;
  return scaled({hull, propeller, rudder, 2}, length / k_kvlcc2_length);
}

ManoeuvringShip supply_vessel(double length, double gravity) {
  DerivativesHull hull;
  hull.scaling = DerivativeScaling::bis;
  hull.length = k_supply_length;
  hull.mass = 6000e3;
  hull.gravity = gravity;
  hull.X_udot = 1 - 1.1274;
  hull.Y_vdot = 1 - 1.8902;
  hull.Y_rdot = hull.N_vdot = 0.0744;
  hull.N_rdot = 0.25 * 0.25 - 0.1278;
  const auto term = [&](const char* name, double value) {
    hull.terms.push_back(*derivative_term(name));
    hull.terms.back().value = value;
  };
  term("X_u", -0.0358);
  term("Y_v", -0.1183);
  term("Y_r", 0.0124);
  term("N_v", 0.0041);
  term("N_r", -0.0308);
  ThrustCurve curve;
  curve.pull = 2 * 799e3;
  curve.max_speed = 7;
  curve.max_rps = 160.0 / 60;
  return scaled({hull, curve, std::nullopt, curve.max_rps}, length / k_supply_length);
}

}  // namespace nilas::hydro
