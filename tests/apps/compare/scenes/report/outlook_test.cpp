/// Tests of the forecast of a study with more time, with hand-made figures.
#include "apps/compare/scenes/report/outlook.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apps/compare/scenes/judge/floors.h"
#include "core/base/statistics.h"

namespace outlook_test {

using namespace nilas;
using namespace nilas::compare;

/// Loads of 100 N that chance makes differ by a variance of 8 N^2, of `realisations` realisations of two settings.
struct Case {
  SceneStudy study;
  Findings found;

  explicit Case(int realisations) {
    study.plan.settings.resize(2);
    study.plan.realisations = realisations;
    study.budget_s = 60;
    found.measure = {"load", "N", 0};
    found.measure.scale = 100;
    found.chance.variance = {8, static_cast<double>(realisations), false};
    for (int r = 0; r < realisations; ++r) found.shared.push_back(r);
    found.common_floor = floor_of(8, realisations, realisations, 0);
  }
  void row(const std::string& status) {
    RunRow row;
    row.result.status = status;
    found.rows.push_back(row);
  }
  Outlook view(double left_s = 0) const { return outlook(study, found, "out", left_s, 30); }
};

TEST(Outlook, SmallestDifferenceFallsWithTheRootOfRealisationsAndStudentsT) {
  const Case one(1);
  EXPECT_NEAR(*smallest_difference(one.found, 1), student_95(1) * std::sqrt(8), 1e-9);
  EXPECT_NEAR(*smallest_difference(one.found, 4), student_95(4) * std::sqrt(8 / 4.0), 1e-9) << "each has its twin";
  Case settings(2);
  settings.found.chance.variance = {8, 5, true};
  EXPECT_NEAR(*smallest_difference(settings.found, 3), student_95(10) * std::sqrt(8 / 3.0), 1e-9);
}

TEST(Outlook, OfOneReferenceKeepsItsChance) {
  Case one(1);
  one.found.judges.one_run = true;
  EXPECT_NEAR(*smallest_difference(one.found, 4), student_95(4) * std::sqrt(4 / 4.0 + 4), 1e-9);
}

TEST(Outlook, IsNotKnownWhereChanceIsNot) {
  Case none(2);
  none.found.chance = {};
  EXPECT_FALSE(smallest_difference(none.found, 3));
  none.found.chance.variance = {8, 2, false};
  none.found.measure.name = "distance";
  EXPECT_FALSE(smallest_difference(none.found, 3));
}

TEST(Outlook, OfMissingRunsSaysWhatTheyTakeTellAndHowToGoOn) {
  Case cut(3);
  cut.found.shared = {0};
  cut.found.common_floor = floor_of(8, 1, 1, 0);
  cut.found.chance.variance.degrees = 1;
  for (const char* status : {"done", "failed", "not run", "budget"}) cut.row(status);
  const Outlook view = cut.view(400);
  ASSERT_TRUE(view.next);
  EXPECT_EQ(view.next->missing_runs, 2);
  EXPECT_EQ(view.next->realisations, 3);
  EXPECT_EQ(view.next->seconds, 400);
  EXPECT_NEAR(*view.next->smallest_difference, student_95(3) * std::sqrt(8 / 3.0), 1e-9);
  EXPECT_EQ(view.next->command, "nilas compare --resume out --budget 470") << "with a reserve";
  const auto lines = outlook_lines(view, cut.study, cut.found);
  ASSERT_GE(lines.size(), 3U);
  EXPECT_EQ(lines[0],
            "With about 6 min 40 s more, all 2 settings would have 3 realisations. Differences of the mean ice load "
            "above about 5.2 N (5.2 %) would then be significant, now only those above 35.9 N (36 %).");
  EXPECT_EQ(lines[2], "  nilas compare --resume out --budget 470");
}

TEST(Outlook, WhereAllIsDoneAndLittleToldAsksForMoreRealisations) {
  Case done(2);
  done.row("done");
  const Outlook view = done.view();
  ASSERT_TRUE(view.next);
  EXPECT_EQ(view.next->missing_runs, 0);
  EXPECT_EQ(view.next->realisations, 4);
  EXPECT_EQ(view.next->seconds, 60);
  EXPECT_EQ(view.next->command, "nilas compare --resume out --seeds 4 --budget 72");
  ASSERT_TRUE(view.for_target);
  EXPECT_LE(*smallest_difference(done.found, *view.for_target), 2);
  EXPECT_GT(*smallest_difference(done.found, *view.for_target - 1), 2);
  EXPECT_EQ(view.for_target_s, 30 * (*view.for_target - 2));
}

TEST(Outlook, WhereTwoPercentAreToldAsksForNothing) {
  Case good(3);
  good.row("done");
  good.found.common_floor = 1;
  EXPECT_FALSE(good.view().next);
  EXPECT_TRUE(outlook_lines(good.view(), good.study, good.found).empty());
}

TEST(Outlook, OfOneSettingAloneAsksForANewComparison) {
  Case alone(2);
  alone.row("not run");
  alone.study.plan.settings.resize(1);
  alone.study.plan.omissions = {{"a setting", "the budget of 60 s"}};
  alone.study.plan.whole_s = 100;
  EXPECT_FALSE(alone.view(10).next);
  EXPECT_EQ(alone.view(10).whole_s, 120);
}

TEST(Outlook, NamesTheBudgetThatLeavesNothingOut) {
  Case cut(3);
  cut.row("done");
  cut.found.common_floor = 1;
  cut.study.plan.omissions = {{"simulated time", "the budget of 60 s"}};
  cut.study.plan.whole_s = 1000;
  EXPECT_EQ(cut.view().whole_s, 1200);
  EXPECT_EQ(outlook_lines(cut.view(), cut.study, cut.found).size(), 1U);
}

}  // namespace outlook_test
