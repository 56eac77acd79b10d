#pragma once
/// Choices of <radiation>.
#include "core/choices/choice.h"

namespace nilas {

/// The form of the memory of radiated waves.
enum class RadiationModel { state_space, convolution };
constexpr ChoiceText choice_text(RadiationModel value) {
  switch (value) {
    case RadiationModel::state_space:
      return {"state-space", "A passive linear system is fitted to the damping. It never gives energy."};
    case RadiationModel::convolution:
      return {"convolution", "The retardation functions are integrated over past motion."};
  }
  return {};
}

}  // namespace nilas
