/// Statistics of samples by hand, and quantiles against the tables of Student's t and Fisher's F.
#include "core/base/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace statistics_test {

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
  EXPECT_NEAR(fisher_95(2, 10), 4.103, 5e-4);
  EXPECT_NEAR(fisher_95(1, 30), 4.171, 5e-4);
  EXPECT_TRUE(std::isinf(fisher_95(0, 3)));
}

TEST(Statistics, PercentilesAreLinearBetweenNeighbours) {
  EXPECT_DOUBLE_EQ(percentile_of({4, 1, 3, 2}, 0), 1);
  EXPECT_DOUBLE_EQ(percentile_of({4, 1, 3, 2}, 1), 4);
  EXPECT_DOUBLE_EQ(percentile_of({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(percentile_of({7}, 0.99), 7);
  EXPECT_THROW(percentile_of({}, 0.5), ContractError);
}

}  // namespace statistics_test
