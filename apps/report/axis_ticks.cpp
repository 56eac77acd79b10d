#include "apps/report/axis_ticks.h"

#include <cmath>

#include "core/base/error.h"

namespace nilas::report {

double tick_step(double length, int at_most) {
  NILAS_DEMAND(std::isfinite(length) && length > 0 && at_most > 0);
  constexpr double k_rounding = 1e-9;
  const double least = (1 - k_rounding) * length / at_most;
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * decade >= least) return step * decade;
  return 10 * decade;
}

}  // namespace nilas::report
