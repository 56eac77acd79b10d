/// Tests of a comparison's plan in words.
#include "apps/compare/scenes/report/plan_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace plan_text_test {

using namespace nilas::compare;

SceneStudy study_of(double estimate_s) {
  SceneStudy study;
  study.budget_s = 100;
  study.plan.settings.assign(2, {"auto", "coulomb", "moreau", "projection", 0.01, 1e-6});
  study.plan.reference = study.plan.settings.front();
  study.plan.estimate_s = estimate_s;
  return study;
}

TEST(PlanText, SaysWhereTheEstimateExceedsTheBudget) {
  const std::string words =
      "The estimate exceeds the 50 s that are left of the budget of 100 s. Less time is then simulated, and a run that "
      "is expected to take more than is left does not begin.";
  const auto says = [&](const SceneStudy& study, double left_s) {
    const std::vector<std::string> lines = plan_lines(study, left_s);
    return std::count(lines.begin(), lines.end(), words);
  };
  EXPECT_EQ(says(study_of(90), 50), 1);
  EXPECT_EQ(says(study_of(40), 50), 0);
  EXPECT_EQ(says(study_of(90), std::numeric_limits<double>::infinity()), 0) << "no budget";
}

}  // namespace plan_text_test
