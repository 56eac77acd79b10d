/// Tests of the ranking of settings by error and time, with hand-made figures.
#include "apps/compare/scenes/judge/ranking.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ranking_test {

using namespace nilas;
using namespace nilas::compare;

/// A setting that ran well: time [s/s], error, and the floor above which the error is significant.
Merit merit(std::size_t setting, double time, double error, double floor = 0.1) {
  Merit m;
  m.setting = setting;
  m.planned = m.done = 3;
  m.time = time;
  m.error = error;
  m.floor = floor;
  m.significant = error > floor;
  return m;
}

Findings findings(const std::vector<Merit>& merits, double scale = 10) {
  Findings found;
  found.merits = merits;
  found.measure.scale = scale;
  found.time_spread = 0.05;
  return found;
}

TEST(Ranking, OneThatIsSlowerAndWorseIsBeaten) {
  Findings found = findings({merit(0, 1, 1), merit(1, 2, 0.5), merit(2, 2, 2), merit(3, 0.5, 3)});
  found.merits = with_dominance(found.merits);
  EXPECT_FALSE(found.merits[0].dominated);
  EXPECT_FALSE(found.merits[1].dominated);
  EXPECT_TRUE(found.merits[2].dominated);
  EXPECT_FALSE(found.merits[3].dominated);
}

TEST(Ranking, ErrorsBelowTheFloorAreAlike) {
  Findings found = findings({merit(0, 1, 0.05), merit(1, 2, 0.01)});
  found.merits = with_dominance(found.merits);
  EXPECT_FALSE(found.merits[0].dominated);
  EXPECT_TRUE(found.merits[1].dominated);
}

TEST(Ranking, WhatFailedBeatsNothing) {
  Findings found = findings({merit(0, 1, 1), merit(1, 0.1, 0.2)});
  found.merits[1].failed = 1;
  found.merits = with_dominance(found.merits);
  EXPECT_FALSE(found.merits[0].dominated);
  EXPECT_TRUE(found.merits[1].dominated);
  found.choice = choose(found.merits, found.measure, found.common_floor, found.time_spread);
  EXPECT_FALSE(found.choice.chosen);
}

TEST(Choice, IsTheFastestWithinTwoPercent) {
  Findings found = findings({merit(0, 1, 0.15), merit(1, 0.5, 0.19), merit(2, 0.1, 0.21)});
  found.choice = choose(found.merits, found.measure, found.common_floor, found.time_spread);
  EXPECT_EQ(found.choice.chosen, 1U);
}

TEST(Choice, IsTheScenesOwnWhereNothingIsSurelyFaster) {
  Findings found = findings({merit(0, 1, 0.19), merit(1, 0.95, 0.12)});
  found.choice = choose(found.merits, found.measure, found.common_floor, found.time_spread);
  EXPECT_EQ(found.choice.chosen, 0U);
  EXPECT_EQ(found.choice.faster, 1U) << "by 5 %, where times scatter by as much";
}

TEST(Choice, IsTheMostAccurateOfThoseThatAreAsFast) {
  Findings found = findings({merit(0, 2, 0.15), merit(1, 1, 0.19), merit(2, 1.05, 0.12)});
  found.choice = choose(found.merits, found.measure, found.common_floor, found.time_spread);
  EXPECT_EQ(found.choice.chosen, 2U);
  EXPECT_EQ(found.choice.faster, 1U);
}

TEST(Choice, NamesNoFasterOneWhereTheFastestIsChosen) {
  Findings found = findings({merit(0, 2, 0.15), merit(1, 1, 0.12), merit(2, 0.9, 0.5)});
  found.choice = choose(found.merits, found.measure, found.common_floor, found.time_spread);
  EXPECT_EQ(found.choice.chosen, 1U);
  EXPECT_FALSE(found.choice.faster) << "the other one is not as accurate";
}

TEST(Choice, CountsTimesAsAlikeWithinThreeStandardDeviationsOfTheirRatio) {
  EXPECT_NEAR(std::log(significant_speed_ratio(0.05)), 3 * std::sqrt(0.05 * 0.05 + 0.05 * 0.05), 1e-12);
  EXPECT_EQ(significant_speed_ratio(std::nan("")), significant_speed_ratio(0.1)) << "not measured";
}

TEST(Choice, IsNoneThatSinksIn) {
  Findings found = findings({merit(0, 2, 0.15), merit(1, 1, 0.15)});
  found.merits[0].penetration_max_m = 1e-3;
  found.merits[1].penetration_max_m = 3e-3;
  found.choice = choose(found.merits, found.measure, found.common_floor, found.time_spread);
  EXPECT_EQ(found.choice.chosen, 0U);
  EXPECT_EQ(found.choice.deeper, 1U);
}

/// Four settings: the scene's own, a coarser step, a looser tolerance, and both.
Plan plan_of_both() {
  Plan plan;
  plan.settings.assign(4, {"auto", "coulomb", "moreau", "projection", 0.01, 1e-4});
  for (const std::size_t k : {1U, 3U}) plan.settings[k].step = 0.02;
  for (const std::size_t k : {2U, 3U}) plan.settings[k].tolerance = 1e-2;
  return plan;
}

TEST(Choice, IsNoneOfWhichAPartAloneIsFarOff) {
  Findings found = findings({merit(0, 2, 0.05), merit(1, 1, 0.15), merit(2, 1, 0.9), merit(3, 0.5, 0.05)});
  found.merits = with_faulty_parts(plan_of_both(), found.measure, found.merits);
  EXPECT_FALSE(found.merits[0].faulty_part || found.merits[1].faulty_part || found.merits[2].faulty_part);
  EXPECT_EQ(found.merits[3].faulty_part, 2U);
  found.choice = choose(found.merits, found.measure, found.common_floor, found.time_spread);
  EXPECT_EQ(found.choice.chosen, 1U);
  EXPECT_EQ(found.choice.by_luck, 3U);
}

TEST(Choice, TakesACombinationWhosePartsAreFaultless) {
  Findings found = findings({merit(0, 2, 0.05), merit(1, 1, 0.15), merit(2, 1, 0.9, 1.0), merit(3, 0.5, 0.05)});
  found.merits = with_faulty_parts(plan_of_both(), found.measure, found.merits);
  EXPECT_FALSE(found.merits[3].faulty_part) << "an error that may be chance is no fault";
  found.choice = choose(found.merits, found.measure, found.common_floor, found.time_spread);
  EXPECT_EQ(found.choice.chosen, 3U);
  EXPECT_FALSE(found.choice.by_luck);
}

TEST(Choice, CountsAPartAsFaultlessThatIsAsFarOffAsTheScenesOwn) {
  Findings found = findings({merit(0, 2, 0.9), merit(1, 1, 0.95), merit(2, 1, 1.05), merit(3, 0.5, 0.05)});
  found.merits = with_faulty_parts(plan_of_both(), found.measure, found.merits);
  EXPECT_FALSE(found.merits[3].faulty_part);
}

TEST(Choice, NamesTheLuckyOneWhereNoOtherIsAccurate) {
  Findings found = findings({merit(0, 2, 0.5), merit(1, 1, 0.5), merit(2, 1, 0.9), merit(3, 0.5, 0.05)});
  found.merits = with_faulty_parts(plan_of_both(), found.measure, found.merits);
  found.choice = choose(found.merits, found.measure, found.common_floor, found.time_spread);
  EXPECT_FALSE(found.choice.chosen);
  EXPECT_EQ(found.choice.by_luck, 3U);
}

TEST(Orders, AreSlopesOverThreeStepsThatTellAnError) {
  Plan plan;
  const CompareSetting own{"auto", "coulomb", "moreau", "projection", 0.04, 1e-6};
  Findings found = findings({});
  for (std::size_t k = 0; k < 3; ++k) {
    plan.settings.push_back(own);
    plan.settings.back().step = 0.04 / std::pow(2, k);
    found.merits.push_back(merit(k, 1, 8 * std::pow(0.25, k)));
  }
  found.orders = orders_of(plan, found);
  ASSERT_EQ(found.orders.size(), 1U);
  EXPECT_NEAR(found.orders[0].order, 2, 1e-6);
  EXPECT_EQ(found.orders[0].rest, "own setting");
  found.orders.clear();
  // a reference of the same kind, with half the finest step, is off by as much of it as its step says
  plan.reference = own;
  plan.reference.step = 0.005;
  for (std::size_t k = 0; k < 3; ++k) found.merits[k].error -= 8 * std::pow(0.25, 3);
  found.orders = orders_of(plan, found);
  EXPECT_NEAR(found.orders[0].order, 2, 1e-6);
  found.orders.clear();
  found.merits[2].significant = false;
  found.orders = orders_of(plan, found);
  EXPECT_TRUE(found.orders.empty());
}

}  // namespace ranking_test
