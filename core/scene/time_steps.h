#pragma once
/// Number of steps of a run.
#include "core/scene/scene.h"

namespace nilas::scene {

/// Number of equal steps until one reaches the end of the run; the last may exceed it.
long number_of_steps(const TimeScene& time);

}  // namespace nilas::scene
