#pragma once
/// The jet of water behind a propeller or thruster.
///
/// A propeller at rest in open water that exerts the thrust T makes a jet whose momentum flux is T. By momentum theory
/// the slipstream contracts to half the area of the disc of diameter D:
///   D0 = D / sqrt(2),   V0 = sqrt(8 T / (pi rho D^2)),
/// which is V0 = 1.60 n D sqrt(K_T) with T = K_T rho n^2 D^4. Further along the axis x the jet widens as a turbulent
/// round jet [Albertson, Dai, Jensen, Rouse 1950], with c = 0.19 behind propellers [Blaauw, van de Kaa 1978]. Let
/// s = c x be the radius of its Gaussian edge and R0 = D0 / 2:
///   s < R0:  u = V0 within the core radius r_c, V0 exp(-(r - r_c)^2 / (2 s^2)) outside;
///   s >= R0: u = V0 (R0 / s) exp(-r^2 / (2 s^2)).
/// The axis keeps V0 up to x = 2.6 D0 and then falls as 2.6 V0 D0 / x. r_c follows from the constancy of the momentum
/// flux, r_c^2 + sqrt(pi) r_c s + s^2 = R0^2. So the flux is T at every x. Albertson's straight core, r_c = R0 - s,
/// loses up to 5.7 % of it.
///
/// Limits: no swirl, no entrained inflow, no surface, wall or hull beside the jet, and no inflow to the propeller by
/// the speed of the vessel. The jet follows thrust and pose at once.
#include "core/base/math.h"
#include "hydro/flow/flow.h"

namespace nilas::hydro {

/// c, by which the Gaussian edge of a propeller's jet widens.
inline constexpr double k_jet_spread = 0.19;

class PropellerJet : public Flow {
 public:
  /// `diameter` of the disc [m], `density` of the water [kg/m^3], both above 0. There is no jet before set().
  PropellerJet(double diameter, double density, double spread = k_jet_spread);

  /// The centre of the disc and the unit vector along which the jet leaves it, in G [m, 1], and the thrust that drives
  /// it [N]. With a thrust below 0 the jet leaves to the other side.
  void set(const Vec3& position, const Vec3& direction, double thrust);

  Vec3 velocity(const Vec3& p_G, double t) const override;
  bool acts_on_vessel() const override { return false; }

  double efflux_velocity() const { return efflux_; }   ///< V0 [m/s]
  double jet_diameter() const { return 2 * radius_; }  ///< D0 [m]
  /// Speed along the axis at x behind the disc and r from the axis [m/s].
  double speed(double x, double r) const;

 private:
  double disc_area_, density_, spread_, radius_;
  double efflux_ = 0;
  Vec3 position_ = Vec3::Zero(), direction_ = Vec3::UnitX();
};

}  // namespace nilas::hydro
