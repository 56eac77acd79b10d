#pragma once
/// Pressure of crushing ice on an area, and impacts that it stops.

namespace nilas::fracture {

/// The pressure p = C (A / 1 m^2)^e [Pa] on a contact area A [m^2]. With e in (-1, 0] the force C A^(1 + e) grows from
/// 0. Crushing at a constant strength has e = 0.
struct PressureArea {
  double coefficient = 1e6;  ///< C: pressure on 1 m^2 [Pa].
  double exponent = 0;       ///< e
};
/// The pressure [Pa] on an area [m^2]. Throws ContractError unless C > 0, -1 < e <= 0 and A > 0.
double crushing_pressure(const PressureArea& law, double area);
/// The force C A^(1 + e) [N]. Throws ContractError unless C > 0, -1 < e <= 0 and A >= 0.
double crushing_force(const PressureArea& law, double area);

/// A design pressure [Pa] on a local area [m^2]: 7.40 MPa A^-0.70 up to 10 m^2, 1.48 MPa above. Palmer, Dempsey and
/// Masterson (2009) support the exponent and the limit of 10 m^2. The two pressures are values of this program. The two
/// branches meet within 0.3 %. Throws ContractError unless area > 0.
double iso_local_pressure(double area);

/// Ice strength coefficients C_R [Pa] of the global pressure. They are values of this program; the text of ISO 19906
/// was not available to check them.
constexpr double k_iso_arctic = 2.8e6, k_iso_baltic = 1.8e6;
/// The global crushing pressure [Pa] on a vertical structure of width w [m] in ice of thickness h [m]:
/// p_G = C_R (h / 1 m)^n (w / h)^-0.16, with n = -0.50 + h / 5 below 1 m and -0.30 above. Form and exponents are those
/// of OpenFAST's IceFloe, which names ISO 19906:2010, A.8.2.4.3.3. The force is p_G w h. Throws ContractError unless
/// all are positive.
double iso_global_pressure(double C_R, double h, double w);

/// A head-on impact that crushing stops. The contact area grows with the depth d of crushing as A = g d^2. The balance
/// of energy is the principle of the Popov method (Idrissova et al. 2019).
struct CrushingImpact {
  double mass = 1;         ///< effective mass M_e along the normal [kg]
  double speed = 1;        ///< closing speed v_n along the normal [m/s], >= 0
  double area_growth = 1;  ///< g
  double pressure = 1e6;   ///< P0 [Pa] at 1 m^2
  double exponent = -0.1;  ///< ex: F = P0 A^(1 + ex).
};
struct CrushingStop {
  double depth = 0;  ///< largest depth [m]
  double force = 0;  ///< force there [N]
};
/// Depth and force of the impact. M_e v_n^2 / 2 = int F dd gives
/// depth = ((3 + 2 ex) M_e v_n^2 / (2 P0 g^(1 + ex)))^(1 / (3 + 2 ex)); docs/theory/fracture.md has the derivation.
/// Throws ContractError unless mass, g and P0 are positive, speed >= 0 and -1 < ex <= 0.
CrushingStop stop_by_crushing(const CrushingImpact& impact);

}  // namespace nilas::fracture
