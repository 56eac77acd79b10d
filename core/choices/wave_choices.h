#pragma once
/// Choices of <waves> and <wave_loads>.
#include "core/choices/choice.h"

namespace nilas {

/// The spectrum of waves.
enum class WaveKind { regular, jonswap, pierson_moskowitz };
constexpr ChoiceText choice_text(WaveKind value) {
  switch (value) {
    case WaveKind::regular:
      return {"regular", "There is one wave."};
    case WaveKind::jonswap:
      return {"jonswap", "The spectrum is that of a growing sea (Hasselmann et al. 1973)."};
    case WaveKind::pierson_moskowitz:
      return {"pierson-moskowitz", "The spectrum is that of a fully developed sea (Pierson and Moskowitz 1964)."};
  }
  return {};
}

/// How waves decay under ice.
enum class WaveAttenuation { none, exponential, meylan };
constexpr ChoiceText choice_text(WaveAttenuation value) {
  switch (value) {
    case WaveAttenuation::none:
      return {"none", "The ice does not weaken the waves."};
    case WaveAttenuation::exponential:
      return {"exponential", "The energy falls by one rate per metre, the same for all periods (Wadhams et al. 1988)."};
    case WaveAttenuation::meylan:
      return {"meylan",
              "The rate of the energy is 2.12e-3 / T^2 + 4.59e-2 / T^4 per metre for the period T in s, as measured in "
              "Antarctic floes (Meylan, Bennetts and Kohout 2014)."};
  }
  return {};
}

/// Loads of waves on the vessel.
enum class VesselWaveLoads { none, database, froude_krylov };
constexpr ChoiceText choice_text(VesselWaveLoads value) {
  switch (value) {
    case VesselWaveLoads::none:
      return {"none", "Waves act on the vessel only through drag."};
    case VesselWaveLoads::database:
      return {"database", "The first-order excitation of `<database>` acts, for the present heading of the waves."};
    case VesselWaveLoads::froude_krylov:
      return {"froude-krylov", "The pressure of the undisturbed waves acts on the hull up to their actual surface."};
  }
  return {};
}

/// The diffracted waves, beside Froude-Krylov loads on the vessel.
enum class VesselDiffraction { none, database };
constexpr ChoiceText choice_text(VesselDiffraction value) {
  switch (value) {
    case VesselDiffraction::none:
      return {"none", "The hull does not disturb the waves."};
    case VesselDiffraction::database:
      return {"database",
              "The excitation of `<database>` acts, less the linear Froude-Krylov load on the hull as it starts, so "
              "that nothing counts twice."};
  }
  return {};
}

/// Loads of waves on floes and free bodies.
enum class FloeWaveLoads { none, froude_krylov };
constexpr ChoiceText choice_text(FloeWaveLoads value) {
  switch (value) {
    case FloeWaveLoads::none:
      return {"none", "Waves act on floes only through drag."};
    case FloeWaveLoads::froude_krylov:
      return {"froude-krylov", "The pressure of the undisturbed waves acts on floes up to their actual surface."};
  }
  return {};
}

/// Second-order loads of waves on the vessel.
enum class WaveDrift { none, mean, newman };
constexpr ChoiceText choice_text(WaveDrift value) {
  switch (value) {
    case WaveDrift::none:
      return {"none", "Waves do not push the vessel on average."};
    case WaveDrift::mean:
      return {"mean", "The mean drift load of all components acts."};
    case WaveDrift::newman:
      return {"newman", "Slow drift acts too, by Newman's approximation (1974)."};
  }
  return {};
}

}  // namespace nilas
