#include "core/output/loads/half_means.h"

#include <algorithm>
#include <cmath>

#include "core/output/loads/load_statistics.h"
#include "core/output/loads/mean_error.h"

namespace nilas::output {

namespace {

std::optional<HalfMean> half_mean(const std::vector<double>& half, bool ice_broke) {
  const MeanError error = ice_broke ? slow_mean_error(half) : mean_error(half);
  if (error.freedom == 0) return std::nullopt;
  return HalfMean{load_statistics(half).mean, error.half_width()};
}

}  // namespace

bool HalfMeans::differ() const {
  constexpr double k_matters = 0.01;  // a load that changes by less counts as steady, and so does one that is rounded
  const double change = std::abs(second.mean - first.mean);
  return change > first.half_width + second.half_width &&
         change > k_matters * std::max(std::abs(first.mean), std::abs(second.mean));
}

std::optional<HalfMeans> half_means(const std::vector<double>& series, bool ice_broke) {
  const auto middle = series.begin() + static_cast<std::ptrdiff_t>(series.size() / 2);
  const auto first = half_mean({series.begin(), middle}, ice_broke);
  const auto second = half_mean({middle, series.end()}, ice_broke);
  if (!first || !second) return std::nullopt;
  return HalfMeans{*first, *second};
}

}  // namespace nilas::output
