/// Tests of the judged load deviations of runs, with hand-made loads.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "apps/compare/scenes/judge/judge.h"
#include "core/base/statistics.h"
#include "tests/support/scratch_folder.h"

namespace merits_test {

using namespace nilas;
using namespace nilas::compare;

constexpr double k_scale = 10;  // of the reference's load [N]

/// Settings at 0.02, 0.01, 0.005 s ... judged by a reference; loads as they are put in, all runs done in 1 s.
struct Runs {
  Plan plan;
  std::map<std::string, RunResult> results;

  Runs(std::size_t settings, int realisations) {
    plan.end = 1;
    plan.realisations = realisations;
    for (std::size_t s = 0; s < settings; ++s)
      plan.settings.push_back({"auto", "coulomb", "moreau", "projection", 0.02 / std::pow(2, s), 1e-6});
    plan.reference = plan.check = plan.settings.back();
    plan.reference.step *= 0.5;
  }
  void add(const std::string& id, RunKind kind, std::size_t setting, int realisation, double load) {
    plan.runs.push_back({id, kind, setting, realisation, 1});
    RunResult& result = results[id];
    result.status = "done";
    result.summary.loads = {{"ice_resistance_N", {load, 0, load, load}}};
  }
  void set(std::size_t setting, const std::vector<double>& off) {
    for (std::size_t r = 0; r < off.size(); ++r)
      add(fmt::format("s{}-r{}", setting, r), RunKind::grid, setting, static_cast<int>(r), -k_scale + off[r]);
  }
  void reference(const std::vector<double>& off) {
    for (std::size_t r = 0; r < off.size(); ++r)
      add(fmt::format("reference-r{}", r), RunKind::reference, 0, static_cast<int>(r), -k_scale + off[r]);
  }
  void twin(int realisation, double off) {
    add(fmt::format("twin-r{}", realisation), RunKind::twin, 0, realisation, -k_scale + off);
  }
  Findings judged(Judged by = Judged::by_reference) const { return judge_runs(plan, results, "nowhere", by); }
};

TEST(Merits, TellErrorsAboveStudentsLimitOfWhatTwinsDiffer) {
  Runs runs(2, 2);
  runs.set(0, {0.1, 0.1});
  runs.set(1, {0.5, 0.5});
  runs.reference({0, 0});
  runs.twin(0, 0.2);
  runs.twin(1, 0);
  const Findings found = runs.judged();
  EXPECT_EQ(found.headline, "ice_resistance_N");
  EXPECT_EQ(found.measure.scale, k_scale);
  EXPECT_NEAR(found.chance.run_N, 0.1 / std::sqrt(2), 1e-12);
  EXPECT_NEAR(found.common_floor, student_95(2) * 0.1 / std::sqrt(2), 1e-9);
  EXPECT_NEAR(found.merits[0].error, 0.1, 1e-12);
  EXPECT_FALSE(found.merits[0].significant);
  EXPECT_TRUE(found.merits[1].significant);
}

TEST(Merits, TellNothingWhereChaosWasNotMeasured) {
  Runs runs(2, 1);
  runs.set(0, {0.1});
  runs.set(1, {5});
  runs.reference({0});
  const Findings found = runs.judged();
  EXPECT_TRUE(std::isinf(found.common_floor));
  EXPECT_FALSE(found.horizon.known);
  for (const auto& m : found.merits) EXPECT_FALSE(m.significant);
  EXPECT_FALSE(found.choice.chosen);
}

TEST(Merits, OfASettingThatScattersMoreThanAllOthersAreHeldAgainstItsOwnScatter) {
  Runs runs(4, 3);
  runs.set(0, {0.11, 0.1, 0.09});
  runs.set(1, {0.1, 0.11, 0.1});
  runs.set(2, {0.1, 0.09, 0.11});
  runs.set(3, {2, -2, 3});
  runs.reference({0, 0, 0});
  for (int r = 0; r < 3; ++r) runs.twin(r, 0.1);
  const Findings found = runs.judged();
  EXPECT_TRUE(found.merits[1].significant);
  EXPECT_FALSE(found.merits[3].significant);
  EXPECT_NEAR(found.merits[3].floor, student_95(2) * std::sqrt(variance_of({2, -2, 3}) / 3), 1e-6);
  EXPECT_LT(found.merits[2].floor, 0.1);
}

TEST(Merits, OneRunThatAllAreJudgedByDoesNotAverageOut) {
  Runs many(2, 2), one(2, 2);
  for (Runs* runs : {&many, &one}) {
    runs->set(0, {0.1, 0.1});
    runs->set(1, {0.5, 0.5});
    runs->reference({0, 0});
    runs->twin(0, 0.2);
    runs->twin(1, 0);
  }
  EXPECT_NEAR(one.judged(Judged::by_one_run).common_floor / many.judged().common_floor, std::sqrt(0.75 / 0.5), 1e-9);
}

TEST(Merits, WithoutAReferenceAreJudgedByItsCheckThenByTheFinestSetting) {
  Runs runs(3, 1);
  runs.set(0, {0.4});
  runs.set(1, {0.2});
  runs.set(2, {0.1});
  runs.twin(0, 0.41);
  EXPECT_EQ(runs.judged().judges.stand_in, "\"step 0.005 s\"");
  EXPECT_NEAR(runs.judged().merits[0].error, 0.3, 1e-12);
  EXPECT_TRUE(runs.judged().merits[2].judges);
  runs.add("check-r0", RunKind::check, 0, 0, -k_scale);
  EXPECT_EQ(runs.judged().judges.stand_in, "the reference at twice its step");
  EXPECT_NEAR(runs.judged().merits[0].error, 0.4, 1e-12);
  runs.reference({0});
  EXPECT_TRUE(runs.judged().judges.stand_in.empty());
}

TEST(Merits, SayWhenTheReferenceMovesMoreThanTheSmallestErrorTold) {
  Runs runs(2, 1);
  runs.set(0, {0.2});
  runs.set(1, {0.5});
  runs.reference({0});
  runs.twin(0, 0.2);
  runs.add("check-r0", RunKind::check, 0, 0, -k_scale + 0.1);
  EXPECT_NEAR(*runs.judged().check.moves, 0.1, 1e-12);
  EXPECT_FALSE(runs.judged().check.coarse);
  runs.results.at("check-r0").summary.loads.front().second.mean = -k_scale + 0.3;
  EXPECT_TRUE(runs.judged().check.coarse);
}

TEST(Merits, OfASettingWithoutARunHoldNoFigures) {
  Runs runs(2, 1);
  runs.set(0, {0.2});
  runs.plan.runs.push_back({"s1-r0", RunKind::grid, 1, 0, 1});
  runs.reference({0});
  const Merit none = runs.judged().merits[1];
  EXPECT_EQ(none.done, 0);
  EXPECT_EQ(none.trouble, "not run");
  for (const double figure : {none.error, none.penetration_max_m, none.law_map_m_s, none.energy_error, none.time})
    EXPECT_TRUE(std::isnan(figure));
  runs.results["s1-r0"].cause = "not begun, because the budget had no room";
  EXPECT_EQ(runs.judged().merits[1].trouble, "not begun, because the budget had no room");
}

TEST(Merits, OfAnAblationAreJudgedByTheFirstSetting) {
  Runs runs(2, 2);
  runs.set(0, {0.1, 0.2});
  runs.set(1, {0.6, 0.7});
  runs.twin(0, 0.1);
  runs.twin(1, 0.2);
  const Findings found = runs.judged(Judged::by_first_setting);
  EXPECT_TRUE(found.merits[0].judges);
  EXPECT_EQ(found.merits[0].error, 0);
  EXPECT_NEAR(found.merits[1].error, 0.5, 1e-12);
  EXPECT_TRUE(found.merits[1].significant);
}

/// The case of a user's study: every exact setting within 3 % of the others, perturbed runs 36 N apart, the pyramid 20
/// % off.
Runs one_field() {
  Runs runs(4, 1);
  for (auto& setting : runs.plan.settings) setting.step = 0.02;
  runs.plan.settings[1].solver = "nsgs";
  runs.plan.settings[2].solver = "newton";
  runs.plan.settings[3].solver = "pgs";
  runs.plan.settings[3].law = "pyramid";
  const double loads[] = {3.40e5, 3.39e5, 3.42e5, 4.10e5};
  for (std::size_t s = 0; s < 4; ++s) runs.add(fmt::format("s{}-r0", s), RunKind::grid, s, 0, loads[s]);
  runs.add("twin-r0", RunKind::twin, 0, 0, 3.40e5 + 36);
  runs.add("reference-r0", RunKind::reference, 0, 0, 3.41e5);
  return runs;
}

TEST(Merits, TellASureDifferenceInTheOneFieldThatWasRun) {
  const Findings found = one_field().judged();
  const double limit = student_95(2) * std::sqrt(2 * variance_of({3.40e5, 3.39e5, 3.42e5}));
  for (const Merit& m : found.merits)
    for (const double of : m.from_own.limits) EXPECT_NEAR(of, limit, 1e-6) << "solvers part further than twins";
  EXPECT_EQ(found.merits[3].from_own.certainty, Certainty::in_realisations);
  EXPECT_NEAR(found.merits[3].from_own.mean, 0.7e5, 1e-6);
  EXPECT_EQ(found.merits[3].from_reference.certainty, Certainty::in_realisations);
  for (const std::size_t exact : {1U, 2U}) EXPECT_EQ(found.merits[exact].from_own.certainty, Certainty::none);
}

TEST(Merits, OfOneFieldSayNothingOfOtherFields) {
  Runs runs = one_field();
  runs.results.at("twin-r0").summary.loads.front().second.mean = 3.40e5 + 1e5;
  const Findings found = runs.judged();
  EXPECT_EQ(found.merits[3].from_own.certainty, Certainty::none) << "twins part by more than the pyramid does";
  EXPECT_FALSE(found.merits[3].significant);
}

TEST(Merits, MeansAreNeverOverOtherRealisationsUnmarked) {
  Runs runs(4, 2);
  for (std::size_t s = 0; s < 4; ++s) runs.set(s, {1});
  runs.reference({0, 50});
  runs.twin(0, 1.1);
  // the second realisation, whose ice is quite another, has two settings of four
  for (const std::size_t s : {0U, 1U}) runs.add(fmt::format("s{}-r1", s), RunKind::grid, s, 1, -k_scale + 51);
  const Findings half = runs.judged();
  EXPECT_EQ(half.shared, std::vector<int>{0});
  for (const Merit& m : half.merits) {
    EXPECT_NEAR(m.load.mean, -k_scale + 1, 1e-12);
    EXPECT_EQ(m.load.count, 1);
    EXPECT_EQ(m.load_difference.count, 1);
    EXPECT_FALSE(m.partial);
  }
  EXPECT_NEAR(half.reference.mean.mean, -k_scale, 1e-12);
  EXPECT_NEAR(half.measure.scale, k_scale, 1e-12);
  // With three settings of four the second one counts. The one without it is marked, and neither ranked nor chosen.
  runs.add("s2-r1", RunKind::grid, 2, 1, -k_scale + 51);
  const Findings most = runs.judged();
  EXPECT_EQ(most.shared, (std::vector<int>{0, 1}));
  for (const Merit& m : most.merits) {
    EXPECT_EQ(m.partial, m.setting == 3);
    EXPECT_EQ(m.realisations, m.partial ? (std::vector<int>{0}) : (std::vector<int>{0, 1}));
    EXPECT_NEAR(m.load_difference.mean, 1, 1e-12) << "differences are of the same ice all the same";
  }
  EXPECT_TRUE(most.merits[3].dominated);
  EXPECT_NE(most.choice.chosen, 3U);
}

TEST(Merits, OfSeveralRealisationsAreSureByStudent) {
  Runs runs(2, 3);
  runs.set(0, {1, 5, -3});
  runs.set(1, {2, 6.1, -2.1});
  runs.reference({0, 4, -4});
  const Merit other = runs.judged().merits[1];
  EXPECT_EQ(other.from_own.certainty, Certainty::everywhere);
  EXPECT_NEAR(other.from_own.mean, 1, 1e-12);
  EXPECT_NEAR(other.from_own.half_width, student_95(2) * std::sqrt(variance_of({1, 1.1, 0.9}) / 3), 1e-9);
}

/// Writes the load of a run step by step, ice from `touch` on.
void write_course(const std::filesystem::path& folder, const std::string& id, double step, double touch, double load) {
  std::filesystem::create_directories(folder / "runs" / id);
  std::ofstream file(folder / "runs" / id / "ice_load.csv");
  file << "time_s,ice_resistance_N,ice_side_N\n";
  for (int k = 1; k <= std::lround(1 / step); ++k) file << k * step << ',' << (k * step > touch ? load : 0) << ",0\n";
}

TEST(Merits, AreOverTheSameWindowWhateverAStepSaysOfTheFirstContact) {
  const nilas::test::ScratchFolder folder;
  Runs runs(2, 1);
  runs.set(0, {1});
  runs.set(1, {2});
  runs.reference({0});
  write_course(folder.path(), "s0-r0", 0.02, 0.521, 4);
  write_course(folder.path(), "s1-r0", 0.01, 0.511, 5);
  write_course(folder.path(), "reference-r0", 0.005, 0.509, 6);
  for (const auto& [id, from] : {std::pair("s0-r0", 0.5), std::pair("s1-r0", 0.5), std::pair("reference-r0", 0.505)})
    runs.results.at(id).summary.window = {from, 1.0, "from the first contact"};
  const Findings found = judge_runs(runs.plan, runs.results, folder.path(), Judged::by_reference);
  ASSERT_TRUE(found.windows[0]);
  EXPECT_NEAR(found.windows[0]->from, 0.5, 1e-12) << "where the coarsest step ends, before the reference's contact";
  EXPECT_NEAR(found.merits[0].load.mean, 4 * 0.48 / 0.5, 1e-9);
  EXPECT_NEAR(found.merits[1].load.mean, 5 * 0.49 / 0.5, 1e-9);
  EXPECT_NEAR(found.reference.mean.mean, 6 * 0.495 / 0.5, 1e-9);
  EXPECT_EQ(found.windows[0]->reason, "from the first contact");
}

}  // namespace merits_test
