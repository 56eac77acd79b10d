#pragma once
/// Steps of a run.
#include "core/scene/scene.h"

namespace nilas {

/// Steps of equal length until one reaches the end of the run; the last may go past it.
long number_of_steps(const TimeScene& time);

}  // namespace nilas
