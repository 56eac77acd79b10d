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
}

}  // namespace pace_test
