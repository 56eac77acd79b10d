#pragma once
/// The control law of dynamic positioning.
#include "core/base/math.h"
#include "core/base/state.h"
#include "core/vessel/control/observer.h"
#include "core/vessel/control/reference_filter.h"

namespace nilas::vessel {

struct ControllerSettings {
  Vec3 mass = Vec3::Ones();       ///< with added mass: surge, sway [kg], yaw [kg m^2]
  Vec3 damping = Vec3::Zero();    ///< linear: surge, sway [N s/m], yaw [N m s]
  Vec3 bandwidth = Vec3::Ones();  ///< w of the closed loop [rad/s]
  double damping_ratio = 1;       ///< zeta of the closed loop
};

/// PID by pole placement [Fossen 2011, algorithm 12.1], per axis of the vessel:
///   K_p = w^2 M,  K_d = 2 zeta w M - D,  K_i = w K_p / 10,
///   load = M a_d + D nu_d - K_p e - K_d (nu - nu_d) - R^T q,   e = R^T (eta - eta_d),
///   q' = R (K_i e + w s),
/// with the reference's velocity nu_d and acceleration a_d, and the shortfall s of the thrust allocation: where
/// thrusters are saturated, w s takes back the integral (back-calculation, Aastroem and Haegglund 1995). Without
/// saturation and integral the poles are those of s^2 + 2 zeta w s + w^2; with it those of s^3 + 2 zeta w s^2 + w^2 s +
/// w^3 / 10.
class PositionController {
 public:
  explicit PositionController(const ControllerSettings& settings);

  Vec3 proportional() const { return proportional_; }  ///< K_p [N/m, N m]
  Vec3 derivative() const { return derivative_; }      ///< K_d [N s/m, N m s]
  Vec3 integral() const { return integral_; }          ///< K_i [N/(m s), N m/s]

  /// The wanted load in the vessel's axes [N, N m]. `known`: a known load on the vessel, such as wind, which the
  /// thrusters cancel.
  Vec3 load(const PassiveObserver& estimate, const ReferenceFilter& reference, const Vec3& known = Vec3::Zero()) const;
  /// Advances the integral by h [s]. `shortfall`: wanted load minus allocated load, the vessel's axes.
  void integrate(const PassiveObserver& estimate, const ReferenceFilter& reference, const Vec3& shortfall, double h);

  void save(StateWriter out) const { out.add("integral", sum_); }
  void restore(const StateReader& in) { in.get("integral", sum_); }

 private:
  ControllerSettings settings_;
  Vec3 proportional_, derivative_, integral_;
  Vec3 sum_ = Vec3::Zero();  ///< q, frame G [N, N m]
};

}  // namespace nilas::vessel
