#pragma once
/// One sea as a scene describes it, and the sinusoidal waves of which it is made.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/choices/wave_choices.h"

namespace nilas::hydro {

/// Depth of water without a bottom [m].
inline constexpr double k_deep_water = std::numeric_limits<double>::infinity();

/// The part of the sea that is covered by ice, and how it weakens waves. Energy falls as exp(-alpha d), so amplitudes
/// fall as exp(-alpha d / 2), with the distance d behind the ice edge, measured across it.
struct IceCover {
  WaveAttenuation model = WaveAttenuation::none;
  double rate = 0;              ///< alpha of model exponential [1/m]
  Vec2 edge = Vec2::Zero();     ///< a point of the straight ice edge, frame G [m]
  Vec2 inward = Vec2::UnitX();  ///< unit vector across the edge, into the ice
  double scale = 1;             ///< lengths of the waters over those for which model meylan was measured [-]

  /// alpha [1/m] for waves of this period [s]. At another scale that of model meylan is the measured one of the waves
  /// of full scale, by Froude's law: alpha(T, scale) = alpha(T / sqrt(scale), 1) / scale.
  double energy_rate(double period) const;
  /// d of a point [m], 0 in front of the edge.
  double distance(const Vec2& point) const { return std::max(0.0, (point - edge).dot(inward)); }
};

/// Waves that belong together.
struct WaveTrain {
  WaveKind kind = WaveKind::regular;
  double height = 0;                ///< from trough to crest; significant for a spectrum [m]
  double period = 1;                ///< of the peak for a spectrum [s]
  double heading = 0;               ///< direction of travel, from X towards Y [rad]
  double phase = 0;                 ///< of a regular wave [rad]
  double gamma = 3.3;               ///< peakedness of JONSWAP [-]
  int components = 1;               ///< number of waves that stand for a spectrum
  double shortest_period = 0;       ///< shorter ones of a spectrum are left out [s]; must be below the period
  std::optional<double> spreading;  ///< s of cos^2s; nothing: all travel in one direction
  double ramp = 0;                  ///< time in which waves rise at the start [s]
  double depth = k_deep_water;      ///< [m]
  IceCover ice;
};

/// One sinusoidal wave. Its elevation at the horizontal position x and time t is
/// Re(a exp(i (w t - k x . direction + phase))), the convention of hydro/database/database.h.
struct WaveComponent {
  double amplitude = 0;  ///< a [m]
  double frequency = 0;  ///< w [rad/s]
  double number = 0;     ///< k [1/m]
  double phase = 0;      ///< [rad]
  double heading = 0;    ///< direction of travel [rad]
  Vec2 direction = Vec2::UnitX();
  double decay = 0;  ///< of the amplitude under ice, alpha / 2 [1/m]
  std::size_t train = 0;
};

/// A density that is tabulated finely, with its integral from the left end.
class TabulatedDensity {
 public:
  TabulatedDensity(double low, double high, const std::function<double(double)>& density);
  double total() const { return sum_.back(); }
  /// The place below which this share of the integral lies.
  double quantile(double share) const;

 private:
  double low_, step_;
  std::vector<double> sum_;
};

/// Unit vector at an angle from X towards Y. Multiples of a right angle are exact, so that a sea along an axis is its
/// own mirror image to the last bit.
Vec2 wave_direction(double heading);

/// The spectral density S(w) of a train of kind jonswap or pierson-moskowitz [m^2 s/rad]. Its integral over the
/// frequencies up to that of the shortest period is height^2 / 16. JONSWAP: S ~ w^-5 exp(-5/4 (w_p/w)^4) gamma^r,
/// r = exp(-(w/w_p - 1)^2 / (2 s^2)), s = 0.07 below w_p and 0.09 above [Hasselmann et al. 1973]; gamma = 1 is
/// Pierson-Moskowitz. The factor follows from numerical integration, not from a fit.
class WaveSpectrum {
 public:
  /// Throws InputError where the shortest period is not below that of the peak.
  explicit WaveSpectrum(const WaveTrain& train);
  double density(double frequency) const;
  /// The frequency below which this share of the energy lies [rad/s].
  double quantile(double share) const;

 private:
  WaveTrain train_;
  double peak_;             ///< w_p [rad/s]
  TabulatedDensity shape_;  ///< over w / w_p
};

/// The waves of a train. A spectrum is cut into `components` bins of equal energy. Each gives one wave, at a random
/// place of the bin's energy, with a random phase, and all have the same amplitude sqrt(2 m0 / components). So m0 is
/// exact and the sea does not repeat. With spreading, each has one direction of the density cos^2s((b - heading) / 2)
/// [Longuet-Higgins et al. 1963]; one direction per frequency keeps the sea free of standing patterns [Jefferys 1987].
/// `stream` names the random numbers. Throws InputError where values contradict each other.
std::vector<WaveComponent> waves_of(const WaveTrain& train, double gravity, std::uint64_t seed,
                                    const std::string& stream);

}  // namespace nilas::hydro
