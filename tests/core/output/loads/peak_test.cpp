#include "core/output/loads/peak.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nilas::output {
namespace peak_test {

/// An impact of 3 N s at 1 s on a load of 2 N that lasts 4 s, in steps of h.
std::vector<double> impact(double h) {
  std::vector<double> series(static_cast<std::size_t>(std::lround(4 / h)), 2);
  series[std::lround(1 / h)] += 3 / h;
  return series;
}

TEST(Peak, TheRawOneGrowsAsTheStepShrinksAndTheOthersDoNot) {
  for (const double h : {0.1, 0.01, 0.001}) {
    const Peak peak = peak_of(impact(h), 10, h, 0.2);
    EXPECT_NEAR(peak.raw, 2 + 3 / h, 1e-9 / h);
    EXPECT_NEAR(peak.raw_time, 11 + h, 1e-9);
    EXPECT_NEAR(peak.filtered, 2 + 3 / 0.2, 1e-9) << h;
    EXPECT_NEAR(peak.event_impulse, 3 + 2 * h, 1e-9) << h;
    EXPECT_NEAR(peak.event_to - peak.event_from, h, 1e-9);
  }
}

TEST(Peak, IsFilteredExactlyOverPartsOfSteps) {
  const Peak peak = peak_of({0, 0, 6, 0, 0}, 0, 1, 1.5);
  EXPECT_DOUBLE_EQ(peak.filtered, 4);
  EXPECT_DOUBLE_EQ(peak_of({0, 0, 6, 3, 0}, 0, 1, 1.5).filtered, (6 + 1.5) / 1.5);
}

TEST(Peak, KeepsItsSign) {
  const Peak peak = peak_of({1, -4, -2, 1}, 0, 0.5, 0.1);
  EXPECT_EQ(peak.raw, -4);
  EXPECT_EQ(peak.filtered, -4) << "a filter shorter than a step is a step";
  EXPECT_EQ(peak.filter, 0.5);
  EXPECT_DOUBLE_EQ(peak.event_impulse, -3);
  EXPECT_EQ(peak_of({0, 0}, 0, 1, 1).raw, 0);
  EXPECT_EQ(peak_of({}, 0, 1, 1).filtered, 0);
}

TEST(Peak, FilterTimesFollowFroudesLaw) {
  EXPECT_DOUBLE_EQ(default_peak_filter(100), 0.2);
  EXPECT_DOUBLE_EQ(default_peak_filter(4), 0.2 / 5);
}

TEST(Peak, ShareOfTheLargestPercent) {
  std::vector<double> series(200, 1);
  EXPECT_DOUBLE_EQ(share_of_largest_percent(series), 0.01);
  series[7] = -198;
  series[100] = 199;
  EXPECT_NEAR(share_of_largest_percent(series), 397.0 / 595, 1e-12);
  EXPECT_EQ(share_of_largest_percent({0, 0}), 0);
}

}  // namespace peak_test
}  // namespace nilas::output
