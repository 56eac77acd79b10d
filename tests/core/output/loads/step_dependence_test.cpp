#include "core/output/loads/step_dependence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nilas::output {
namespace step_dependence_test {

/// A load of 10 N with impacts of one step in every `every` steps.
std::vector<double> with_impacts(std::size_t steps, std::size_t every, double impact) {
  std::vector<double> series(steps, 10);
  for (std::size_t k = every / 2; k < steps; k += every) series[k] += impact;
  return series;
}

TEST(StepDependence, OfASmoothLoadIsSmallForAllFigures) {
  std::vector<double> series;
  for (int k = 0; k < 2000; ++k) series.push_back(10 + 5 * std::sin(0.05 * k));
  const StepDependence found = step_dependence(series, 0.01, 0.05, false);
  EXPECT_LT(found.p99, 0.001);
  EXPECT_LT(found.filtered, 0.001);
  EXPECT_LT(found.raw, 0.001);
  EXPECT_EQ(figures_to_use(found, false),
            "Use the mean with its +-, the filtered peak, the 99th percentile of the steps and the raw peak. A peak is "
            "one draw: run several seeds, and see `nilas statistics`.");
}

TEST(StepDependence, OfImpactsOfOneStepIsTheirHalf) {
  const StepDependence found = step_dependence(with_impacts(2000, 50, 90), 0.01, 0.2, false);
  EXPECT_DOUBLE_EQ(found.raw, 1 - 55.0 / 100) << "(10 + 100) / 2 in place of 100";
  EXPECT_DOUBLE_EQ(found.p99, 1 - 55.0 / 100) << "every fiftieth step has an impact";
  EXPECT_NEAR(found.filtered, 0, 1e-12) << "a mean over 20 steps holds the same impulse";
  const std::string text = figures_to_use(found, true);
  EXPECT_NE(text.find("the mean (its +- is a lower bound) and the filtered peak."), std::string::npos) << text;
  EXPECT_NE(text.find("Do not use the 99th percentile of the steps (45 %) or the raw peak (45 %): they depend"),
            std::string::npos)
      << text;
}

TEST(StepDependence, OfAFilterOfOneStepIsThatOfTheRawPeak) {
  const StepDependence found = step_dependence(with_impacts(2000, 50, 90), 0.01, 0.01, false);
  EXPECT_NEAR(found.filtered, found.raw, 1e-9) << "the mean over two steps is the least that pairs can tell";
}

TEST(StepDependence, OfRigidContactsNeverLetsTheRawPeakBeUsed) {
  const StepDependence found = step_dependence(std::vector<double>(100, 10), 0.01, 0.05, true);
  const std::string text = figures_to_use(found, false);
  EXPECT_NE(text.find("Do not use the raw peak (0 %): it depends on the time step."), std::string::npos) << text;
}

TEST(StepDependence, LeavesARawPeakOutThatSecondSolutionsDoNotBearOut) {
  StepDependence found = step_dependence(std::vector<double>(100, 10), 0.01, 0.05, false);
  found.doubted = true;
  const std::string text = figures_to_use(found, false);
  EXPECT_EQ(text.find("raw peak"), std::string::npos) << text;
  found.raw = 0.3;
  EXPECT_NE(figures_to_use(found, false).find("Do not use the raw peak (30 %)"), std::string::npos);
}

TEST(StepDependence, TakesTheLastOfAnOddNumberOfStepsByItself) {
  const StepDependence found = step_dependence({1, 1, 1, 1, 9}, 0.01, 0.02, false);
  EXPECT_EQ(found.raw, 0) << "a peak in the last step does not fall";
}

TEST(StepDependence, OfNoLoadAndOfOneStepIsZero) {
  for (const std::vector<double>& series : {std::vector<double>{}, {3}, {0, 0, 0, 0}}) {
    const StepDependence found = step_dependence(series, 0.01, 0.02, false);
    EXPECT_EQ(found.p99 + found.filtered + found.raw, 0);
  }
}

}  // namespace step_dependence_test
}  // namespace nilas::output
