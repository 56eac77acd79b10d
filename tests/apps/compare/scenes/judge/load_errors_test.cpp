/// Load error estimates against measured errors, by hand-made figures.
#include "apps/compare/scenes/judge/load_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace load_errors_test {

using namespace nilas;
using namespace nilas::compare;

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

TEST(Coverage, CountsRunsWithinAndTakesTheMedianWidth) {
  const Coverage c = coverage({1, 1, 1, 4}, {0.5, 2, 0.25, 1}, 1e-12);
  EXPECT_EQ(c.runs, 4);
  EXPECT_DOUBLE_EQ(c.share, 0.75);
  EXPECT_DOUBLE_EQ(c.width, 3);
}

TEST(LoadErrorParts, LeaveOutWhatIsNotKnown) {
  const double unknown = k_nan;
  EXPECT_DOUBLE_EQ((LoadErrorParts{0, 1, 1, 4, 1}.total()), 5);
  EXPECT_DOUBLE_EQ((LoadErrorParts{0, 1, 2, unknown, unknown}.total()), 3);
}

/// Own setting at three steps, whose loads are off by 0.4, 0.2 and 0.1 N, and another solver at the middle step.
struct Grid {
  Plan plan;
  Findings found;
  Grid() {
    const CompareSetting own{"auto", "coulomb", "moreau", "projection", 0.02, 1e-6};
    add(own, 0.02, 0.2);
    add(own, 0.04, 0.4);
    add(own, 0.01, 0.1);
    CompareSetting other = own;
    other.solver = "nsgs";
    add(other, 0.02, 0.3);
    found.headline = "ice_resistance_N";
    found.measure.scale = 10;
  }
  void add(CompareSetting setting, double step, double off) {
    setting.step = step;
    plan.settings.push_back(setting);
    Merit m;
    m.setting = plan.settings.size() - 1;
    m.done = 1;
    m.load_difference.mean = off;
    m.load_difference.count = 1;
    found.merits.push_back(m);
    RunRow row;
    row.run.setting = m.setting;
    row.load_difference = off;
    row.result.summary.load_errors["ice_resistance_N"] = {.estimate = 1, .solver = 0.01, .law = 0, .chaos = k_nan};
    found.rows.push_back(row);
  }
  /// `chaos`: of the difference of two runs of one realisation, 95 %; NaN: not measured [N].
  void judge(double chaos) {
    found.chance.difference_95_N = chaos;
    const LoadErrors errors = load_errors(plan, found);
    for (std::size_t k = 0; k < found.rows.size(); ++k) found.rows[k].load_error = errors.of_rows[k];
    found.coverage = errors.coverage;
    found.coverage_alone = errors.coverage_alone;
  }
};

TEST(LoadErrors, TakeTheStepsPartFromHalfTheStepOrTwice) {
  Grid grid;
  grid.judge(0);
  EXPECT_NEAR(grid.found.rows[0].load_error->step, 0.2, 1e-12);
  EXPECT_NEAR(grid.found.rows[1].load_error->step, 0.4, 1e-12);
  EXPECT_NEAR(grid.found.rows[2].load_error->step, 0.1, 1e-12);
  // not run at other steps: as the first setting's
  EXPECT_NEAR(grid.found.rows[3].load_error->step, 0.2, 1e-12);
  EXPECT_DOUBLE_EQ(grid.found.coverage->share, 0.75);
  EXPECT_DOUBLE_EQ(grid.found.coverage_alone->share, 1);
}

TEST(LoadErrors, StepsPartIsNotLessThanWhatTheReferenceMoves) {
  Grid grid;
  grid.plan.check.step = 0.02;
  grid.found.check.moves = 0.15;
  grid.judge(0);
  EXPECT_NEAR(grid.found.rows[0].load_error->step, 0.3, 1e-12);
  EXPECT_NEAR(grid.found.rows[1].load_error->step, 0.4, 1e-12);
  grid.found.check.chance = 0.2;
  grid.judge(0);
  EXPECT_NEAR(grid.found.rows[0].load_error->step, 0.2, 1e-12) << "chaos can move the reference as far";
  // finer than what the reference's step was doubled to: by its own steps alone
  EXPECT_NEAR(grid.found.rows[2].load_error->step, 0.1, 1e-12);
}

TEST(LoadErrors, SolversPartHoldsWhatOthersOfTheSameStepScatterBeyondChaos) {
  Grid grid;
  const CompareSetting own = grid.plan.settings[0];
  for (const auto& [solver, off] : {std::pair("apgd", 0.1), std::pair("admm", 0.5)}) {
    CompareSetting other = own;
    other.solver = solver;
    grid.add(other, 0.02, off);
  }
  grid.found.chance.run_N = 0.1;
  grid.judge(0);
  // 0.3 (nsgs), 0.1, 0.5: variance 0.04, of which 0.01 is chance
  EXPECT_NEAR(grid.found.rows[0].load_error->solver, 2 * std::sqrt(0.03), 1e-12);
  grid.found.chance.run_N = 1;
  grid.judge(0);
  EXPECT_EQ(grid.found.rows[0].load_error->solver, 0.01) << "what the run says by itself";
}

TEST(LoadErrors, LawsPartHoldsWhatTheLawDoesAtOtherSteps) {
  Grid grid;
  CompareSetting ccp = grid.plan.settings[0];
  ccp.law = "ccp";
  grid.add(ccp, 0.02, 5);
  grid.add(ccp, 0.01, 0.4);
  grid.judge(0);
  EXPECT_NEAR(grid.found.rows[4].load_error->law, 0.3, 1e-12) << "0.4 beside 0.1 at half the step";
  EXPECT_NEAR(grid.found.rows[5].load_error->law, 4.8, 1e-12);
  EXPECT_EQ(grid.found.rows[0].load_error->law, 0);
}

TEST(LoadErrors, ChaosIsTheLesserOfTheComparisonsAndOfTwoRunsThatEachSayTheirOwn) {
  Grid grid;
  grid.found.rows[0].result.summary.load_errors["ice_resistance_N"].chaos = 0.5;
  grid.judge(2);
  EXPECT_NEAR(grid.found.rows[0].load_error->chaos, std::sqrt(0.5), 1e-12);
  EXPECT_EQ(grid.found.rows[1].load_error->chaos, 2);  // The value must not contain chaos.
  grid.judge(0.1);
  EXPECT_EQ(grid.found.rows[0].load_error->chaos, 0.1);
  grid.judge(k_nan);
  EXPECT_NEAR(grid.found.rows[0].load_error->chaos, std::sqrt(0.5), 1e-12);
}

}  // namespace load_errors_test
