/// The variance of chance from a handful of runs, by hand and against drawn numbers.
#include "apps/compare/scenes/judge/chance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace chance_test {

using namespace nilas;
using namespace nilas::compare;

TEST(PooledVariance, OfTwinsAloneIsTheMeanSquareOfTheirDifferences) {
  for (const auto& settings : {std::vector<std::vector<double>>{}, {{1}, {2}}}) {
    const PooledVariance pooled = pooled_variance({3, -1}, settings);
    EXPECT_DOUBLE_EQ(pooled.value, 5);
    EXPECT_DOUBLE_EQ(pooled.degrees, 2);
  }
}

TEST(PooledVariance, OfOneSettingIsItsOwn) {
  // the median of chi^2 with 2 degrees of freedom is 2 ln 2
  const PooledVariance pooled = pooled_variance({}, {{1, 2, 6}});
  EXPECT_NEAR(pooled.value, 7 / std::log(2), 1e-12);
  EXPECT_DOUBLE_EQ(pooled.degrees, 2);
}

TEST(PooledVariance, IsNotMovedByOneSettingOfAnotherKind) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  std::vector<std::vector<double>> settings(15, std::vector<double>(2));
  for (auto& differences : settings)
    for (double& difference : differences) difference = normal(random);
  const double alike = pooled_variance({}, settings).value;
  settings.front() = {1e6, -1e6};
  const double with_one = pooled_variance({}, settings).value;
  EXPECT_LT(std::max(with_one / alike, alike / with_one), 1.5);
}

/// The reference's own chance is in all differences of a realisation alike and must not count once per setting, nor as
/// none: drawn loads of 8 settings and a reference, whose difference has twice the variance of one.
TEST(PooledVariance, IsThatOfTwoRunsWhateverTheReferenceDrew) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  double sum = 0;
  constexpr int k_draws = 4000, k_settings = 8, k_realisations = 3;
  for (int draw = 0; draw < k_draws; ++draw) {
    std::vector<std::vector<double>> settings(k_settings, std::vector<double>(k_realisations));
    for (int r = 0; r < k_realisations; ++r) {
      const double reference = normal(random);
      for (auto& differences : settings) differences[r] = normal(random) - reference;
    }
    sum += pooled_variance({}, settings).value / k_draws;
  }
  // a median of eight is skewed, so that its mean is a tenth off
  EXPECT_NEAR(sum, 2, 0.3);
}

TEST(PooledVariance, OfRunsThatAreAllAlikeIsNone) {
  EXPECT_EQ(pooled_variance({0, 0}, {{0, 0}, {0, 0}, {0, 0}}).value, 0);
}

}  // namespace chance_test
