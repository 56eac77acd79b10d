#include "apps/report/figures/exceedance.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace nilas::report {

namespace {

constexpr double k_whole = 100;  // [%]

/// Ranks from 1 to n, each of the first and then ever fewer, at most `most` of them.
std::vector<std::size_t> thinned_ranks(std::size_t n, std::size_t most) {
  std::vector<std::size_t> ranks;
  if (n == 0) return ranks;
  if (n <= most) {
    for (std::size_t k = 1; k <= n; ++k) ranks.push_back(k);
    return ranks;
  }
  const double ratio = std::pow(static_cast<double>(n), 1 / static_cast<double>(most - 1));
  double at = 1;
  for (std::size_t j = 0; j < most; ++j, at *= ratio) {
    const auto rank = std::min(n, static_cast<std::size_t>(std::lround(at)));
    if (ranks.empty() || rank > ranks.back()) ranks.push_back(rank);
  }
  if (ranks.back() != n) ranks.push_back(n);
  return ranks;
}

/// The values from the largest down, without those that are not finite.
void sort_down(std::vector<double>& values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  std::sort(values.begin(), values.end(), std::greater<>());
}

}  // namespace

Curve step_exceedance(const std::string& name, std::vector<double> loads, double factor, std::size_t most) {
  sort_down(loads);
  Curve curve{.name = name};
  const auto n = static_cast<double>(loads.size());
  for (std::size_t rank : thinned_ranks(loads.size(), most)) {
    while (rank < loads.size() && loads[rank] == loads[rank - 1]) ++rank;  // equal loads are one level
    if (!curve.x.empty() && factor * loads[rank - 1] == curve.x.back()) continue;
    curve.x.push_back(factor * loads[rank - 1]);
    curve.y.push_back(k_whole * static_cast<double>(rank) / n);
  }
  return curve;
}

std::vector<double> local_peaks(const std::vector<double>& loads, double level) {
  std::vector<double> peaks;
  bool above = false;
  for (const double load : loads) {
    if (load > level && !above) peaks.push_back(load);
    if (load > level && above) peaks.back() = std::max(peaks.back(), load);
    above = load > level;
  }
  return peaks;
}

Curve peak_exceedance(const std::string& name, std::vector<double> peaks, double factor, std::size_t most) {
  sort_down(peaks);
  Curve curve{.name = name, .is_dots = true};
  for (const std::size_t rank : thinned_ranks(peaks.size(), most)) {
    curve.x.push_back(factor * peaks[rank - 1]);
    curve.y.push_back(k_whole * static_cast<double>(rank) / static_cast<double>(peaks.size() + 1));
  }
  return curve;
}

}  // namespace nilas::report
