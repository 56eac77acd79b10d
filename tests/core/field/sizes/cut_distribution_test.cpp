#include "core/field/sizes/cut_distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/field/sizes/distribution_statistics.h"

namespace nilas::field {
namespace cut_distribution_test {

constexpr double k_infinite = std::numeric_limits<double>::infinity();
const std::vector<SpreadKind> k_kinds{SpreadKind::normal, SpreadKind::lognormal, SpreadKind::uniform,
                                      SpreadKind::weibull};

DistributionSummary summary(const CutDistribution& cut) {
  return summary_of([&](double u) { return cut.quantile(u); });
}

/// So little lies below 0.05 at these cov that the moments are those before the cut.
TEST(CutDistribution, MeanIsOneAndTheDeviationIsTheCov) {
  for (const SpreadKind kind : k_kinds)
    for (const double cov : {0.02, 0.1, 0.2}) {
      const auto s = summary(CutDistribution(kind, cov, 0.05, k_infinite));
      EXPECT_NEAR(s.mean, 1, 2e-6) << static_cast<int>(kind) << " " << cov;
      EXPECT_NEAR(s.sd, cov, 2e-5 * cov) << static_cast<int>(kind) << " " << cov;
    }
}

TEST(CutDistribution, TheCutNormalHasTheMomentsOfTheTruncatedOne) {
  const double cov = 0.4, low = 0.6, high = 1.2, a = (low - 1) / cov, b = (high - 1) / cov;
  const auto density = [](double z) { return std::exp(-0.5 * z * z) / std::sqrt(2 * k_pi); };
  const double share = 0.5 * (std::erf(b / std::sqrt(2.0)) - std::erf(a / std::sqrt(2.0)));
  const double shift = (density(a) - density(b)) / share;
  const double variance = 1 + (a * density(a) - b * density(b)) / share - shift * shift;
  const CutDistribution cut(SpreadKind::normal, cov, low, high);
  const auto s = summary(cut);
  EXPECT_NEAR(s.mean, 1 + cov * shift, 1e-7);
  EXPECT_NEAR(s.sd, cov * std::sqrt(variance), 1e-7);
  EXPECT_EQ(s.min, low);
  EXPECT_EQ(s.max, high);
}

/// Weibull of cov 1 is the exponential distribution.
TEST(CutDistribution, WeibullOfCovOneIsExponential) {
  const double low = 0.05;
  const CutDistribution cut(SpreadKind::weibull, 1, low, k_infinite);
  for (const double u : {0.01, 0.3, 0.9, 0.9999})
    EXPECT_NEAR(cut.quantile(u), low - std::log1p(-u), 1e-12 * cut.quantile(u));
}

/// Ratio of the quantiles at 1 - 1/e and 1 - 1/e^(2^k): 2 for shape k, which Gamma ratios tie to the cov.
TEST(CutDistribution, WeibullShapeGivesTheCov) {
  const CutDistribution cut(SpreadKind::weibull, 0.25, 1e-6, k_infinite);
  const double ratio = cut.quantile(1 - std::exp(-2)) / cut.quantile(1 - std::exp(-1));
  const double shape = std::log(2) / std::log(ratio);
  const double first = std::tgamma(1 + 1 / shape), second = std::tgamma(1 + 2 / shape);
  EXPECT_NEAR(std::sqrt(second / (first * first) - 1), 0.25, 1e-9);
}

TEST(CutDistribution, ScoresKeepTheirOrderAndNothingHeapsUpAtTheLimits) {
  for (const SpreadKind kind : k_kinds) {
    const CutDistribution cut(kind, 0.5, 0.7, 1.3);
    double last = 0;
    for (double z = -8; z <= 8; z += 0.25) {
      const double x = cut.at_score(z);
      EXPECT_GE(x, 0.7);
      EXPECT_LE(x, 1.3);
      // beyond, neighbours differ by less than rounding
      if (std::abs(z) <= 6) {
        EXPECT_GT(x, last) << static_cast<int>(kind) << " " << z;
      }
      last = x;
    }
  }
}

TEST(CutDistribution, ScoresOfANormalAreItsDeviations) {
  const CutDistribution cut(SpreadKind::normal, 0.08, 0.05, k_infinite);
  for (double z = -6; z <= 6; z += 0.5) EXPECT_NEAR(cut.at_score(z), 1 + 0.08 * z, 1e-13);
  EXPECT_EQ(CutDistribution(SpreadKind::lognormal, 0, 0.05, k_infinite).at_score(3), 1);
}

TEST(CutDistribution, WrongNumbersAreRefused) {
  EXPECT_THROW(CutDistribution(SpreadKind::normal, -0.1, 0.05, 2), InputError);
  EXPECT_THROW(CutDistribution(SpreadKind::normal, 1.1, 0.05, 2), InputError);
  EXPECT_THROW(CutDistribution(SpreadKind::normal, 0.1, 1.05, 2), InputError);
  EXPECT_THROW(CutDistribution(SpreadKind::normal, 0.1, 0.05, 0.9), InputError);
}

}  // namespace cut_distribution_test
}  // namespace nilas::field
