/// Tests of the figures of a comparison's report in words.
#include "apps/compare/scenes/report/scene_report.h"

#include <gtest/gtest.h>

#include <limits>

namespace scene_report_test {

using namespace nilas;
using namespace nilas::compare;

/// A report over this window, of runs from 0 s to 2000 s.
SceneReport report_over(double from, double to) {
  SceneReport report;
  report.study.plan.end = 2000;
  report.found.measure = {"load", "N", 100};
  report.found.shared = {0};
  report.found.windows = {output::LoadSpan{from, to, ""}};
  return report;
}

TEST(SceneReport, StatesWindowsFarFromTheStartWithTheirWidth) {
  EXPECT_EQ(window_text(report_over(123.4, 124.4)), "123.4 to 124.4 s");
  EXPECT_EQ(window_text(report_over(300, 1234.5)), "300 to 1234.5 s");
}

TEST(SceneReport, StatesAllSimulatedTimeWhereNoWindowIsKnown) {
  SceneReport report = report_over(2, 6);
  report.found.windows = {std::nullopt};
  EXPECT_EQ(window_text(report), "0 to 2000 s");
}

TEST(SceneReport, StatesThreeDigitsWithoutAnExponent) {
  EXPECT_EQ(three_digits(0.12345), "0.123");
  EXPECT_EQ(three_digits(-12.345), "-12.3");
  EXPECT_EQ(three_digits(999.6), "1000");
  EXPECT_EQ(three_digits(1234), "1230");
  EXPECT_EQ(three_digits(0), "0");
}

TEST(SceneReport, StatesQuantitiesInReadableUnits) {
  EXPECT_EQ(quantity_text(7.803, "N"), "7.8 N");
  EXPECT_EQ(quantity_text(12345, "N"), "12.3 kN");
  EXPECT_EQ(quantity_text(0.0123, "m"), "12.3 mm");
  EXPECT_EQ(quantity_text(std::numeric_limits<double>::quiet_NaN(), "N"), "not known");
}

TEST(SceneReport, LeavesOutAnUncertaintyBelowHalfAUnitOfTheThirdDigit) {
  EXPECT_EQ(uncertainty_text(999, 0.4, ""), "");
  EXPECT_EQ(uncertainty_text(999, 0.6, ""), " +- 0.6");
  EXPECT_EQ(uncertainty_text(101, 0.4, ""), "") << "the unit of the third digit is 1 from 100 to 999";
  EXPECT_EQ(uncertainty_text(101, 0.6, ""), " +- 0.6");
  EXPECT_EQ(uncertainty_text(-1, 0.004, "N"), "");
  EXPECT_EQ(uncertainty_text(-1, 0.006, "N"), " +- 0.006 N");
  EXPECT_EQ(uncertainty_text(0, 0.001, "N"), " +- 0.001 N");
  EXPECT_EQ(uncertainty_text(1, std::numeric_limits<double>::infinity(), "N"), "");
}

}  // namespace scene_report_test
