#pragma once
/// The observer of dynamic positioning: it estimates position, velocity and slow loads from noisy measurements.
#include <optional>

#include "core/base/math.h"
#include "core/base/state.h"

namespace nilas::vessel {

/// Rotation from the vessel's horizontal axes to G, and heading to itself.
Mat3 plane_rotation(double heading);

struct ObserverSettings {
  Vec3 mass = Vec3::Ones();           ///< with added mass: surge, sway [kg], yaw [kg m^2]
  Vec3 damping = Vec3::Zero();        ///< linear: surge, sway [N s/m], yaw [N m s]
  Vec3 bandwidth = Vec3::Ones();      ///< w of the estimate's poles [rad/s]
  std::optional<double> wave_period;  ///< peak period of the wave filter [s]; empty: no filter
};

/// The nonlinear passive observer of Fossen and Strand (1999), in the form for sampled measurements. Between samples
///   eta' = R(psi) nu,   M nu' = -D nu + R^T b + tau,   b' = 0,   xi'' = -w_o^2 xi - 2 zeta w_o xi'
/// with the loads tau of the thrusters and the bias b of all others. A sample y corrects by the innovation
/// y - eta - xi', in the vessel's axes: eta by L1, nu by L2, b by M L3, and xi by the gains of its source (zeta 0.1,
/// notch 1). L1, L2, L3 place the poles of a double integrator with bias exactly, whatever the time T between samples:
/// without a wave filter at exp(-w T) three times (in continuous time K2 = 3 w, K4 = 3 w^2 M, K3 = w^3 M), with it at
/// exp(-w T) twice and at exp(-1.22 w_o T), so that the cut-off lies above the waves as passivity demands.
class PassiveObserver {
 public:
  /// `position`: x, y [m], heading [rad] at the start; `velocity`: surge, sway [m/s], yaw rate [rad/s].
  PassiveObserver(const ObserverSettings& settings, const Vec3& position, const Vec3& velocity);

  /// Largest magnitude of the poles of the error for samples every `period` [s] with M nu' = tau + R^T b and a constant
  /// heading: below 1 the estimate converges.
  double spectral_radius(double period) const;

  /// Goes on by h [s] under the thrusters' load in the vessel's axes [N, N m].
  void predict(const Vec3& load, double h);
  /// Takes a measurement of x, y and heading, `period` after the last one. Headings may differ by full turns.
  void correct(const Vec3& measured, double period);

  const Vec3& position() const { return position_; }
  const Vec3& velocity() const { return velocity_; }
  const Vec3& bias() const { return bias_; }  ///< frame G [N, N m]

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  struct Gains {
    double position, velocity, bias;  ///< L1 [-], L2 [1/s], L3 [1/s^2]
    double wave, wave_rate;           ///< of xi [s], of xi' [-]
  };
  Gains gains(int axis, double period) const;
  /// Transition of (xi, xi') over h [s].
  Eigen::Matrix2d wave_transition(double h) const;

  ObserverSettings settings_;
  Vec3 position_, velocity_;
  Vec3 bias_ = Vec3::Zero();
  Vec3 wave_ = Vec3::Zero(), wave_rate_ = Vec3::Zero();  ///< xi [m s, rad s], xi' [m, rad]
};

}  // namespace nilas::vessel
