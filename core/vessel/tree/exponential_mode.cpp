#include "core/vessel/tree/exponential_mode.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace nilas::vessel {

namespace {

/// (1 - exp(-z)) / z for z > 0.
double mean_decay(double z) { return -std::expm1(-z) / z; }

ExponentialMode oscillating(double a, double ratio) {
  // |1 - exp(-z)|^2 as a sum of squares: no cancellation, however small a is.
  const double fall = std::exp(-ratio * a);
  const double turn = std::sin(0.5 * a * std::sqrt((1 - ratio) * (1 + ratio)));
  const double across = std::expm1(-ratio * a) / a, along = 2 * turn / a;
  return {fall * fall, across * across + fall * along * along};
}

ExponentialMode creeping(double a, double ratio) {
  const double fast = a * (ratio + std::sqrt((ratio - 1) * (ratio + 1)));
  const double slow = a * (a / fast);
  return {std::exp(-2 * ratio * a), mean_decay(fast) * mean_decay(slow)};
}

}  // namespace

double least_damping_ratio(double a) {
  constexpr double k_four_steps_per_period = 0.5 * k_pi;
  const double share = std::clamp((a - k_four_steps_per_period) / k_four_steps_per_period, 0.0, 1.0);
  return share * share;
}

ExponentialMode exponential_mode(double omega, double damping_time, double h) {
  const double a = omega * h;
  if (a == 0) return {};
  const double ratio = std::max(0.5 * damping_time * omega, least_damping_ratio(a));
  return ratio < 1 ? oscillating(a, ratio) : creeping(a, ratio);
}

}  // namespace nilas::vessel
