#include "hydro/manoeuvring/imo_criteria.h"

#include <algorithm>
#include <cmath>

namespace nilas::hydro {

std::optional<double> imo_overshoot(double rudder_deg, double heading_deg, int index, double length_over_speed) {
  constexpr double k_fast = 10, k_slow = 30;  // L/V between which the limits rise [s]
  constexpr double k_same = 1e-6;             // angles of a scene that differ by rounding only [deg]
  const auto is = [&](double angle) {
    return std::abs(std::abs(rudder_deg) - angle) < k_same && std::abs(heading_deg - angle) < k_same;
  };
  const double t = std::clamp(length_over_speed, k_fast, k_slow);
  if (is(10) && index == 1) return 5 + 0.5 * t;
  if (is(10) && index == 2) return 17.5 + 0.75 * t;
  if (is(20) && index == 1) return 25;
  return std::nullopt;
}

}  // namespace nilas::hydro
