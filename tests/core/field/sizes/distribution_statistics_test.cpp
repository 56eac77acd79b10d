#include "core/field/sizes/distribution_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"

namespace nilas::field {
namespace distribution_statistics_test {

TEST(DistributionStatistics, SummaryOfASample) {
  const auto s = summary_of(std::vector<double>{5, 1, 3, 2, 4});
  EXPECT_EQ(s.mean, 3);
  EXPECT_DOUBLE_EQ(s.sd, std::sqrt(2.5));
  EXPECT_EQ(s.min, 1);
  EXPECT_EQ(s.max, 5);
  EXPECT_DOUBLE_EQ(s.quantiles[0], 1.2);
  EXPECT_EQ(s.quantiles[2], 3);
  EXPECT_DOUBLE_EQ(s.quantiles[4], 4.8);
  EXPECT_EQ(summary_of(std::vector<double>{0.1, 0.1, 0.1}).mean, 0.1);
}

TEST(DistributionStatistics, SummaryOfADistribution) {
  const auto uniform = summary_of([](double u) { return 2 + 3 * u; });
  EXPECT_NEAR(uniform.mean, 3.5, 1e-9);
  EXPECT_NEAR(uniform.sd, 3 / std::sqrt(12.0), 1e-9);
  EXPECT_DOUBLE_EQ(uniform.quantiles[1], 2.75);
  const auto two = summary_of([](double u) { return u < 0.25 ? 1.0 : 5.0; });
  EXPECT_NEAR(two.mean, 4, 1e-3);
  EXPECT_NEAR(two.sd, std::sqrt(3.0), 1e-3);
}

/// A sample at the middles of n equal shares is 1/(2 n) away; half of it on one side is half away.
TEST(DistributionStatistics, KolmogorovSmirnovDistance) {
  const auto uniform = [](double u) { return 1 + u; };
  std::vector<double> sample;
  for (int k = 0; k < 20; ++k) sample.push_back(1 + (k + 0.5) / 20);
  EXPECT_NEAR(ks_distance(sample, uniform), 0.025, 1e-8);
  for (double& x : sample) x = 1 + 0.5 * (x - 1);
  EXPECT_NEAR(ks_distance(sample, uniform), 0.5 - 0.0125, 0.03);
}

TEST(DistributionStatistics, AtomsAreNoDistance) {
  const auto cut = [](double u) { return std::clamp(u, 0.3, 0.8); };
  std::vector<double> sample;
  constexpr int k_count = 1000;
  for (int k = 0; k < k_count; ++k) sample.push_back(cut((k + 0.5) / k_count) * (1 + 1e-16 * (k % 3)));
  EXPECT_LT(ks_distance(sample, cut), 1.0 / k_count);
  EXPECT_NEAR(probability_up_to(cut, 0.3), 0.3, 1e-12);
  EXPECT_NEAR(probability_up_to(cut, 0.29), 0, 1e-12);
  EXPECT_NEAR(probability_up_to(cut, 0.8), 1, 1e-12);
  EXPECT_EQ(ks_distance({2, 2, 2}, [](double) { return 2.0; }) < 1e-12, true);
}

/// The tolerance for 4000 normal pairs is four standard errors (1 - r^2) / sqrt(n). Monotone changes leave the scores
/// unchanged.
TEST(DistributionStatistics, CorrelationOfScoresIsThatOfTheCopula) {
  RandomStream a(7, "a"), b(7, "b");
  std::vector<double> x, y, bent;
  constexpr double k_correlation = 0.6;
  for (int k = 0; k < 4000; ++k) {
    x.push_back(a.normal());
    y.push_back(k_correlation * x.back() + std::sqrt(1 - k_correlation * k_correlation) * b.normal());
    bent.push_back(std::exp(3 * y.back()));
  }
  const double error = (1 - k_correlation * k_correlation) / std::sqrt(4000.0);
  EXPECT_NEAR(correlation(x, y), k_correlation, 4 * error);
  EXPECT_NEAR(score_correlation(x, y), k_correlation, 4 * error);
  EXPECT_EQ(score_correlation(x, bent), score_correlation(x, y));
  EXPECT_LT(correlation(x, bent), 0.4);
  EXPECT_EQ(correlation(x, std::vector<double>(x.size(), 1.0)), 0);
}

}  // namespace distribution_statistics_test
}  // namespace nilas::field
