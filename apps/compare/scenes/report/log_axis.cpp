#include "apps/compare/scenes/report/log_axis.h"

#include <cmath>

namespace nilas::compare {

double LogAxis::share(double value) const { return std::log(value / low) / std::log(high / low); }

double LogAxis::at_share(double share) const { return low * std::pow(high / low, share); }

LogAxis log_axis(const Extent& extent) {
  LogAxis axis{extent.low / k_axis_room, extent.high * k_axis_room, {}};
  const int first = static_cast<int>(std::floor(std::log10(axis.low))),
            last = static_cast<int>(std::ceil(std::log10(axis.high)));
  constexpr double k_few = 1e3;
  for (int decade = first; decade <= last; ++decade)
    for (const int digit : axis.high > k_few * axis.low ? std::vector{1} : std::vector{1, 2, 5})
      axis.tics.push_back(digit * std::pow(10.0, decade));
  return axis;
}

}  // namespace nilas::compare
