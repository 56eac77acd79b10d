#include "core/output/loads/half_means.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace nilas::output {
namespace half_means_test {

/// `steps` values about 10 with deviations of up to 1, and `rise` more in the second half.
std::vector<double> noisy(std::size_t steps, double rise) {
  RandomStream random(1, "half means");
  std::vector<double> series;
  for (std::size_t k = 0; k < steps; ++k) series.push_back(10 + random.uniform(-1, 1) + (2 * k < steps ? 0 : rise));
  return series;
}

/// The deviation is 1 / sqrt(3) and a half has 500 values, so each half's standard error is about 0.58 / 22 = 0.026.
TEST(HalfMeans, DifferWhereTheLoadRisesByMoreThanItsErrors) {
  for (const bool ice_broke : {false, true}) {
    const auto steady = half_means(noisy(1000, 0), ice_broke), rising = half_means(noisy(1000, 1), ice_broke);
    ASSERT_TRUE(steady && rising);
    EXPECT_NEAR(rising->second.mean - rising->first.mean, 1, 6 * 0.026 * 1.5) << "the rise, within chance";
    EXPECT_LT(rising->first.half_width, 0.2);
    EXPECT_FALSE(steady->differ()) << ice_broke;
    EXPECT_TRUE(rising->differ()) << ice_broke;
  }
}

/// Loads without scatter have no error, but a change of less than a hundredth is none that matters.
TEST(HalfMeans, SmallChangesDoNotCount) {
  std::vector<double> slow(100, 1);
  for (std::size_t k = 50; k < 100; ++k) slow[k] = 1.005;
  EXPECT_FALSE(half_means(slow, false)->differ());
  for (std::size_t k = 50; k < 100; ++k) slow[k] = 1.1;
  EXPECT_TRUE(half_means(slow, false)->differ());
  EXPECT_FALSE(half_means(std::vector<double>(100, 0), false)->differ());
}

/// An error needs 16 values, so 31 are too few for two halves.
TEST(HalfMeans, AreNotKnownOfFewSteps) {
  for (const bool ice_broke : {false, true}) {
    EXPECT_FALSE(half_means(noisy(31, 1), ice_broke).has_value());
    EXPECT_TRUE(half_means(noisy(32, 1), ice_broke).has_value());
    EXPECT_FALSE(half_means({}, ice_broke).has_value());
  }
}

}  // namespace half_means_test
}  // namespace nilas::output
