#include "core/vessel/thrusters/actuator.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace nilas::vessel {

double follow_command(double x, double command, double lag, double rate, double h) {
  if (h == 0) return x;                               // an infinite rate would have no product with it
  const double gap = command - x, near = rate * lag;  // within `near` the exponential is slower than the rate
  if (lag == 0) return std::abs(gap) <= rate * h ? command : x + std::copysign(rate * h, gap);
  if (std::abs(gap) <= near) return command - gap * std::exp(-h / lag);
  const double ramp = (std::abs(gap) - near) / rate;  // time until then [s]
  if (h <= ramp) return x + std::copysign(rate * h, gap);
  return command - std::copysign(near * std::exp(-(h - ramp) / lag), gap);
}

double wrapped(double angle) {
  const double rest = std::remainder(angle, 2 * k_pi);
  return rest <= -k_pi ? rest + 2 * k_pi : rest;
}

double turn_towards(double angle, double command, double rate, double h) {
  if (h == 0) return angle;
  const double gap = wrapped(command - angle);
  return wrapped(std::abs(gap) <= rate * h ? command : angle + std::copysign(rate * h, gap));
}

}  // namespace nilas::vessel
