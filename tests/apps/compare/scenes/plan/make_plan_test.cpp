/// Tests of the plan for a time budget: everything that fits is kept, the least informative runs go first, and all
/// dropped runs are named.
#include "apps/compare/scenes/plan/make_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace make_plan_test {

using namespace nilas;
using namespace nilas::compare;

/// A scene of 60 s at 0.01 s whose first second costs 1 s and each further one 2 s, half of it in the solver.
CostModel cost() {
  CostModel model;
  model.setup_s = 0.5;
  model.rate = {{1, 0.5, 0.5}, {3, 1, 1}};
  model.reference = {{1e-10, 10}, {1e-7, 2}};
  return model;
}

const CompareSetting k_own{"auto", "coulomb", "moreau", "projection", 0.01, 1e-6};

std::vector<CompareSetting> settings() {
  std::vector<CompareSetting> all{k_own, k_own, k_own, k_own};
  all[1].step = 0.02;
  all[2].solver = "ipm";
  all[3].solver = "pgs";
  all[3].step = 0.02;
  return all;
}

CompareSetting reference() {
  CompareSetting setting = k_own;
  setting.solver = "newton";
  setting.step = 0.005;
  setting.tolerance = 1e-10;
  return setting;
}

Plan plan(double budget, int jobs = 2, bool fixed = false, PlanRequest request = {}) {
  request.budget_s = request.stated_budget_s = budget;
  request.jobs = jobs;
  request.end = 60;
  request.fixed_realisations = fixed;
  return make_plan({settings(), 3, reference(), cost(), request});
}

/// The scene solves to 1e-4 m/s. The plan adds 1e-6 and 1e-2, and the tighter tolerance is expensive.
Plan loose_plan(double budget, bool fixed_tolerances, bool fixed_reference = false) {
  std::vector<CompareSetting> all(4, k_own);
  for (auto& setting : all) setting.tolerance = 1e-4;
  all[1].tolerance = 1e-2;
  all[2].tolerance = 1e-6;
  all[3].solver = "pgs";
  CostModel dear = cost();
  dear.reference = {{1e-10, 50}, {1e-7, 40}, {1e-5, 4}};
  PlanRequest request;
  request.budget_s = request.stated_budget_s = budget;
  request.end = 60;
  request.fixed_tolerances = fixed_tolerances;
  request.fixed_reference = fixed_reference;
  return make_plan({all, 4, reference(), dear, request});
}

double runs_total(const Plan& plan) {
  return std::accumulate(plan.runs.begin(), plan.runs.end(), 0.0,
                         [](double sum, const PlannedRun& run) { return sum + run.estimate_s; });
}

TEST(Cost, OfARunGoesOnAsItsLastStretch) {
  EXPECT_DOUBLE_EQ(cost().steps_seconds(0.5), 0.5);
  EXPECT_DOUBLE_EQ(cost().steps_seconds(2), 1 + 2);
  EXPECT_DOUBLE_EQ(cost().steps_seconds(10), 1 + 18);
  EXPECT_DOUBLE_EQ(cost().steps_seconds(2, 3), 2 + 4);
}

TEST(Cost, OfASolveGoesWithSolverAndTolerance) {
  const auto all = settings();
  EXPECT_DOUBLE_EQ(solver_weight(all[0], all[0]), 1);
  EXPECT_GT(solver_weight(all[2], all[0]), 1);
  EXPECT_LT(solver_weight(all[3], all[0]), 1);
  CompareSetting tight = all[0];
  tight.tolerance = 1e-8;
  EXPECT_GT(solver_weight(tight, all[0]), 1);
}

TEST(Plan, WithoutALimitHasEverythingWithATwinOfEachRealisation) {
  const Plan all = plan(0);
  EXPECT_TRUE(all.omissions.empty());
  EXPECT_EQ(all.end, 60);
  // 4 settings, 3 realisations, 3 perturbed runs, 3 references and one of double its step.
  EXPECT_EQ(all.runs.size(), 12U + 3 + 3 + 1);
  EXPECT_EQ(all.check.step, 0.01);
  EXPECT_EQ(all.reference.tolerance, 1e-10);
}

TEST(Plan, FitsTheBudgetWhateverItIs) {
  for (const double budget : {5000.0, 1200.0, 300.0, 60.0}) {
    const Plan cut = plan(budget);
    EXPECT_LE(runs_total(cut), 2 * budget) << budget;
    EXPECT_FALSE(cut.omissions.empty()) << budget;
    EXPECT_EQ(cut.settings.front(), k_own) << budget;
  }
}

TEST(Plan, GivesUpSettingsBeyondTheCoreBeforeSimulatedTime) {
  const double full = runs_total(plan(0));
  const Plan cut = plan(0.9 * full / 2 / 0.85);
  EXPECT_EQ(cut.end, 60);
  ASSERT_FALSE(cut.omissions.empty());
  EXPECT_LT(plan(300).end, 60);
  EXPECT_GE(plan(300).settings.size(), 3U);
}

TEST(Plan, LoosensTheReferenceBeforeItCutsTime) {
  const Plan cut = plan(1200);
  EXPECT_GT(cut.reference.tolerance, 1e-10);
  EXPECT_LE(cut.reference.tolerance, 1.001e-7);
  EXPECT_TRUE(std::any_of(cut.omissions.begin(), cut.omissions.end(),
                          [](const Omission& o) { return o.what.find("the reference at 1e-10") == 0; }));
}

TEST(Plan, GivesUpTighterSolvesAndTheReferenceThatTheyNeedForSimulatedTime) {
  const Plan cut = loose_plan(3000, false);
  EXPECT_EQ(cut.settings.size(), 3U);
  EXPECT_NEAR(cut.reference.tolerance, 1e-5, 1e-10);
  EXPECT_TRUE(std::any_of(cut.omissions.begin(), cut.omissions.end(),
                          [](const Omission& o) { return o.what.find("tolerance 1e-06 m/s") == 0; }));
  const Plan kept = loose_plan(3000, true);
  EXPECT_LE(kept.reference.tolerance, 1.001e-7);
  EXPECT_LT(kept.end, cut.end);
  EXPECT_EQ(loose_plan(3000, true, true).reference.tolerance, 1e-10);
}

TEST(Cost, OfTheReferenceLiesBetweenWhatWasMeasured) {
  EXPECT_DOUBLE_EQ(cost().reference_weight(1e-12), 10);
  EXPECT_DOUBLE_EQ(cost().reference_weight(1e-10), 10);
  EXPECT_NEAR(cost().reference_weight(std::pow(10, -8.5)), std::sqrt(20), 1e-9);
  EXPECT_DOUBLE_EQ(cost().reference_weight(1e-4), 2);
  EXPECT_EQ(CostModel{}.reference_weight(1e-4), 1);
}

TEST(Plan, KeepsTheUsersNumberOfRealisations) {
  EXPECT_EQ(plan(200).realisations, 2);
  EXPECT_EQ(plan(200, 2, true).realisations, 3);
}

TEST(Plan, WithNextToNoBudgetStillHasTheFirstSettingAndItsReference) {
  const Plan cut = plan(1);
  ASSERT_EQ(cut.settings.size(), 1U);
  EXPECT_GT(cut.end, 0);
  EXPECT_TRUE(
      std::any_of(cut.runs.begin(), cut.runs.end(), [](const auto& r) { return r.kind == RunKind::reference; }));
}

/// An ablation: the first setting judges, the others stand in the order of their importance.
Plan ablation(double budget, double window_from = std::numeric_limits<double>::quiet_NaN()) {
  PlanRequest request;
  request.budget_s = request.stated_budget_s = budget;
  request.end = 60;
  request.reference = request.check = false;
  CostModel model = cost();
  model.window_from = window_from;
  return make_plan({std::vector<CompareSetting>(16, k_own), 16, {}, model, request});
}

TEST(Plan, OfAnAblationGivesUpTheLastSettingsBeforeMostOfTheWindow) {
  for (const double budget : {2000.0, 600.0, 300.0}) {
    const Plan cut = ablation(budget, 20);
    EXPECT_LE(runs_total(cut), 2 * budget) << budget;
    EXPECT_GE(cut.end, 20 + 0.2 * 40) << budget << ": a quarter of the window, in two digits";
    EXPECT_GE(cut.settings.size(), 2U) << budget;
  }
  EXPECT_LT(ablation(300, 20).settings.size(), 16U);
  EXPECT_EQ(ablation(300, 20).realisations, 1);
  const Plan least = ablation(100, 20);
  EXPECT_EQ(least.settings.size(), 2U) << "base and the one that matters most";
  EXPECT_GE(least.end, 20.2 - 1e-9);
}

TEST(Plan, OfAnAblationRunsTheOneThatMattersMostBesideTheFirst) {
  const Plan all = ablation(0);
  EXPECT_EQ(all.runs[0].id, "s00-r0");
  EXPECT_EQ(all.runs[1].id, "s01-r0");
  EXPECT_EQ(all.runs[2].id, "s00-r0-twin");
  EXPECT_EQ(all.runs.size(), 3U * 17);
}

TEST(Plan, StoresStatesAtTimesThatAllStepsShare) {
  const Plan all = plan(0);
  const double samples = all.sample_every / 0.02;
  EXPECT_NEAR(samples, std::round(samples), 1e-9);
  EXPECT_NEAR(60 / all.sample_every, 60, 1);
}

TEST(Plan, NamesEveryRunOnce) {
  std::set<std::string> ids;
  const Plan all = plan(0);
  for (const auto& run : all.runs) ids.insert(run.id);
  EXPECT_EQ(ids.size(), all.runs.size());
}

TEST(Plan, RunsAllOfOneRealisationBeforeTheNextAndTellsChanceFirst) {
  const Plan all = plan(0);
  std::vector<std::string> ids;
  for (const auto& run : all.runs) ids.push_back(run.id);
  EXPECT_EQ(std::vector<std::string>(ids.begin(), ids.begin() + 13),
            (std::vector<std::string>{"reference-r0", "s00-r0", "s00-r0-twin", "check-r0", "s01-r0", "s02-r0", "s03-r0",
                                      "s00-r1", "s00-r1-twin", "reference-r1", "s01-r1", "s02-r1", "s03-r1"}));
}

TEST(Plan, SaysWhatBudgetLeavesNothingOut) {
  const Plan cut = plan(300);
  EXPECT_GT(cut.whole_s, 300);
  EXPECT_TRUE(plan(1.001 * cut.whole_s).omissions.empty());
  EXPECT_FALSE(plan(0.9 * cut.whole_s).omissions.empty());
}

TEST(Plan, GrowsByRealisationsOfTheSameRuns) {
  Plan more = plan(0);
  const std::size_t before = more.runs.size();
  extend_realisations(more, 5);
  EXPECT_EQ(more.realisations, 5);
  EXPECT_EQ(more.runs.size(), before + 2 * 6) << "four settings, a twin and a reference, no check";
  std::set<std::string> ids;
  for (const auto& run : more.runs) ids.insert(run.id);
  EXPECT_EQ(ids.size(), more.runs.size());
  EXPECT_EQ(more.runs.back().realisation, 4);
  EXPECT_TRUE(ids.count("s00-r4-twin"));
  extend_realisations(more, 2);
  EXPECT_EQ(more.realisations, 5);
}

TEST(Realisation, ZeroIsTheSceneItselfAndATwinHasItsSeed) {
  EXPECT_EQ(realisation_overrides(7, {"", RunKind::grid, 0, 0, 0}, true),
            (scene::Overrides{{"seed/@value", "7"}, {"seed/@twin", "0"}}));
  EXPECT_EQ(realisation_overrides(7, {"", RunKind::grid, 3, 2, 0}, true)[0].second, "9");
  EXPECT_EQ(realisation_overrides(7, {"", RunKind::twin, 0, 2, 0}, true)[0].second, "9");
  EXPECT_NE(realisation_overrides(7, {"", RunKind::twin, 0, 2, 0}, true)[1].second,
            realisation_overrides(7, {"", RunKind::grid, 0, 2, 0}, true)[1].second);
  EXPECT_EQ(realisation_overrides(7, {"", RunKind::grid, 0, 2, 0}, false)[0].second, "7");
}

}  // namespace make_plan_test
