/// How a budget goes to the runs of a comparison, on machines that exist in numbers only: none of this looks at a
/// clock.
#include "apps/compare/scenes/run/allotment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace allotment_test {

using namespace nilas;
using namespace nilas::compare;

constexpr double k_start = 0, k_end = 10, k_ice = 2.5;  // simulated [s]

/// An ablation of six settings whose runs are thought to take 5 s each, as planned on an idle machine.
Plan ablation(double estimate = 5, int realisations = 1) {
  Plan plan;
  plan.start = k_start;
  plan.end = plan.scene_end = k_end;
  plan.realisations = realisations;
  plan.settings.assign(6, {"auto", "coulomb", "moreau", "projection", 0.01, 1e-4});
  for (int r = 0; r < realisations; ++r) {
    const auto id = [&](std::size_t k) { return "s" + std::to_string(k) + "-r" + std::to_string(r); };
    plan.runs.push_back({id(0), RunKind::grid, 0, r, estimate});
    plan.runs.push_back({id(1), RunKind::grid, 1, r, estimate});
    plan.runs.push_back({id(0) + "-twin", RunKind::twin, 0, r, estimate});
    for (std::size_t k = 2; k < plan.settings.size(); ++k) plan.runs.push_back({id(k), RunKind::grid, k, r, estimate});
  }
  return plan;
}

/// Outcome of the runs of a plan.
struct Course {
  std::set<std::string> told;  ///< Runs that reached the time over which all are compared.
  double ended_s = 0;          ///< End of the last run [s].
  double end = 0;              ///< Simulated time over which all runs are compared.
  std::vector<Omission> omissions;
};

/// A machine on which a run takes `seconds` (of its setting, else of setting 0) over the whole planned time.
class Machine {
 public:
  Machine(std::map<std::size_t, double> seconds, int jobs) : seconds_(std::move(seconds)), jobs_(jobs) {}

  Course make(Plan plan, double budget) const {
    Allotment allotment(plan, budget, budget, jobs_, 1);
    std::vector<Running> running;
    std::map<std::string, double> reached;
    double now = 0;
    const auto end_first = [&] {
      const auto first = std::min_element(running.begin(), running.end(),
                                          [](const Running& a, const Running& b) { return a.ends_s < b.ends_s; });
      now = first->ends_s;
      RunEnd end = first->end;
      if (allotment.ended(first->run, end) != RunVerdict::too_slow && (end.done || end.timed_out))
        reached[first->run.id] = end.reached_s;
      running.erase(first);
    };
    for (const PlannedRun& run : std::vector<PlannedRun>(plan.runs)) {
      while (static_cast<int>(running.size()) == jobs_) end_first();
      const RunStart start = allotment.begin(run, now);
      if (start.begins) running.push_back(started(run, start.limit_s, plan.end, now));
    }
    while (!running.empty()) end_first();
    Course course{{}, now, plan.end, plan.omissions};
    for (const auto& [id, t] : reached)
      if (t >= plan.end - 1e-9) course.told.insert(id);
    return course;
  }

 private:
  struct Running {
    PlannedRun run;
    double ends_s = 0;
    RunEnd end;
  };

  Running started(const PlannedRun& run, double limit, double end, double now) const {
    const auto own = seconds_.find(run.setting);
    const double whole = own == seconds_.end() ? seconds_.at(0) : own->second;
    const double wanted = whole * (end - k_start) / (k_end - k_start);
    const bool cut = limit > 0 && limit < wanted;
    RunEnd ended{.wall_s = cut ? limit : wanted, .done = !cut, .timed_out = cut};
    ended.reached_s = cut ? k_start + (k_end - k_start) * limit / whole : end;
    if (ended.reached_s > k_ice) ended.window_from_s = k_ice;
    return {run, now + ended.wall_s, ended};
  }

  std::map<std::size_t, double> seconds_;
  int jobs_;
};

TEST(Allotment, LeavesAPlanThatFitsAsItIs) {
  for (const int jobs : {1, 2}) {
    const Course course = Machine({{0, 5}}, jobs).make(ablation(), 60);
    EXPECT_EQ(course.told.size(), 7U) << jobs;
    EXPECT_EQ(course.end, k_end);
    EXPECT_TRUE(course.omissions.empty());
  }
}

TEST(Allotment, OnAMachineSixTimesSlowerTellsAllOverLessTime) {
  const Course course = Machine({{0, 30}}, 2).make(ablation(), 100);
  EXPECT_EQ(course.told.size(), 7U);
  EXPECT_LT(course.end, 9);
  EXPECT_GT(course.end, 4);
  EXPECT_LE(course.ended_s, 100);
  ASSERT_EQ(course.omissions.size(), 1U);
  EXPECT_TRUE(course.omissions[0].what.starts_with("simulated time from ")) << course.omissions[0].what;
}

TEST(Allotment, GivesUpTheLastSettingsBeforeMostOfTheWindow) {
  for (const int jobs : {1, 2}) {
    const Course course = Machine({{0, 40}}, jobs).make(ablation(), jobs == 1 ? 120 : 75);
    EXPECT_NEAR(course.end, k_ice + 0.25 * (k_end - k_ice), 0.01) << jobs << ": to a step";
    EXPECT_TRUE(course.told.count("s1-r0")) << jobs;
    EXPECT_TRUE(course.told.count("s0-r0-twin")) << jobs;
    EXPECT_FALSE(course.told.count("s5-r0")) << jobs;
  }
}

TEST(Allotment, CutsTheTimeOnForTheTwinThatTellsChance) {
  const Course course = Machine({{0, 40}}, 2).make(ablation(), 60);
  EXPECT_TRUE(course.told.count("s0-r0-twin"));
  EXPECT_LT(course.end, k_ice + 0.25 * (k_end - k_ice) - 0.02);
}

TEST(Allotment, WhateverTheMachineTheFirstAndTheOneThatMattersMostAreToldTogether) {
  for (const int jobs : {1, 2})
    for (const double slower : {1.0, 2.0, 5.0, 8.0, 12.0, 18.0, jobs * 16.0}) {
      const Course course = Machine({{0, 5 * slower}}, jobs).make(ablation(), 60);
      EXPECT_TRUE(course.told.count("s0-r0")) << jobs << " jobs, " << slower;
      EXPECT_TRUE(course.told.count("s1-r0")) << jobs << " jobs, " << slower;
      EXPECT_GE(course.end, k_ice + 0.2 - 1e-9) << jobs << " jobs, " << slower;
      EXPECT_LE(course.ended_s, 60 + 1e-9) << jobs << " jobs, " << slower;
    }
}

/// Mission: the pyramid took over 42 s where the cone takes 15.
TEST(Allotment, KeepsTheOneThatMattersMostWhereItIsFarSlowerThanThought) {
  for (const int jobs : {1, 2}) {
    const Course course = Machine({{0, 15}, {1, 60}}, jobs).make(ablation(), 100);
    EXPECT_TRUE(course.told.count("s0-r0")) << jobs;
    EXPECT_TRUE(course.told.count("s1-r0")) << jobs;
    EXPECT_GT(course.end, 4) << jobs;
    EXPECT_GE(course.told.size(), jobs == 1 ? 2U : 5U);
  }
}

TEST(Allotment, DoesNotCutAllToTheFirstSecondsOfOneThatNeverGetsOn) {
  const Course course = Machine({{0, 10}, {1, 2000}}, 2).make(ablation(), 100);
  EXPECT_FALSE(course.told.count("s1-r0"));
  EXPECT_EQ(course.end, k_end);
  EXPECT_EQ(course.told.size(), 6U);
}

TEST(Allotment, LetsAnotherSettingThatIsTooSlowGo) {
  const Course course = Machine({{0, 5}, {3, 500}}, 2).make(ablation(5, 2), 100);
  EXPECT_FALSE(course.told.count("s3-r0"));
  EXPECT_FALSE(course.told.count("s3-r1"));
  EXPECT_EQ(course.told.size(), 12U);
  EXPECT_EQ(course.end, k_end);
}

TEST(Allotment, TellsNothingBeforeThereIsIce) {
  const Course course = Machine({{0, 5 * 60}}, 2).make(ablation(), 60);
  EXPECT_EQ(course.end, k_end) << "no load within the time that was reached";
  EXPECT_TRUE(course.told.empty());
}

TEST(Allotment, TellsARunThatIsTooLongForWhatIsLeftFromABudgetThatIsUsedUp) {
  Plan plan = ablation();
  const PlannedRun last = plan.runs.back();
  Allotment allotment(plan, 30, 30, 1, 1);
  const RunStart refused = allotment.begin(last, 24);
  EXPECT_FALSE(refused.begins);
  EXPECT_TRUE(refused.too_long());
  EXPECT_DOUBLE_EQ(refused.expected_s, 5);
  EXPECT_DOUBLE_EQ(refused.left_s, 3) << "3 s are kept for the end";
  const RunStart late = allotment.begin(last, 28);
  EXPECT_FALSE(late.begins);
  EXPECT_FALSE(late.too_long());
  EXPECT_FALSE(allotment.begin(last, 10).too_long());
}

TEST(Allotment, ExpectsWhatRunsTookAndNotWhatWasEstimated) {
  Plan plan = ablation(50);
  Allotment allotment(plan, 100, 100, 1, 1);
  const PlannedRun first = plan.runs.front(), last = plan.runs.back();
  EXPECT_TRUE(allotment.begin(last, 60).too_long());
  allotment.ended(first, {.wall_s = 5, .done = true, .reached_s = k_end, .window_from_s = k_ice});
  EXPECT_TRUE(allotment.begin(last, 60).begins) << "the first took a tenth of its estimate";
}

TEST(Allotment, CutsTheTimeOfStepsAndNotOfSetUp) {
  Plan plan = ablation();  // 4 s of set-up and 1 s of steps each
  plan.setup_s = 4;
  Allotment allotment(plan, 40, 40, 1, 1);
  allotment.begin(plan.runs[0], 0);
  allotment.ended(plan.runs[0], {.wall_s = 5, .done = true, .reached_s = k_end, .window_from_s = k_ice});
  allotment.begin(plan.runs[1], 5);
  // six runs have 0.9 of 32 s, of which 24 s are set-up
  EXPECT_NEAR(plan.end, k_end * 4.8 / 6, 0.01);
}

TEST(Allotment, DoesNotMultiplyTheSetUpInTheBudgetThatWouldDo) {
  Plan plan = ablation();
  plan.setup_s = 4;
  const RunEnd met{.wall_s = 5, .timed_out = true, .reached_s = 2, .window_from_s = k_ice};
  // 4 s, and 0.5 s for each of 2.7 s; a reserve of 1.2, 80 % of the budget for the first run and 3 s for the end
  EXPECT_DOUBLE_EQ(*needed_budget(plan, met, 0, 2), 12);
}

TEST(Allotment, SaysWhatBudgetWouldDo) {
  const Plan plan = ablation();
  for (const int jobs : {1, 2})
    for (const double slower : {1.0, 60.0, 300.0}) {
      const RunEnd met{.wall_s = 27, .timed_out = true, .reached_s = 3, .window_from_s = k_ice};
      const auto enough = needed_budget(plan, met, 0, jobs);
      ASSERT_TRUE(enough.has_value());
      const Course course = Machine({{0, 90}}, jobs).make(plan, *enough);
      EXPECT_TRUE(course.told.count("s0-r0") && course.told.count("s1-r0")) << jobs << ", " << *enough;
      RunEnd none;
      none.timed_out = true;
      none.wall_s = 5 * slower;
      none.reached_s = k_end;
      const auto for_all = needed_budget(plan, none, 0, jobs);
      ASSERT_TRUE(for_all.has_value());
      const Course whole = Machine({{0, 5 * slower}}, jobs).make(plan, *for_all);
      EXPECT_TRUE(whole.told.count("s0-r0") && whole.told.count("s1-r0")) << jobs << ", " << *for_all;
    }
  EXPECT_FALSE(needed_budget(plan, RunEnd{}, 0, 2).has_value());
}

}  // namespace allotment_test
