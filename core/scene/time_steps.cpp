#include "core/scene/time_steps.h"

#include <cmath>

namespace nilas::scene {

long number_of_steps(const TimeScene& time) {
  constexpr double k_rounding = 1e-9;  // share of a step: 60 s are 6000 steps of 0.01 s, not 6001
  return std::lround(std::ceil((time.end - time.start) / time.step - k_rounding));
}

}  // namespace nilas::scene
