#include "core/output/loads/ice_load.h"

#include <cmath>

#include "core/output/loads/mean_error.h"

namespace nilas::output {

bool IceLoad::peak_is_impulse_over_step() const {
  constexpr double k_two_steps = 2.5;  // with room for rounding
  constexpr double k_impact = 2;       // a lower peak is part of a lasting load
  const Peak& peak = along.peak;
  return (rigid || elastic) && touched && std::abs(peak.raw) > k_impact * std::abs(along.statistics.mean) &&
         peak.event_to - peak.event_from < k_two_steps * step;
}

bool IceLoad::impacts_dominate() const {
  constexpr double k_third = 1.0 / 3.0;
  constexpr std::size_t k_least_steps = 100;  // with fewer steps, 1 % is less than one step
  return rigid && touched && window.steps() >= k_least_steps && in_largest > k_third;
}

ComponentLoad component_load(const std::vector<double>& part, double t0, double h, double filter, bool ice_broke) {
  ComponentLoad load;
  load.statistics = load_statistics(part);
  load.peak = peak_of(part, t0, h, filter);
  const MeanError error = ice_broke ? slow_mean_error(part) : mean_error(part);
  if (error.freedom > 0) load.half_width = error.half_width();
  load.halves = half_means(part, ice_broke);
  return load;
}

}  // namespace nilas::output
