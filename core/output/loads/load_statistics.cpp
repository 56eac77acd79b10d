#include "core/output/loads/load_statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nilas {

namespace {

constexpr double k_percentile = 0.99;

double percentile(std::vector<double> x, double share) {
  const double place = share * static_cast<double>(x.size() - 1);
  const auto lower = static_cast<std::ptrdiff_t>(place);
  std::nth_element(x.begin(), x.begin() + lower, x.end());
  const double below = x[static_cast<std::size_t>(lower)];
  if (lower + 1 == static_cast<std::ptrdiff_t>(x.size())) return below;
  const double above = *std::min_element(x.begin() + lower + 1, x.end());
  return below + (place - static_cast<double>(lower)) * (above - below);
}

}  // namespace

LoadStatistics load_statistics(const std::vector<double>& series) {
  if (series.empty()) return {};
  const auto n = static_cast<double>(series.size());
  LoadStatistics result;
  result.mean = std::accumulate(series.begin(), series.end(), 0.0) / n;
  double squares = 0;
  for (const double x : series) squares += (x - result.mean) * (x - result.mean);
  result.std = std::sqrt(squares / n);
  std::vector<double> absolute(series.size());
  std::transform(series.begin(), series.end(), absolute.begin(), [](double x) { return std::abs(x); });
  result.max = *std::max_element(absolute.begin(), absolute.end());
  result.p99 = percentile(std::move(absolute), k_percentile);
  return result;
}

}  // namespace nilas
