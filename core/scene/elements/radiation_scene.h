#pragma once
/// Values of <radiation>.
#include <optional>

#include "core/choices/radiation_choices.h"

namespace nilas::scene {

struct RadiationScene {
  RadiationModel model = RadiationModel::state_space;
  double error = 0.01;                      ///< of the state space, as a share
  std::optional<int> order;                 ///< poles of each group of coupled modes
  std::optional<double> memory;             ///< of the convolution [s]
  std::optional<double> highest_frequency;  ///< [rad/s]

  bool operator==(const RadiationScene&) const = default;
};

}  // namespace nilas::scene
