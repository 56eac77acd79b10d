/// Differences run by run: closed cases of Student's t, and how often chance is taken for a difference.
#include "apps/compare/scenes/judge/paired.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/base/statistics.h"

namespace paired_test {

using namespace nilas;
using namespace nilas::compare;

constexpr double k_unknown = std::numeric_limits<double>::infinity();
constexpr double k_rounding = 1e-9;

TEST(ChanceLimit, OfTwinsAloneIsStudentsWithOneDegreeOfFreedom) {
  EXPECT_NEAR(chance_limit(36, {}), 12.7062 * 36, 0.01);
  EXPECT_NEAR(chance_limit(-36, {100}), 12.7062 * 36, 0.01) << "one run scatters by nothing";
  EXPECT_EQ(chance_limit(std::nullopt, {}), k_unknown);
  EXPECT_EQ(chance_limit(std::nullopt, {5}), k_unknown);
}

TEST(ChanceLimit, TakesTheScatterOfRunsThatDifferInWhatShouldNotMatterWhereThatIsMore) {
  // variance 4, so that a difference of two has 8; three runs, two degrees of freedom
  const std::vector<double> alike{10, 12, 14};
  EXPECT_NEAR(chance_limit(0.1, alike), student_95(2) * std::sqrt(8), 1e-12);
  EXPECT_NEAR(chance_limit(std::nullopt, alike), student_95(2) * std::sqrt(8), 1e-12);
  EXPECT_NEAR(chance_limit(3, alike), student_95(1) * 3, 1e-12) << "twins that part further say more";
}

TEST(PairedDifference, OfOneRealisationIsHeldAgainstItsOwnChance) {
  const PairedDifference sure = paired_difference({0}, {-7e4}, {457}, k_rounding);
  EXPECT_EQ(sure.certainty, Certainty::in_realisations);
  EXPECT_EQ(sure.beyond_chance, 1);
  EXPECT_EQ(sure.mean, -7e4);
  EXPECT_TRUE(std::isnan(sure.half_width));
  EXPECT_EQ(paired_difference({0}, {-400}, {457}, k_rounding).certainty, Certainty::none);
  EXPECT_EQ(paired_difference({0}, {-7e4}, {k_unknown}, k_rounding).certainty, Certainty::unknown);
  EXPECT_EQ(paired_difference({}, {}, {}, k_rounding).certainty, Certainty::unknown);
}

TEST(PairedDifference, OfSeveralIsStudentsOverTheDifferences) {
  // mean 2, standard deviation 1, three of them
  const PairedDifference three = paired_difference({0, 1, 2}, {1, 2, 3}, {9, 9, 9}, k_rounding);
  const PairedDifference by_one = paired_difference({0, 1, 2}, {1, 2, 3}, {9, 9, 9}, k_rounding, true);
  EXPECT_NEAR(by_one.half_width, 2 * three.half_width, 1e-12) << "sqrt(n + 1): the one run's own chance stays";
  EXPECT_DOUBLE_EQ(three.mean, 2);
  EXPECT_NEAR(three.half_width, 4.3027 / std::sqrt(3), 1e-4);
  EXPECT_EQ(three.certainty, Certainty::none) << "2 within 2.48";
  const PairedDifference more = paired_difference({0, 1, 2}, {2, 3, 4}, {9, 9, 9}, k_rounding);
  EXPECT_EQ(more.certainty, Certainty::everywhere) << "3 beyond 2.48";
}

TEST(PairedDifference, ThatIsSureInEachButNotInTheMeanSaysSo) {
  // 20 % in one field and 49 % in the next, each far beyond its chance
  const PairedDifference d = paired_difference({0, 1}, {-0.7e5, -1.7e5}, {457, 1e4}, k_rounding);
  EXPECT_GT(d.half_width, std::abs(d.mean));
  EXPECT_EQ(d.certainty, Certainty::in_realisations);
  EXPECT_EQ(d.beyond_chance, 2);
}

TEST(PairedDifference, IsBelowTheReferencesChangeOnlyWhereItIsSignificant) {
  const PairedDifference sure = paired_difference({0}, {-3}, {1}, k_rounding);
  EXPECT_TRUE(is_below_change(sure, 4));
  EXPECT_FALSE(is_below_change(sure, 2));
  EXPECT_FALSE(is_below_change(sure, 0));
  EXPECT_FALSE(is_below_change(paired_difference({0}, {-3}, {5}, k_rounding), 4)) << "it may be chance";
}

TEST(PairedDifference, ThatRoundingMakesIsNone) {
  EXPECT_EQ(paired_difference({0, 1}, {1e-12, 1e-12}, {0, 0}, k_rounding).certainty, Certainty::none);
  EXPECT_EQ(paired_difference({0}, {1e-12}, {0}, k_rounding).certainty, Certainty::none);
}

/// Share of trials in which runs that chance alone sets apart are called different.
template <class Trial>
double false_alarms(const Trial& trial) {
  constexpr int k_trials = 20000;
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  int alarms = 0;
  for (int k = 0; k < k_trials; ++k) alarms += trial([&] { return normal(random); }) ? 1 : 0;
  return static_cast<double>(alarms) / k_trials;
}

TEST(PairedDifference, TakesChanceForADifferenceOnceInTwenty) {
  // four standard deviations of a share of 20000
  constexpr double k_within = 0.0062;
  EXPECT_NEAR(false_alarms([&](const auto& load) {
                const double own = load();
                return is_sure(paired_difference({0}, {load() - load()}, {chance_limit(own - load(), {})}, k_rounding));
              }),
              0.05, k_within);
  EXPECT_NEAR(false_alarms([&](const auto& load) {
                const double limit = chance_limit(std::nullopt, {load(), load(), load(), load(), load()});
                return is_sure(paired_difference({0}, {load() - load()}, {limit}, k_rounding));
              }),
              0.05, k_within);
  EXPECT_NEAR(
      false_alarms([&](const auto& load) {
        const std::vector<double> differences{load() - load(), load() - load(), load() - load()};
        return is_sure(paired_difference({0, 1, 2}, differences, {k_unknown, k_unknown, k_unknown}, k_rounding));
      }),
      0.05, k_within);
}

}  // namespace paired_test
