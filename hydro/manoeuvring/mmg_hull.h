#pragma once
/// Forces on a hull by the MMG standard method.
#include "hydro/manoeuvring/planar_motion.h"

namespace nilas::hydro {

/// Coefficients of a hull [Yasukawa & Yoshimura 2015, J Mar Sci Technol 20, 37-52]. Forces are divided by
/// 0.5 rho L d U^2, the moment by 0.5 rho L^2 d U^2, velocities by U and the yaw rate by U/L. Added masses are divided
/// by 0.5 rho L^2 d and the added moment of inertia by 0.5 rho L^4 d.
struct MmgHull {
  double length = 0;   ///< L between perpendiculars [m]
  double draught = 0;  ///< d [m]
  double m_x = 0, m_y = 0, J_z = 0;
  double R_0 = 0, X_vv = 0, X_vr = 0, X_rr = 0, X_vvvv = 0;
  double Y_v = 0, Y_r = 0, Y_vvv = 0, Y_vvr = 0, Y_vrr = 0, Y_rrr = 0;
  double N_v = 0, N_r = 0, N_vvv = 0, N_vvr = 0, N_vrr = 0, N_rrr = 0;
};

/// The drift angle up to which the polynomials hold [rad], and the largest r L/U. Tests that the coefficients come from
/// go to about 20 degrees and 0.8.
extern const double k_mmg_drift;
extern const double k_mmg_yaw_rate;

/// X_H, Y_H, N_H of that paper, eqs. 7 to 9. Beyond k_mmg_drift and k_mmg_yaw_rate the polynomials are continued, not
/// measured: sway over speed and the yaw rate stay at these limits, and every term that a hull with equal ends would
/// have with the other sign when it goes astern fades with the surge velocity, to zero across the flow and to its
/// mirror image astern. So the loads stay bounded at any speed, and drift and yaw are always damped.
/// `density` of the water [kg/m^3].
PlanarLoads mmg_hull_loads(const MmgHull& hull, double density, const PlanarMotion& motion);

/// The added masses with dimension.
PlanarAddedMass mmg_added_mass(const MmgHull& hull, double density);

}  // namespace nilas::hydro
