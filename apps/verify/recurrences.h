#pragma once
/// What a time step does to simple motions, from which the discrete closed forms are put together.
#include <algorithm>

#include "core/base/math.h"

namespace nilas {

/// Way after n steps of a body with the velocities velocity(0), velocity(1) ... at the steps' ends.
template <class Velocity>
auto travel(long n, double h, double theta, const Velocity& velocity) {
  auto way = velocity(0L);
  way *= 0;
  for (long k = 1; k <= n; ++k) way += h * ((1 - theta) * velocity(k - 1) + theta * velocity(k));
  return way;
}

/// Way of a body that something slows down by `change` per step until it stands still.
inline double stopping_way(double speed, double change, double h, double theta) {
  double way = 0;
  while (speed > 0) {
    const double after = std::max(0.0, speed - change);
    way += h * ((1 - theta) * speed + theta * after);
    speed = after;
  }
  return way;
}

}  // namespace nilas
