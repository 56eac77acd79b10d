#include "core/base/statistics.h"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <limits>
#include <numeric>

#include "core/base/error.h"

namespace nilas {

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double squares_about(const std::vector<double>& values, double mean) {
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return squares;
}

double variance_of(const std::vector<double>& values) {
  if (values.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  return squares_about(values, mean_of(values)) / static_cast<double>(values.size() - 1);
}

double median_of(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double percentile_of(std::vector<double> values, double share) {
  NILAS_DEMAND(!values.empty() && share >= 0 && share <= 1);
  const double place = share * static_cast<double>(values.size() - 1);
  const auto lower = static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), values.begin() + lower, values.end());
  const double below = values[lower];
  if (lower + 1 == static_cast<std::ptrdiff_t>(values.size())) return below;
  const double above = *std::min_element(values.begin() + lower + 1, values.end());
  return below + (place - static_cast<double>(lower)) * (above - below);
}

double student_95(double degrees) {
  constexpr double k_upper = 0.975;
  if (!(degrees > 0)) return std::numeric_limits<double>::infinity();
  return boost::math::quantile(boost::math::students_t(degrees), k_upper);
}

double fisher_95(double degrees, double degrees_below) {
  constexpr double k_upper = 0.95;
  if (!(degrees > 0) || !(degrees_below > 0)) return std::numeric_limits<double>::infinity();
  return boost::math::quantile(boost::math::fisher_f(degrees, degrees_below), k_upper);
}

}  // namespace nilas
