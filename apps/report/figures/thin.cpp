#include "apps/report/figures/thin.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nilas::report {

namespace {

/// Mean and range of the finite values of a stretch.
struct Stretch {
  double sum = 0, low = std::numeric_limits<double>::infinity(), high = -low;
  std::size_t count = 0;
  void add(double value) {
    if (!std::isfinite(value)) return;
    sum += value;
    low = std::min(low, value);
    high = std::max(high, value);
    ++count;
  }
};

}  // namespace

Curve thinned(const std::string& name, const std::vector<double>& x, const std::vector<double>& y, double factor,
              std::size_t most) {
  Curve curve{.name = name};
  const std::size_t size = std::min(x.size(), y.size()), points = std::min(size, most);
  constexpr double k_none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t p = 0; p < points; ++p) {
    const std::size_t begin = p * size / points, end = (p + 1) * size / points;
    Stretch stretch;
    for (std::size_t k = begin; k < end; ++k) stretch.add(factor * y[k]);
    const bool any = stretch.count > 0;
    curve.x.push_back(x[end - 1]);
    curve.y.push_back(any ? stretch.sum / static_cast<double>(stretch.count) : k_none);
    if (size <= most) continue;
    curve.low.push_back(any ? stretch.low : k_none);
    curve.high.push_back(any ? stretch.high : k_none);
  }
  return curve;
}

}  // namespace nilas::report
