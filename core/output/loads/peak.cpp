#include "core/output/loads/peak.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace nilas::output {

namespace {

/// Time integral, from the series' begin, of a load that is constant within steps.
class Impulse {
 public:
  Impulse(const std::vector<double>& series, double h) : h_(h) {
    sums_.reserve(series.size() + 1);
    sums_.push_back(0);
    for (const double x : series) sums_.push_back(sums_.back() + h * x);
  }
  double at(double t) const {
    const double place = std::clamp(t / h_, 0.0, static_cast<double>(sums_.size() - 1));
    const auto k = std::min(static_cast<std::size_t>(place), sums_.size() - 2);
    return sums_[k] + (place - static_cast<double>(k)) * (sums_[k + 1] - sums_[k]);
  }

 private:
  double h_;
  std::vector<double> sums_;
};

/// Finds the largest mean over the filter time. It occurs for an interval that begins or ends with a step.
void find_filtered(const std::vector<double>& series, double t0, double h, Peak& peak) {
  const Impulse impulse(series, h);
  const double duration = static_cast<double>(series.size()) * h;
  const double width = peak.filter;
  const auto offer = [&](double end) {
    constexpr double k_slack = 1e-9;
    if (end < width * (1 - k_slack) || end > duration * (1 + k_slack)) return;
    const double mean = (impulse.at(end) - impulse.at(end - width)) / width;
    if (std::abs(mean) <= std::abs(peak.filtered)) return;
    peak.filtered = mean;
    peak.filtered_time = t0 + end;
  };
  for (std::size_t k = 0; k <= series.size(); ++k) {
    offer(static_cast<double>(k) * h);
    offer(static_cast<double>(k) * h + width);
  }
}

void find_event(const std::vector<double>& series, double t0, double h, std::size_t top, Peak& peak) {
  const double mean = std::accumulate(series.begin(), series.end(), 0.0) / static_cast<double>(series.size());
  const double side = peak.raw < 0 ? -1 : 1;
  constexpr double k_tenth = 0.1;
  const double from = std::max(0.0, side * mean + k_tenth * side * (peak.raw - mean));
  const auto beyond = [&](std::size_t k) { return side * series[k] > from; };
  std::size_t first = top, last = top + 1;
  while (first > 0 && beyond(first - 1)) --first;
  while (last < series.size() && beyond(last)) ++last;
  peak.event_from = t0 + static_cast<double>(first) * h;
  peak.event_to = t0 + static_cast<double>(last) * h;
  for (std::size_t k = first; k < last; ++k) peak.event_impulse += h * series[k];
}

}  // namespace

Peak peak_of(const std::vector<double>& series, double t0, double h, double filter) {
  Peak peak;
  if (series.empty()) return peak;
  peak.filter = std::clamp(filter, h, std::max(h, static_cast<double>(series.size()) * h));
  const auto top =
      std::max_element(series.begin(), series.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      series.begin();
  peak.raw = series[top];
  if (peak.raw == 0) return peak;
  peak.raw_time = t0 + static_cast<double>(top + 1) * h;
  find_filtered(series, t0, h, peak);
  find_event(series, t0, h, static_cast<std::size_t>(top), peak);
  return peak;
}

double default_peak_filter(double length) {
  constexpr double k_time = 0.2, k_length = 100;  // [s], [m]
  return k_time * std::sqrt(length / k_length);
}

double share_of_largest_percent(const std::vector<double>& series) {
  constexpr std::size_t k_hundred = 100;
  std::vector<double> sizes(series.size());
  std::transform(series.begin(), series.end(), sizes.begin(), [](double x) { return std::abs(x); });
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  const double all = std::accumulate(sizes.begin(), sizes.end(), 0.0);
  if (!(all > 0)) return 0;
  const auto count = static_cast<std::ptrdiff_t>((sizes.size() + k_hundred - 1) / k_hundred);
  return std::accumulate(sizes.begin(), sizes.begin() + count, 0.0) / all;
}

}  // namespace nilas::output
