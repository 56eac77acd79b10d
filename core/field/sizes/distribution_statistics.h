#pragma once
/// Statistics that compare a sample with its distribution.
#include <array>
#include <functional>
#include <vector>

namespace nilas::field {

/// Quantile function: the value of cumulative probability u in [0, 1]; not decreasing.
using Quantiles = std::function<double(double u)>;

constexpr std::array<double, 5> k_reported_quantiles{0.05, 0.25, 0.5, 0.75, 0.95};

/// Probability of a value of at most x, to 1e-13.
double probability_up_to(const Quantiles& quantiles, double x);

struct DistributionSummary {
  double mean = 0, sd = 0, min = 0, max = 0;
  std::array<double, k_reported_quantiles.size()> quantiles{};
};

/// Summary of a distribution. Mean and deviation by the trapezoidal rule in the normal score, with an error below 1e-6
/// of the deviation even where the quantiles jump. min and max are infinite where there is no bound.
DistributionSummary summary_of(const Quantiles& quantiles);
/// Summary of a sample, not empty: sd with n - 1 (0 for one value), quantiles linear between the order statistics.
DistributionSummary summary_of(std::vector<double> sample);

/// Kolmogorov-Smirnov distance sup |F_n - F| between a sample, not empty, and a distribution, which may have atoms.
/// Values closer than 1e-9 of their size count as equal. For n independent values it exceeds 1.36 / sqrt(n) in one of
/// twenty samples.
double ks_distance(std::vector<double> sample, const Quantiles& quantiles);

/// Correlation of the normal scores of the ranks (van der Waerden): it estimates the correlation of a Gaussian copula
/// whatever the distributions. 0 where a sample does not vary. The samples must be of one size.
double score_correlation(const std::vector<double>& a, const std::vector<double>& b);
/// Product-moment correlation of the values; 0 where a sample does not vary.
double correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace nilas::field
