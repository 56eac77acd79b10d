#pragma once
/// The effect of a time step on simple motions. The discrete closed forms of the cases are built from it.
#include <algorithm>

#include "core/base/math.h"

namespace nilas::verify {

/// Returns the displacement [m] after n steps of a body whose velocity [m/s] is velocity(0) at the start and
/// velocity(k) at the end of step k.
template <class Velocity>
auto travel(long n, double h, double theta, const Velocity& velocity) {
  auto distance = velocity(0L);
  distance *= 0;
  for (long k = 1; k <= n; ++k) distance += h * ((1 - theta) * velocity(k - 1) + theta * velocity(k));
  return distance;
}

/// Returns the distance [m] until a body stands still that loses `change` [m/s] of its speed per step.
inline double stopping_distance(double speed, double change, double h, double theta) {
  double distance = 0;
  while (speed > 0) {
    const double after = std::max(0.0, speed - change);
    distance += h * ((1 - theta) * speed + theta * after);
    speed = after;
  }
  return distance;
}

}  // namespace nilas::verify
