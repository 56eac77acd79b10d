/// Tests of the expected run times, with hand-made times.
#include "apps/compare/scenes/run/pace.h"

#include <gtest/gtest.h>

namespace pace_test {

using namespace nilas;
using namespace nilas::compare;

PlannedRun run(const std::string& id, RunKind kind, std::size_t setting, int realisation, double estimate) {
  return {id, kind, setting, realisation, estimate};
}

TEST(Pace, BeforeAnyRunIsThatOfTheEstimates) {
  EXPECT_DOUBLE_EQ(Pace().expected_s(run("a", RunKind::grid, 1, 0, 3)), 3);
  EXPECT_DOUBLE_EQ(Pace(2).expected_s(run("a", RunKind::grid, 1, 0, 3)), 6) << "two share a core";
}

TEST(Pace, IsThatOfTheSameSettingElseOfItsKindElseOfAll) {
  Pace pace;
  pace.took(run("s00-r0", RunKind::grid, 0, 0, 1), 2);
  pace.took(run("s01-r0", RunKind::grid, 1, 0, 2), 10);
  EXPECT_DOUBLE_EQ(pace.expected_s(run("s01-r1", RunKind::grid, 1, 1, 2)), 10);
  EXPECT_DOUBLE_EQ(pace.expected_s(run("s00-r0-twin", RunKind::twin, 0, 0, 1)), 2);
  EXPECT_DOUBLE_EQ(pace.expected_s(run("s02-r0", RunKind::grid, 2, 0, 1)), 4) << "12 s where 3 s were estimated";
  EXPECT_DOUBLE_EQ(pace.expected_s(run("reference-r0", RunKind::reference, 0, 0, 5)), 20);
  pace.took(run("reference-r0", RunKind::reference, 0, 0, 5), 5);
  EXPECT_DOUBLE_EQ(pace.expected_s(run("check-r0", RunKind::check, 0, 0, 3)), 3) << "as the reference, not as settings";
}

TEST(Pace, KeepsTheSetUpWhateverTheSimulatedTime) {
  const PlannedRun half = run("s00-r0", RunKind::grid, 0, 0, 5), other = run("s01-r0", RunKind::grid, 1, 0, 14);
  Pace pace(1, 4);
  EXPECT_DOUBLE_EQ(pace.expected_s(half, 0.5), 4.5) << "4 s of set-up and half of 1 s";
  pace.took(half, 9, 0.5);  // twice as long as estimated
  EXPECT_DOUBLE_EQ(pace.expected_s(half), 10);
  EXPECT_DOUBLE_EQ(pace.expected_s(other), 28);
  EXPECT_DOUBLE_EQ(pace.expected_s(other, 0.5), 18) << "8 s of set-up and half of 20 s";
  EXPECT_DOUBLE_EQ(pace.expected_setup_s(other), 8);
}

TEST(Pace, OfAnEarlierSessionIsThatOfThePlanAsItIsNow) {
  Plan plan;
  plan.end = 3;
  plan.runs = {run("s00-r0", RunKind::grid, 0, 0, 6)};
  std::map<std::string, RunResult> results;
  results["s00-r0"].status = "done";
  results["s00-r0"].wall_s = 12;
  results["s00-r0"].summary.time_end_s = 6;
  Pace pace;
  pace.took(plan, results);
  EXPECT_DOUBLE_EQ(pace.expected_s(plan.runs[0]), 6) << "it went twice as far as the plan does by now";
}

TEST(Pace, TellsWhatIsLeft) {
  Plan plan;
  plan.runs = {run("s00-r0", RunKind::grid, 0, 0, 1), run("s01-r0", RunKind::grid, 1, 0, 1),
               run("s02-r0", RunKind::grid, 2, 0, 2), run("check-r0", RunKind::check, 0, 0, 9)};
  std::map<std::string, RunResult> results;
  results["s00-r0"].status = "done";
  results["s00-r0"].wall_s = 3;
  results["s01-r0"].status = "failed";
  Pace pace;
  pace.took(plan, results);
  EXPECT_DOUBLE_EQ(pace.factor(), 3);
  EXPECT_DOUBLE_EQ(pace.left_s(plan, results, 1), 6 + 27);
  EXPECT_DOUBLE_EQ(pace.left_s(plan, results, 2), 27) << "the longest is waited for";
  EXPECT_DOUBLE_EQ(pace.realisation_s(plan, 2), (3 + 3 + 6) / 2.0);
  EXPECT_DOUBLE_EQ(pace.left_s(plan, results, 1, 0.5), (6 + 27) / 2.0);
  EXPECT_DOUBLE_EQ(pace.realisation_s(plan, 2, 0.5), (3 + 3 + 6) / 4.0);
}

}  // namespace pace_test
