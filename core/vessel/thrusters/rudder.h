#pragma once
/// A rudder in the slipstream of a propeller.
#include "core/base/math.h"

namespace nilas::vessel {

struct Rudder {
  double area = 0;           ///< lateral area [m^2]
  double span = 0;           ///< height [m]; the aspect ratio is span^2 / area
  double behind = 0;         ///< distance from the propeller's plane to the rudder [m]
  double diameter = 0;       ///< of the propeller [m]
  double most_angle = 0;     ///< [rad]
  double water_density = 0;  ///< [kg/m^3]

  double aspect_ratio() const { return span * span / area; }
};

/// Lift and drag at the angle of attack [rad], on the rudder's area and the dynamic pressure of the inflow:
///   C_L = 2 pi A (A + 0.7) / (A + 1.7)^2 sin a + C_Q sin a |sin a| cos a,
///   C_D = C_L^2 / (pi A) + C_Q |sin a|^3 + C_D0,
/// with the aspect ratio A, C_Q = 1 and C_D0 = 0.008 of a smooth rudder at full scale. Source: Soeding in Brix,
/// Manoeuvring Technical Manual (1993), also in Bertram, Practical Ship Hydrodynamics (2000), section 5.4. Stall is not
/// modelled: valid up to about 35 degrees.
struct RudderCoefficients {
  double lift = 0, drag = 0;
};
RudderCoefficients rudder_coefficients(double aspect_ratio, double attack);

/// The slipstream where the rudder stands. By momentum theory and Soeding's contraction (same sources):
///   V_inf^2 = V_a^2 + 2 T / (rho A_p),  r_inf = r_0 sqrt((1 + V_a / V_inf) / 2),
///   r / r_0 = (0.14 k^3 + k c) / (0.14 k^3 + c),  k = r_inf / r_0, c = (x / r_0)^1.5,  V = V_inf (r_inf / r)^2,
/// with thrust T [N], disc area A_p and distance x. At x = 0 it is the mean of V_a and V_inf, far behind V_inf. Mixing
/// with the water around, which slows the slipstream a little, is left out.
struct Slipstream {
  double radius = 0;  ///< [m]
  double speed = 0;   ///< [m/s]
};
Slipstream slipstream_at(const Rudder& rudder, double thrust, double advance);

/// Force of the rudder in the axes of the vessel, x forward and y to port [N]. `angle`: positive where the rudder
/// deflects the thrust to port [rad]; `thrust`: of the propeller, without effect on the flow where it is not ahead [N];
/// `advance`, `sideways`: velocity of the rudder through the undisturbed water, forward and to port [m/s]. The part of
/// the span outside the slipstream meets the undisturbed water. Without a flow from ahead there is no force.
Vec2 rudder_force(const Rudder& rudder, double angle, double thrust, double advance, double sideways);

}  // namespace nilas::vessel
