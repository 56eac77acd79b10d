/// Numbers from a handful of runs, by hand and against tables of Student's t and chi^2.
#include "apps/compare/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace nilas;

TEST(Statistics, OfAFewValuesByHand) {
  EXPECT_DOUBLE_EQ(mean_of({1, 2, 6}), 3);
  EXPECT_DOUBLE_EQ(variance_of({1, 2, 6}), 7);
  EXPECT_TRUE(std::isnan(variance_of({1})));
  EXPECT_DOUBLE_EQ(median_of({5, 1, 2}), 2);
  EXPECT_DOUBLE_EQ(median_of({5, 1, 2, 4}), 3);
}

TEST(Statistics, StudentsQuantilesAreThoseOfTheTable) {
  EXPECT_NEAR(student_95(1), 12.706, 5e-4);
  EXPECT_NEAR(student_95(4), 2.776, 5e-4);
  EXPECT_NEAR(student_95(30), 2.042, 5e-4);
  EXPECT_TRUE(std::isinf(student_95(0)));
}

TEST(Statistics, FishersQuantilesAreThoseOfTheTable) {
  EXPECT_NEAR(scatter_95(2, 10), 4.103, 5e-4);
  EXPECT_NEAR(scatter_95(1, 30), 4.171, 5e-4);
  EXPECT_TRUE(std::isinf(scatter_95(0, 3)));
}

TEST(PooledVariance, OfTwinsAloneIsTheMeanSquareOfTheirDifferences) {
  const PooledVariance pooled = pooled_variance({3, -1}, {}, 0);
  EXPECT_DOUBLE_EQ(pooled.value, 5);
  EXPECT_DOUBLE_EQ(pooled.degrees, 2);
}

TEST(PooledVariance, IsNotMovedByOneSettingOfAnotherKind) {
  // the median of chi^2 with 2 degrees of freedom is 2 ln 2
  const double calm = pooled_variance({}, {1, 1, 1, 1, 1}, 2).value;
  EXPECT_NEAR(calm, 1 / std::log(2), 1e-12);
  EXPECT_DOUBLE_EQ(pooled_variance({}, {1, 1, 1, 1, 1e6}, 2).value, calm);
}

TEST(PooledVariance, OfRunsThatAreAllAlikeIsNone) { EXPECT_EQ(pooled_variance({0, 0}, {0, 0, 0}, 1).value, 0); }

}  // namespace
