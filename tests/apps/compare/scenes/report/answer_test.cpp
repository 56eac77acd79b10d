/// Tests of a comparison's answer in words, with hand-made figures.
#include "apps/compare/scenes/report/answer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace answer_test {

using namespace nilas;
using namespace nilas::compare;

/// Two settings, the second of which takes `time` in place of 1 s/s, judged over 2 s to 6 s by a reference of 100 N.
SceneReport report_of_two(double time) {
  SceneReport report;
  Plan& plan = report.study.plan;
  plan.end = plan.scene_end = 6;
  plan.realisations = 1;
  plan.settings.assign(2, {"auto", "coulomb", "moreau", "projection", 0.01, 1e-6});
  plan.settings[1].solver = "newton";
  Findings& found = report.found;
  found.measure = {"load", "N", 100};
  found.headline = "ice_resistance_N";
  found.shared = {0};
  found.windows = {output::LoadSpan{2, 6, ""}};
  found.reference.mean.mean = 100;
  found.time_spread = 0.05;
  for (std::size_t k = 0; k < 2; ++k) {
    Merit m;
    m.setting = k;
    m.planned = m.done = 1;
    m.realisations = {0};
    m.time = k == 0 ? 1 : time;
    m.error = 0.05;
    m.floor = 0.1;
    found.merits.push_back(m);
  }
  return report;
}

bool says(const std::vector<std::string>& lines, const std::string& words) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

TEST(Answer, NamesSettingAndWindowBesideTheirNumbers) {
  SceneReport report = report_of_two(0.5);
  report.found.choice.chosen = 1;
  const std::vector<std::string> lines = answer_lines(report);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0],
            "Use \"newton\": its mean ice load is within 2 % of the reference's mean ice load (100 N along the course "
            "over 2 to 6 s). \"newton\" takes 0.5 s of computing per simulated second, and the scene's own setting (" +
                full_label(report.study.plan.settings[0]) +
                ") takes 1 s. So \"newton\" is 2 times faster than the scene's own setting.");
}

TEST(Answer, StatesLongComputingTimesWithoutAnExponent) {
  SceneReport report = report_of_two(1234);
  report.found.choice.chosen = 1;
  EXPECT_TRUE(says(answer_lines(report), "\"newton\" takes 1230 s of computing per simulated second"));
}

TEST(Answer, BeginsWithTheWindowWhereTheBudgetShortenedTheRuns) {
  SceneReport report = report_of_two(0.5);
  EXPECT_FALSE(says(answer_lines(report), "shortened"));
  report.study.plan.scene_end = 1234.5;
  EXPECT_EQ(answer_lines(report)[0], "Only 2 to 6 s was compared: the budget shortened the runs from 1234.5 s.");
}

TEST(Answer, StatesHowLongMotionsCanBePredictedWithoutAnExponent) {
  SceneReport report = report_of_two(0.5);
  report.found.horizon = {true, true, 1234.5, 1e-4};
  report.study.plan.end = report.study.plan.scene_end = 2000;
  EXPECT_TRUE(says(detail_lines(report), "can be predicted until 1234.5 s of 2000 s."));
}

TEST(Answer, SaysThatAnotherSettingWasFasterButNotSignificantly) {
  SceneReport report = report_of_two(0.9);
  report.found.choice.chosen = 0;
  report.found.choice.faster = 1;
  EXPECT_TRUE(says(answer_lines(report),
                   "\"newton\" was as accurate and took 0.9 s instead of 1 s, but only a factor above 1.24 is "
                   "significant, since times of one setting scatter by 5 %."));
  report.found.time_spread = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(says(answer_lines(report), "above 1.53 is significant, since the scatter of times was not measured."));
  report.found.choice.faster.reset();
  EXPECT_FALSE(says(answer_lines(report), "\"newton\""));
}

TEST(Answer, NamesTheLatestBeginOfWindowsThatDiffer) {
  SceneReport report = report_of_two(0.5);
  report.found.shared = {0, 1};
  report.found.windows.push_back(output::LoadSpan{2.5, 6, ""});
  EXPECT_EQ(window_text(report), "2 to 6 s (other realisations begin at up to 2.5 s)");
}

TEST(Answer, OfAnAblationBeginsWithTheLoadWithoutSimplifications) {
  SceneReport report = report_of_two(0.5);
  report.study.ablation = true;
  report.found.merits[0].load.mean = 98;
  EXPECT_EQ(answer_lines(report)[0],
            "Without any simplification the mean ice load is 98 N along the course, over 2 to 6 s.");
}

TEST(Answer, SaysWhyPeaksMustNotBeTakenAndWhatToDoInstead) {
  SceneReport report = report_of_two(0.5);
  report.found.choice.chosen = 1;
  report.found.reference.std.mean = 10;
  report.found.reference.p99.mean = 150;
  report.found.reference.max.mean = 400;
  Merit& best = report.found.merits[1];
  best.load_std.mean = 11;
  best.load_p99.mean = 150;
  best.load_max.mean = 200;
  const std::vector<std::string> lines = detail_lines(report);
  EXPECT_TRUE(says(lines, "The largest load here is the mean over a single time step."));
  EXPECT_TRUE(says(lines,
                   "With \"newton\", over 2 to 6 s, the standard deviation of the load differs by +10 % from the "
                   "reference's, the 99 % load by +0 %, and the largest load by -50 %."));
  EXPECT_TRUE(says(lines, "At 5 % as the bound, the 99 % load of this setting may be used, the largest load not."));
  EXPECT_TRUE(says(lines, "run \"newton\" with nilas run for several seeds and quote the filtered peak"));
  EXPECT_FALSE(says(lines, "Do not use single steps"));
}

/// A small residual may stand beside a wrong load of a step.
TEST(Answer, WarnsOfSingleStepsWhoseLoadIsFarOff) {
  SceneReport report = report_of_two(0.5);
  report.found.choice.chosen = 1;
  report.found.reference.std.mean = 10;
  report.found.reference.p99.mean = 150;
  Merit& best = report.found.merits[1];
  best.law_map_m_s = 1e-3;
  best.step_load_median = 0.3;
  best.step_load_p95 = 0.05;
  EXPECT_FALSE(says(detail_lines(report), "Do not use single steps"));
  best.step_load_p95 = 0.6;
  EXPECT_TRUE(says(detail_lines(report),
                   "Do not use single steps and raw peaks of \"newton\": by a second, strict solution the load of one "
                   "step is off by 30 % in the median and by 60 % in the 95th percentile. Its residual of 1.0e-03 m/s "
                   "does not show this."));
}

TEST(Answer, SaysHowOftenEstimatedErrorsHeld) {
  SceneReport report = report_of_two(0.5);
  report.found.coverage = report.found.coverage_alone = Coverage{28, 24.0 / 28, 3.4};
  EXPECT_TRUE(says(detail_lines(report),
                   "The error of a run's mean load that is estimated from all runs was at least as large as the "
                   "measured error in 24 of 28 runs. In half of them it was more than 3.4 times the measured error."));
}

}  // namespace answer_test
