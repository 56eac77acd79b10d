#pragma once
/// The waves of a scene as viewers draw them.
#include <vector>

#include "core/base/math.h"

namespace nilas::bodies {

/// One wave. Its elevation at the horizontal position x and time t is a cos(w t - number . x + phase), times the share
/// of its sea, times exp(-decay d) at the distance d behind the ice edge.
struct DrawnWave {
  double amplitude = 0;         ///< a [m]
  double frequency = 0;         ///< w [rad/s]
  Vec2 number = Vec2::Zero();   ///< [1/m]
  double phase = 0, decay = 0;  ///< [rad], [1/m]
};

/// Waves that begin together and meet the same straight ice edge.
struct DrawnSea {
  double start = 0, ramp = 0;   ///< from when on, and for how long, they rise [s]
  Vec2 edge = Vec2::Zero();     ///< a point of the ice edge [m]
  Vec2 inward = Vec2::UnitX();  ///< unit vector across it, into the ice
  std::vector<DrawnWave> waves;
};

}  // namespace nilas::bodies
