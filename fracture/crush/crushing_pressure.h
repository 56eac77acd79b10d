#pragma once
/// Pressure of crushing ice on an area, and impacts that it stops.

namespace nilas {

/// p = C (A / 1 m^2)^e [Pa]: the pressure on a contact area A [m^2]. e in (-1, 0] keeps the force C A^(1 + e) growing
/// from 0; seed-style crushing at a constant strength has e = 0.
struct PressureArea {
  double coefficient = 1e6;  ///< C [Pa], at 1 m^2
  double exponent = 0;       ///< e
};
/// Both throw ContractError unless C > 0, -1 < e <= 0 and A > 0 (A >= 0 for the force).
double crushing_pressure(const PressureArea& law, double area);
/// C A^(1 + e) [N].
double crushing_force(const PressureArea& law, double area);

/// Design pressure on a local area [m^2]: 7.40 MPa A^-0.70 up to 10 m^2, 1.48 MPa above (ISO 19906; recalled, not
/// verified). The two branches meet within 0.3 %, as published. Throws ContractError unless area > 0.
double iso_local_pressure(double area);

/// Ice strength coefficients C_R [Pa] of the global pressure (ISO 19906; recalled, not verified).
constexpr double k_iso_arctic = 2.8e6, k_iso_baltic = 1.8e6;
/// Global crushing pressure [Pa] on a vertical structure of width w in ice of thickness h [m], ISO 19906:
/// p_G = C_R (h / 1 m)^n (w / h)^-0.16, n = -0.50 + h / 5 below 1 m and -0.30 above; form and exponents as in
/// OpenFAST's IceFloe. The force is p_G w h. Throws ContractError unless all are positive.
double iso_global_pressure(double C_R, double h, double w);

/// Head-on impact that crushing stops (Popov et al. 1967; Daley 1999): a contact whose area grows with the depth d of
/// crushing as A = g d^2.
struct CrushingImpact {
  double mass = 1;         ///< effective mass M_e along the normal [kg]
  double speed = 1;        ///< closing speed v_n along the normal [m/s], >= 0
  double area_growth = 1;  ///< g
  double pressure = 1e6;   ///< P0 [Pa] at 1 m^2
  double exponent = -0.1;  ///< ex: F = P0 A^(1 + ex); Polar Class rules have -0.1
};
struct CrushingStop {
  double depth = 0;  ///< largest depth [m]
  double force = 0;  ///< force there [N]
};
/// M_e v_n^2 / 2 = int F dd gives depth = ((3 + 2 ex) M_e v_n^2 / (2 P0 g^(1 + ex)))^(1 / (3 + 2 ex)).
/// Throws ContractError unless mass, g and P0 are positive, speed >= 0 and -1 < ex <= 0.
CrushingStop stop_by_crushing(const CrushingImpact& impact);

}  // namespace nilas
