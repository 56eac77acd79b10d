#pragma once
/// Loads of level ice on sloping structures by published formulas, for comparison with simulations.
#include "fracture/bend/resistance.h"

namespace nilas::fracture {

/// A sloping structure that may carry a pile of rubble. `ice.friction` is that of ice on the structure. Angles [rad].
struct SlopingStructure {
  double width = 10;        ///< w [m]; for a cone its diameter D at the waterline.
  double slope = 0.7854;    ///< alpha: angle from the horizontal.
  bool edge_cracks = true;  ///< The sheet also breaks next to the structure: l_c = w + pi^2 L_c / 4, else w.
};
struct Rubble {
  double height = 0;            ///< h_r [m]
  double angle = 0.5;           ///< theta: slope of its surface, < alpha.
  double porosity = 0.3;        ///< e
  double cohesion = 0;          ///< c [Pa]
  double friction_angle = 0.6;  ///< phi_r
  double ice_friction = 0.1;    ///< mu_i: ice on ice.
};
/// The horizontal load and its components [N].
struct SlopeLoad {
  double breaking = 0, push_through = 0, ride_up = 0, lifting = 0, turning = 0;  ///< H_B, H_P, H_R, H_L, H_T
  double total = 0;
};
/// The load on a slope after Croasdale and Cammaert (1994). The equations are those of OpenFAST's IceFloe for ISO
/// 19906, with xi = (sin a + mu cos a) / (cos a - mu sin a), L_c = (E h^3 / (12 rho_w g (1 - nu^2)))^(1/4), q = 1 - tan
/// th / tan a, G = rho_i g (1 - e):
///   H_B = 0.68 xi sigma (rho_w g h^5 / E)^(1/4) l_c
///   H_P = w h_r^2 mu_i G q^2 / (2 tan th)
///   P   = mu_i (mu_i + mu) G h_r^2 sin a (cot th - cot a) q / 2 + (mu_i + mu) G h_r^2 cos a cot a q / 2
///         + h_r h rho_i g (sin a + mu cos a) / sin a,                            H_R = w P / (cos a - mu sin a)
///   H_L = w h_r xi q (h_r G (cot th - cot a + q tan phi_r) / 2 + c)
///   H_T = 1.5 w h^2 rho_i g cos a / (sin a - mu cos a)
///   H   = (H_B + H_P + H_R + H_L + H_T) / (1 - H_B / (sigma l_c h)).
/// Throws ContractError for sizes that are not positive, a slope outside (0, pi/2), or rubble steeper than the slope.
/// The same holds for a friction that locks the ice on the slope, and for ice that crushes first (H_B >= sigma l_c h).
SlopeLoad croasdale_load(const SlopingStructure& structure, const LevelIce& ice, const Rubble& rubble);

/// The load [N] on an upward cone after Ralston (1977). The equations are those of OpenFAST's IceFloe for IEC 61400-3.
/// a is the slope, D and D_T are the diameters at the waterline and the top, h_ru is the thickness of the ice that
/// rides up:
///   x = 1 + (3 G + Y/2)^(-1/2), Y = 2.711 (Tresca), G = rho_i g D^2 / (4 sigma h)
///   g_r = (sin a + a / cos a) / (2 mu a cos a + pi/2 sin^2 a)
///   H_B = sigma h^2 / 3  tan a / (1 - mu g_r) (G (x - 1) (x + 2) + (1 + Y x ln x) / (x - 1))
///   H_R = W (tan a + mu (E_2 - f g_r cos a)) / (1 - mu g_r), W = rho_i g h_ru (D^2 - D_T^2) / (4 cos a),
///   f = sin a + mu E_1 cos a, E_1 and E_2 the complete elliptic integrals of modulus sin a.
/// W lacks the factor pi of a cone's surface, as in the source. Throws ContractError for impossible sizes, or where
/// mu g_r >= 1.
struct RalstonLoad {
  double breaking = 0, ride_up = 0;  ///< H_B, H_R [N]
};
RalstonLoad ralston_load(const SlopingStructure& cone, double top_diameter, double ride_up_thickness,
                         const LevelIce& ice);

}  // namespace nilas::fracture
