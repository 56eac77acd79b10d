#pragma once
/// Values of <waves> and <wave_loads>.
#include <optional>

#include "core/base/math.h"
#include "core/choices/wave_choices.h"

namespace nilas::scene {

struct WaveScene {
  WaveKind kind = WaveKind::regular;
  double height = 0, period = 0;  ///< [m], [s]
  double heading_deg = 0;
  double phase_deg = 0;                   ///< of a regular wave
  double gamma = 3.3;                     ///< peakedness of JONSWAP
  int components = 50;                    ///< waves that stand for a spectrum
  std::optional<double> shortest_period;  ///< [s]; default: a quarter of the period
  std::optional<double> spreading;        ///< s of cos^2s; nothing: one direction
  double ramp = 0;                        ///< [s]
  std::optional<double> depth;            ///< [m]; default: that of the tank, else infinite
  WaveAttenuation attenuation = WaveAttenuation::none;
  double attenuation_rate = 1e-4;      ///< of the energy [1/m]
  std::optional<Vec2> ice_edge;        ///< a point of the ice edge [m]
  std::optional<double> ice_edge_deg;  ///< direction across the edge into the ice; default: heading_deg
  int line = 0;

  /// The shortest period of the components of a spectrum [s].
  double shortest() const {
    constexpr double k_share = 0.25;  // Pierson-Moskowitz has 0.5 % of its energy at shorter periods
    return shortest_period.value_or(k_share * period);
  }

  bool operator==(const WaveScene&) const = default;
};

struct WaveLoadsScene {
  VesselWaveLoads vessel = VesselWaveLoads::froude_krylov;
  VesselDiffraction diffraction = VesselDiffraction::none;
  FloeWaveLoads floes = FloeWaveLoads::froude_krylov;
  WaveDrift drift = WaveDrift::none;

  bool operator==(const WaveLoadsScene&) const = default;
};

}  // namespace nilas::scene
