/// Tests of the caveats of a comparison.
#include <gtest/gtest.h>

#include <algorithm>

#include "apps/compare/scenes/report/answer.h"

namespace caveats_test {

using namespace nilas::compare;

/// The caveats of a comparison of four runs, of which the budget ended some and did not let others begin.
std::vector<std::string> caveats_of(const std::vector<std::string>& late, const std::vector<std::string>& too_long) {
  SceneReport report;
  report.study.plan.runs.resize(4);
  report.study.budget_s = 100;
  report.late = late;
  report.too_long = too_long;
  return caveat_lines(report);
}

bool says(const std::vector<std::string>& lines, const std::string& sentence) {
  return std::find(lines.begin(), lines.end(), sentence) != lines.end();
}

TEST(Caveats, TellRunsThatWereTooLongFromABudgetThatWasUsedUp) {
  const std::string used_up = "The budget of 100 s was used up before 1 of 4 runs were done.",
                    refused = "2 of 4 runs did not begin: they were expected to take more than was left of the budget.";
  const auto both = caveats_of({"a", "b", "c"}, {"b", "c"});
  EXPECT_TRUE(says(both, used_up));
  EXPECT_TRUE(says(both, refused));
  EXPECT_FALSE(says(caveats_of({"b", "c"}, {"b", "c"}), used_up)) << "time may be left";
  EXPECT_FALSE(says(caveats_of({"a"}, {}), refused));
}

TEST(Caveats, DoNotRepeatThatTheBudgetShortenedTheRuns) {
  SceneReport report;
  report.study.plan.end = 3.7;
  report.study.plan.scene_end = 6;
  for (const std::string& line : caveat_lines(report)) EXPECT_EQ(line.find("3.7"), std::string::npos) << line;
}

}  // namespace caveats_test
