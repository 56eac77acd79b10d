#include "core/output/loads/twin_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/statistics.h"

namespace nilas::output {

namespace {

constexpr double k_share_of_diameter = 1e-4, k_first_fitted = 1e-11;  // -, [m]

double mean_diameter(const bodies::Bodies& bodies) {
  double sum = 0;
  int count = 0;
  for (int b = 0; b < bodies.size(); ++b) {
    if (!bodies.is_free(b)) continue;
    sum += 2 * bodies.shape[b]->bounding_radius;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

/// Largest distance between the same bodies of two runs; infinite where they do not have the same bodies.
double largest_distance(const bodies::Bodies& one, const bodies::Bodies& other) {
  if (one.id != other.id) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t b = 0; b < one.id.size(); ++b)
    largest = std::max(largest, (one.p_GB[b] - other.p_GB[b]).squaredNorm());
  return std::sqrt(largest);
}

}  // namespace

TwinHorizon::TwinHorizon(const bodies::Bodies& start) : threshold_(k_share_of_diameter * mean_diameter(start)) {}

void TwinHorizon::compare(double t, const std::vector<const bodies::Bodies*>& runs) {
  if (horizon_) return;
  double distance = 0;
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) distance = std::max(distance, largest_distance(*runs[i], *runs[k]));
  if (distance > threshold_)
    horizon_ = t;
  else if (distance > k_first_fitted) {
    times_.push_back(t);
    logs_.push_back(std::log(distance));
  }
}

std::optional<double> TwinHorizon::e_folding() const {
  constexpr std::size_t k_least = 10;
  if (!horizon_ || times_.size() < k_least) return std::nullopt;
  const double t_mean = mean_of(times_), log_mean = mean_of(logs_);
  double across = 0, squares = 0;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    across += (times_[i] - t_mean) * (logs_[i] - log_mean);
    squares += (times_[i] - t_mean) * (times_[i] - t_mean);
  }
  if (!(across > 0)) return std::nullopt;
  return squares / across;
}

}  // namespace nilas::output
