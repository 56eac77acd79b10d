#pragma once
/// The wind over the water: its mean over height, and gusts.
///
/// The mean speed U(z) at the height z above still water follows from U0, that at 10 m:
///   uniform:  U = U0;
///   power:    U = U0 (z / 10 m)^a;
///   log:      U = U0 (1 + C ln(z / 10 m)), C = 0.0573 sqrt(1 + 0.15 U0 s/m)   [ISO 19901-1:2015, annex A].
/// Gusts have the spectrum of ISO 19901-1 (the NPD spectrum, of measurements at Froya), one-sided in the frequency f:
///   S(f) = 320 m^2/s (U0 / 10 m/s)^2 / (1 + F^n)^(5 / (3 n)),  F = 172 f s (U0 / 10 m/s)^(-0.75),  n = 0.468,
/// at the height of 10 m, valid for 1/600 Hz <= f <= 0.5 Hz. Their series is a sum of cosines: one per band of
/// frequencies, with the energy of the band, and with a random frequency in the band and a random phase. So its
/// variance over a long time is the integral of S, and it does not repeat.
#include <cstdint>
#include <vector>

#include "core/base/math.h"
#include "core/choices/wind_choices.h"

namespace nilas::hydro {

/// The height to which the speed of the wind refers [m]; in a scaled scene times its scale.
inline constexpr double k_wind_height = 10;

/// S(f) above [m^2/s], of the frequency [Hz] and the mean speed at 10 m [m/s].
double npd_spectrum(double frequency, double speed);

/// A series of gusts along the wind. It is a function of time, so it has no state.
class Gusts {
 public:
  /// The steady wind.
  Gusts() = default;
  /// `speed`: the mean at 10 m [m/s], at least 0; `seed`: that of the scene.
  Gusts(double speed, std::uint64_t seed);
  /// What the gust adds to the mean speed [m/s] at the time t [s].
  double at(double t) const;
  /// The variance over a long time [m^2/s^2].
  double variance() const;

 private:
  struct Wave {
    double amplitude, frequency, phase;  ///< [m/s, rad/s, rad]
  };
  std::vector<Wave> waves_;
};

struct WindSettings {
  double speed = 0;                              ///< U0 [m/s]
  double direction = 0;                          ///< towards which the wind blows, from X towards Y [rad]
  double density = defaults::k_air_density;      ///< of the air [kg/m^3]
  double exponent = defaults::k_wind_exponent;   ///< a
  double floe_drag = defaults::k_floe_air_drag;  ///< the drag coefficient of floes, by the wind at 10 m; 0: the wind
                                                 ///< does not act on floes
  WindProfileKind profile = WindProfileKind::uniform;
  GustSpectrum gusts = GustSpectrum::none;
  /// The scale of the scene. Profile and gusts are those of the scene before it was scaled, at heights over the scale,
  /// and at times and speeds over its root, as Froude's law has it.
  double scale = 1;
};

class Wind {
 public:
  Wind(const WindSettings& settings, std::uint64_t seed);
  /// The velocity of the air at a height above still water [m] and a time [s], in G. It is zero below the water where
  /// the mean depends on the height. Gusts are the same at every height.
  Vec3 velocity(double height, double t) const;
  /// The same at the height of 10 m.
  Vec3 reference_velocity(double t) const { return velocity(k_wind_height * settings_.scale, t); }
  /// The mean speed at a height [m/s].
  double mean_speed(double height) const;

 private:
  WindSettings settings_;
  double root_;  ///< of the scale
  Vec3 along_;
  Gusts gusts_;
};

}  // namespace nilas::hydro
