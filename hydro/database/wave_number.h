#pragma once
/// Dispersion of water waves.
#include <cmath>
#include <optional>

namespace nilas::hydro {

/// The wave number k of w^2 = g k tanh(k h) [1/m], to rounding; w >= 0 [rad/s], g [m/s^2], depth h [m], infinite where
/// there is none. Newton's method on x tanh(x) = y from x = y / sqrt(tanh(y)), which is within 8 % of the root
/// [Eckart 1952].
inline double wave_number(double frequency, double gravity, const std::optional<double>& depth) {
  const double deep = frequency * frequency / gravity;
  if (!depth || frequency == 0) return deep;
  const double y = deep * *depth;
  double x = y / std::sqrt(std::tanh(y));
  constexpr int k_iterations = 20;  // convergence is quadratic; five are enough
  constexpr double k_converged = 1e-15;
  for (int n = 0; n < k_iterations; ++n) {
    const double t = std::tanh(x), step = (x * t - y) / (t + x * (1 - t * t));
    x -= step;
    if (std::abs(step) <= k_converged * x) break;
  }
  return x / *depth;
}

/// The group velocity dw/dk of these waves [m/s]; w > 0.
inline double group_velocity(double frequency, double gravity, const std::optional<double>& depth) {
  const double k = wave_number(frequency, gravity, depth), phase_velocity = frequency / k;
  if (!depth) return 0.5 * phase_velocity;
  const double twice = 2 * k * *depth;
  // sinh overflows where the water is deep to all digits.
  constexpr double k_deep = 700;
  return 0.5 * phase_velocity * (1 + (twice < k_deep ? twice / std::sinh(twice) : 0));
}

}  // namespace nilas::hydro
