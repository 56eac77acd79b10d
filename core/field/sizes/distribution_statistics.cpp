#include "core/field/sizes/distribution_statistics.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/base/statistics.h"

namespace nilas::field {

namespace {

/// Probability of a value below x or, if `including`, of one up to x.
double probability(const Quantiles& quantiles, double x, bool including) {
  double low = 0, high = 1;
  constexpr int k_bisections = 45;
  for (int k = 0; k < k_bisections; ++k) {
    const double u = 0.5 * (low + high), value = quantiles(u);
    (including ? value <= x : value < x) ? low = u : high = u;
  }
  return 0.5 * (low + high);
}

/// Normal scores of the ranks; equal values share their mean rank.
std::vector<double> normal_scores(const std::vector<double>& sample) {
  std::vector<std::size_t> order(sample.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sample[a] < sample[b]; });
  std::vector<double> scores(sample.size());
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    while (end < order.size() && sample[order[end]] == sample[order[first]]) ++end;
    const double rank = 0.5 * static_cast<double>(first + end + 1);
    const double z = boost::math::quantile(boost::math::normal(), rank / static_cast<double>(sample.size() + 1));
    for (std::size_t k = first; k < end; ++k) scores[order[k]] = z;
  }
  return scores;
}

}  // namespace

double probability_up_to(const Quantiles& quantiles, double x) { return probability(quantiles, x, true); }

DistributionSummary summary_of(const Quantiles& quantiles) {
  constexpr double k_reach = 8, k_step = 0.002;
  double weights = 0, first = 0, second = 0;
  const double middle = quantiles(0.5);
  for (double z = -k_reach; z <= k_reach; z += k_step) {
    const double weight = std::exp(-0.5 * z * z), x = quantiles(cdf(boost::math::normal(), z)) - middle;
    weights += weight;
    first += weight * x;
    second += weight * x * x;
  }
  DistributionSummary summary;
  summary.mean = middle + first / weights;
  summary.sd = std::sqrt(std::max(0.0, second / weights - first * first / (weights * weights)));
  summary.min = quantiles(0);
  summary.max = quantiles(1);
  std::transform(k_reported_quantiles.begin(), k_reported_quantiles.end(), summary.quantiles.begin(), quantiles);
  return summary;
}

DistributionSummary summary_of(std::vector<double> sample) {
  NILAS_DEMAND(!sample.empty());
  std::sort(sample.begin(), sample.end());
  DistributionSummary summary;
  summary.min = sample.front();
  summary.max = sample.back();
  const auto n = static_cast<double>(sample.size());
  summary.mean = sample.front() == sample.back() ? sample.front() : mean_of(sample);
  summary.sd = n > 1 ? std::sqrt(squares_about(sample, summary.mean) / (n - 1)) : 0;
  for (std::size_t k = 0; k < k_reported_quantiles.size(); ++k)
    summary.quantiles[k] = percentile_of(sample, k_reported_quantiles[k]);
  return summary;
}

double ks_distance(std::vector<double> sample, const Quantiles& quantiles) {
  NILAS_DEMAND(!sample.empty());
  std::sort(sample.begin(), sample.end());
  constexpr double k_equal = 1e-9;
  const auto n = static_cast<double>(sample.size());
  double largest = 0;
  for (std::size_t first = 0, end = 0; first < sample.size(); first = end) {
    const double x = sample[first], spacing = k_equal * std::abs(x);
    while (end < sample.size() && sample[end] <= x + spacing) ++end;
    const double below = static_cast<double>(first) / n, up_to = static_cast<double>(end) / n;
    largest = std::max({largest, std::abs(below - probability(quantiles, x - spacing, false)),
                        std::abs(up_to - probability(quantiles, x + spacing, true))});
  }
  return largest;
}

double score_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  return correlation(normal_scores(a), normal_scores(b));
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  NILAS_DEMAND(a.size() == b.size() && !a.empty());
  const double mean_a = mean_of(a), mean_b = mean_of(b);
  double aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = a[i] - mean_a, y = b[i] - mean_b;
    aa += x * x;
    bb += y * y;
    ab += x * y;
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

}  // namespace nilas::field
