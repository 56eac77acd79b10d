#include "core/output/loads/load_statistics.h"

#include <algorithm>
#include <cmath>

#include "core/base/statistics.h"

namespace nilas::output {

LoadStatistics load_statistics(const std::vector<double>& series) {
  if (series.empty()) return {};
  constexpr double k_percentile = 0.99;
  LoadStatistics result;
  result.mean = mean_of(series);
  result.std = std::sqrt(squares_about(series, result.mean) / static_cast<double>(series.size()));
  std::vector<double> absolute(series.size());
  std::transform(series.begin(), series.end(), absolute.begin(), [](double x) { return std::abs(x); });
  result.max = *std::max_element(absolute.begin(), absolute.end());
  result.p99 = percentile_of(std::move(absolute), k_percentile);
  return result;
}

}  // namespace nilas::output
