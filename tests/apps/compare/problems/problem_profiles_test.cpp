/// Performance profiles against numbers by hand.
#include "apps/compare/problems/problem_profiles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apps/compare/problems/problem_study_plan.h"
#include "apps/compare/problems/problem_study_results.h"
#include "core/base/error.h"

namespace nilas::compare {

void PrintTo(const ProfilePoint& p, std::ostream* out) { *out << "(" << p.x << ", " << p.share << ")"; }
bool operator==(const ProfilePoint& a, const ProfilePoint& b) { return a.x == b.x && a.share == b.share; }

}  // namespace nilas::compare

namespace problem_profiles_test {

using namespace nilas;
using namespace nilas::compare;

constexpr double k_never = k_unsolved;

/// Four problems, three solvers; the last problem is solved by none.
const SolveTimes& times() {
  static const SolveTimes all{{1, 2, k_never}, {4, 1, 8}, {3, 3, k_never}, {k_never, k_never, k_never}};
  return all;
}

TEST(Profiles, RatiosAreToTheFastestOfEachProblem) {
  EXPECT_EQ(time_ratios(times()),
            (SolveTimes{{1, 2, k_never}, {4, 1, 8}, {1, 1, k_never}, {k_never, k_never, k_never}}));
  EXPECT_EQ(time_ratios({{0, 1}}), (SolveTimes{{1, k_never}}));
}

TEST(Profiles, RiseByOneProblemAtATimeAndEndAtTheShareSolved) {
  const auto all = profiles(time_ratios(times()));
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0], (Profile{{1, 0.5}, {4, 0.75}}));
  EXPECT_EQ(all[1], (Profile{{1, 0.5}, {2, 0.75}}));
  EXPECT_EQ(all[2], (Profile{{8, 0.25}}));
  const auto by_time = profiles(times());
  EXPECT_EQ(by_time[0], (Profile{{1, 0.25}, {3, 0.5}, {4, 0.75}}));
  EXPECT_TRUE(profiles({}).empty());
}

TEST(Profiles, ScoresCountSolvedFastestAndMeanRatio) {
  const auto all = scores(times());
  EXPECT_EQ(all[0].solved, 3U);
  EXPECT_EQ(all[0].fastest, 2U) << "a tie counts for both";
  EXPECT_EQ(all[1].fastest, 2U);
  EXPECT_EQ(all[2].problems, 4U);
  EXPECT_NEAR(all[0].mean_ratio, std::cbrt(4.0), 1e-12);
  EXPECT_NEAR(all[2].mean_ratio, 8, 1e-12);
  EXPECT_EQ(scores({{k_never}})[0].mean_ratio, k_unsolved);
}

TEST(Profiles, MedianTakesAFailureForEndless) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
  EXPECT_EQ(median({1, k_never, k_never}), k_unsolved);
  EXPECT_EQ(median({}), k_unsolved);
}

StudyRow row(const std::string& problem, const std::string& solver, double tolerance, double seconds, double map) {
  StudyRow out;
  out.problem.name = problem;
  out.solver = solver;
  out.law = "coulomb";
  out.tolerance = tolerance;
  out.seconds = seconds;
  out.residuals.law_map_m_s = map;
  out.outcome = map <= tolerance ? RunOutcome::solved : RunOutcome::stalled;
  return out;
}

TEST(StudyResults, CompareOnlyWhatAllSolversWereTriedOn) {
  const std::vector<StudyRow> rows{row("a", "newton", 1e-6, 1, 1e-9), row("a", "nsgs", 1e-6, 2, 1e-7),
                                   row("b", "newton", 1e-6, 3, 1e-9), row("b", "nsgs", 1e-6, 9, 1e-3),
                                   row("c", "newton", 1e-6, 1, 1e-9)};
  const auto all = compare_solvers(rows);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].problems, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(all[0].scores[1].solved, 1U);
  EXPECT_EQ(headline(all[0]),
            "At 1e-6 m/s newton solved all 2 problems, more than any other, in 1 times the time of the fastest "
            "(geometric mean), and was itself the fastest on 100 % of them.");
  const auto points = median_points(rows, all);
  ASSERT_EQ(points.size(), 1U) << "nsgs fails on half of them, so its median time is endless";
  EXPECT_EQ(points[0].seconds, 2);
}

TEST(StudyPlan, TheMiddleToleranceComesFirst) {
  EXPECT_EQ(middle_first({1e-2, 1e-4, 1e-6, 1e-8, 1e-10}), (std::vector<double>{1e-6, 1e-8, 1e-4, 1e-10, 1e-2}));
  EXPECT_EQ(middle_first({1e-8, 1e-2, 1e-4, 1e-6, 1e-6}), (std::vector<double>{1e-6, 1e-8, 1e-4, 1e-2}));
  EXPECT_EQ(middle_first({1e-3}), (std::vector<double>{1e-3}));
}

std::vector<StudyFile> files(int count) {
  std::vector<StudyFile> all(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    all[k].problem.name = std::to_string(k);
    all[k].problem.contacts = 10 + k;
  }
  return all;
}

TEST(StudyPlan, DropsWholeBlocksFromTheEnd) {
  const StudyChoice choice{{"newton", "nsgs"}, {"coulomb"}, {1e-4, 1e-6}, 1};
  const auto whole = make_plan(files(8), choice, 1e6, 0.1);
  EXPECT_EQ(whole.runs.size(), 32U);
  EXPECT_TRUE(whole.dropped.empty());
  const auto part = make_plan(files(8), choice, 1, 0.1);
  EXPECT_EQ(part.runs.size() + part.dropped.size(), 32U);
  EXPECT_EQ(part.runs.size() % 2, 0U);
  EXPECT_GT(part.runs.size(), 2U);
  EXPECT_LE(part.estimate_s, 1);
  for (std::size_t k = 0; k < part.runs.size(); ++k) EXPECT_EQ(part.runs[k].file, whole.runs[k].file);
  // a quarter of the order holds small and large ones
  EXPECT_EQ(whole.runs[0].file, 0U);
  EXPECT_EQ(whole.runs[2].file, 4U);
  EXPECT_EQ(make_plan(files(8), choice, 1e-9, 0.1).runs.size(), 2U) << "the first block stays";
}

TEST(StudyPlan, WhatDoesNotApplyIsKnownWithoutARun) {
  auto all = files(1);
  all[0].moments = true;
  const auto plan = make_plan(all, {{"newton", "nsgs", "enumerate"}, {"coulomb"}, {1e-6}, 1}, 100, 0.1);
  EXPECT_EQ(plan.runs.size(), 1U);
  ASSERT_EQ(plan.settled.size(), 2U);
  EXPECT_EQ(plan.settled[0].outcome, RunOutcome::not_applicable);
  EXPECT_NE(plan.settled[0].message.find("rolling"), std::string::npos);
}

TEST(StudyPlan, RefusesNamesAndTolerancesThatAreNone) {
  EXPECT_THROW(validate({{"newtn"}, {"coulomb"}, {}, 0}), InputError);
  EXPECT_THROW(validate({{}, {"coulom"}, {}, 0}), InputError);
  EXPECT_THROW(validate({{}, {"coulomb"}, {0}, 0}), InputError);
}

}  // namespace problem_profiles_test
