/// What runs are judged to be off, by hand-made loads.
#include "apps/compare/scenes/merits.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "apps/compare/statistics.h"

namespace {

using namespace nilas;

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
    result.summary = {{"loads", {{"contact_fx_N", {{"mean", load}, {"std", 0}, {"max", load}, {"p99", load}}}}}};
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
  Findings judged(Judged by = Judged::by_reference) const { return find(plan, results, "nowhere", by); }
};

TEST(Merits, TellErrorsAboveStudentsLimitOfWhatTwinsDiffer) {
  Runs runs(2, 2);
  runs.set(0, {0.1, 0.1});
  runs.set(1, {0.5, 0.5});
  runs.reference({0, 0});
  runs.twin(0, 0.2);
  runs.twin(1, 0);
  const Findings found = runs.judged();
  EXPECT_EQ(found.headline, "contact_fx_N");
  EXPECT_EQ(found.scale, k_scale);
  EXPECT_NEAR(found.chaos, 0.1 / std::sqrt(2), 1e-12);
  EXPECT_NEAR(found.common_floor, student_95(2) * 0.1 / std::sqrt(2), 1e-9);
  EXPECT_NEAR(found.merits[0].error, 0.1, 1e-12);
  EXPECT_FALSE(found.merits[0].told);
  EXPECT_TRUE(found.merits[1].told);
}

TEST(Merits, TellNothingWhereChaosWasNotMeasured) {
  Runs runs(2, 1);
  runs.set(0, {0.1});
  runs.set(1, {5});
  runs.reference({0});
  const Findings found = runs.judged();
  EXPECT_TRUE(std::isinf(found.common_floor));
  EXPECT_FALSE(found.horizon_known);
  for (const auto& m : found.merits) EXPECT_FALSE(m.told);
  EXPECT_FALSE(found.chosen);
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
  EXPECT_TRUE(found.merits[1].told);
  EXPECT_FALSE(found.merits[3].told);
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
  EXPECT_EQ(runs.judged().stand_in, "\"0.005 s\"");
  EXPECT_NEAR(runs.judged().merits[0].error, 0.3, 1e-12);
  EXPECT_TRUE(runs.judged().merits[2].judges);
  runs.add("check-r0", RunKind::check, 0, 0, -k_scale);
  EXPECT_EQ(runs.judged().stand_in, "the reference at twice its step");
  EXPECT_NEAR(runs.judged().merits[0].error, 0.4, 1e-12);
  runs.reference({0});
  EXPECT_TRUE(runs.judged().stand_in.empty());
}

TEST(Merits, SayWhenTheReferenceMovesMoreThanTheSmallestErrorTold) {
  Runs runs(2, 1);
  runs.set(0, {0.2});
  runs.set(1, {0.5});
  runs.reference({0});
  runs.twin(0, 0.2);
  runs.add("check-r0", RunKind::check, 0, 0, -k_scale + 0.1);
  EXPECT_NEAR(*runs.judged().reference_moves, 0.1, 1e-12);
  EXPECT_FALSE(runs.judged().reference_coarse);
  runs.results.at("check-r0").summary["loads"]["contact_fx_N"]["mean"] = -k_scale + 0.3;
  EXPECT_TRUE(runs.judged().reference_coarse);
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
  EXPECT_TRUE(found.merits[1].told);
}

}  // namespace
