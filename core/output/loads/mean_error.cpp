#include "core/output/loads/mean_error.h"

#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/statistics.h"

namespace nilas::output {

namespace {

/// Means of `count` batches of nearly equal length, minus the first value, so that constants stay exact.
std::vector<double> batch_means(const std::vector<double>& series, std::size_t count) {
  std::vector<double> means;
  for (std::size_t b = 0; b < count; ++b) {
    const std::size_t begin = b * series.size() / count, end = (b + 1) * series.size() / count;
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += series[i] - series.front();
    means.push_back(sum / static_cast<double>(end - begin));
  }
  return means;
}

/// Standard error from second differences between neighbours, which exclude a steady change. For independent batches
/// with variance s^2 they have the mean square 6 s^2 and correlations -2/3, 1/6. This gives (b - 2) / (1 + 2 (4/9 +
/// 1/36)) degrees of freedom.
MeanError second_differences(const std::vector<double>& means) {
  const auto n = static_cast<double>(means.size());
  double squares = 0;
  for (std::size_t b = 2; b < means.size(); ++b) {
    const double bend = (means[b] - means[b - 1]) - (means[b - 1] - means[b - 2]);
    squares += bend * bend;
  }
  return {std::sqrt(squares / (6 * (n - 2) * n)), (n - 2) * 18 / 35};
}

}  // namespace

double MeanError::half_width() const {
  return freedom > 0 ? standard_error * student_95(freedom) : std::numeric_limits<double>::infinity();
}

MeanError mean_error(const std::vector<double>& series) {
  MeanError least;
  for (const std::size_t batches : {16U, 32U, 64U}) {
    if (series.size() < batches) break;
    const MeanError error = second_differences(batch_means(series, batches));
    if (least.freedom == 0 || error.standard_error < least.standard_error) least = error;
  }
  return least;
}

MeanError slow_mean_error(const std::vector<double>& series) {
  constexpr std::size_t k_batches = 8;
  constexpr double k_freedom = k_batches - 2, k_middle = 0.5 * (k_batches - 1);
  if (series.size() < 2 * k_batches) return {};
  const std::vector<double> means = batch_means(series, k_batches);
  const double mean = mean_of(means);
  double across = 0, squares = 0;
  for (std::size_t b = 0; b < k_batches; ++b) {
    const double from_middle = static_cast<double>(b) - k_middle;
    across += from_middle * (means[b] - mean);
    squares += from_middle * from_middle;
  }
  double rest = 0;
  for (std::size_t b = 0; b < k_batches; ++b)
    rest += std::pow(means[b] - mean - across / squares * (static_cast<double>(b) - k_middle), 2);
  return {std::sqrt(rest / k_freedom / k_batches), k_freedom};
}

MeanError mean_error_of_runs(const std::vector<double>& means) {
  if (means.size() < 2) return {};
  const auto n = static_cast<double>(means.size());
  double sum = 0, squares = 0;
  for (const double x : means) sum += x - means.front();
  for (const double x : means) squares += (x - means.front() - sum / n) * (x - means.front() - sum / n);
  return {std::sqrt(squares / (n - 1) / n), n - 1};
}

}  // namespace nilas::output
