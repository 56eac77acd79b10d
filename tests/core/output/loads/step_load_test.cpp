#include "core/output/loads/step_load.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/mentions.h"

namespace nilas::output {
namespace step_load_test {

using test::mentions;

const LoadWindow k_all{0, 1, 0, 100, ""};

sim::RunInfo checked_run() {
  sim::RunInfo info;
  info.check_every = 2;
  info.check_tolerance = 1e-8;
  return info;
}

/// A step whose load is off by `error` across the second one of 10 N along x.
sim::StepRecord step(long number, double error, bool is_strict = true) {
  sim::StepRecord record;
  record.step = number;
  record.load_check = sim::LoadCheck{{Vec3(10, error, 0)}, {Vec3(10, 0, 0)}, is_strict};
  return record;
}

TEST(StepLoad, ErrorsAreSharesOfTheMeanLoadOfTheCheckedSteps) {
  StepLoads loads;
  for (long k = 1; k <= 21; ++k) loads.add(step(k, 0.1 * static_cast<double>(k - 1)));
  loads.add(step(22, 50, false));
  loads.add(sim::StepRecord{});
  sim::StepRecord still;
  still.step = 23;
  still.load_check = sim::LoadCheck{{Vec3::Zero()}, {Vec3::Zero()}, true};
  loads.add(still);
  const StepLoadError error = loads.error(checked_run(), k_all);
  EXPECT_EQ(error.checked, 21) << "steps without load do not count";
  EXPECT_EQ(error.unsolved, 1);
  EXPECT_DOUBLE_EQ(error.mean, 10);
  EXPECT_DOUBLE_EQ(error.median, 0.1) << "errors of 0, 0.1 .. 2 N";
  EXPECT_DOUBLE_EQ(error.p95, 0.19);
  EXPECT_FALSE(error.is_trusted());
  const StepLoadError early = loads.error(checked_run(), {0, 1, 0, 3, ""});
  EXPECT_EQ(early.checked, 3) << "of the window's steps";
  EXPECT_EQ(early.unsolved, 0);
  EXPECT_TRUE(early.is_trusted());
}

/// A run may count the pressure of a jam that the second solutions do not find.
TEST(StepLoad, IsAllErrorWhereIceBearsNothing) {
  StepLoads loads;
  sim::StepRecord record;
  record.step = 1;
  record.load_check = sim::LoadCheck{{Vec3(3, 0, 0)}, {Vec3::Zero()}, true};
  loads.add(record);
  const StepLoadError error = loads.error(checked_run(), k_all);
  EXPECT_EQ(error.median, 1);
  EXPECT_EQ(error.p95, 1);
  EXPECT_FALSE(error.is_trusted());
}

TEST(StepLoad, IsNotTrustedWhereManySecondSolutionsFail) {
  StepLoads loads;
  for (long k = 1; k <= 9; ++k) loads.add(step(k, 0));
  loads.add(step(10, 0, false));
  EXPECT_TRUE(loads.error(checked_run(), k_all).is_trusted());
  loads.add(step(11, 0, false));
  EXPECT_FALSE(loads.error(checked_run(), k_all).is_trusted());
}

/// Forces on several bodies count as one vector: errors of opposite sign do not cancel.
TEST(StepLoad, OfSeveralBodiesDoesNotCancel) {
  StepLoads loads;
  sim::StepRecord record;
  record.step = 1;
  record.load_check = sim::LoadCheck{{Vec3(3, 0, 0), Vec3(0, 5, 0)}, {Vec3(6, 0, 0), Vec3(0, 8, 0)}, true};
  loads.add(record);
  const StepLoadError error = loads.error(checked_run(), k_all);
  EXPECT_DOUBLE_EQ(error.mean, 10);
  EXPECT_DOUBLE_EQ(error.median, std::sqrt(18) / 10);
}

TEST(StepLoad, TellsWhetherSingleStepsAreToBeTrusted) {
  StepLoads none, good, bad, failed, few;
  good.add(step(1, 0));
  bad.add(step(1, 6));
  bad.add(step(3, 1, false));
  failed.add(step(1, 1, false));
  few.add(step(1, 0));
  few.add(step(3, 0, false));
  const auto text = [](const StepLoads& loads) { return step_load_text(loads.error(checked_run(), k_all)); };
  EXPECT_EQ(text(none), "");
  EXPECT_TRUE(mentions(text(good), "1 step to 1e-08 m/s, the ice load of one step is off by less than 0.001 %"));
  EXPECT_FALSE(mentions(text(good), "Do not use"));
  EXPECT_TRUE(mentions(text(bad), "off by 60 % in the median and by 60 % in the 95th percentile, of 10 N"));
  EXPECT_TRUE(mentions(text(bad), "In 1 step more the second solution did not succeed. Do not use single steps"));
  EXPECT_TRUE(mentions(text(bad), "Set contact/@law="));
  EXPECT_TRUE(mentions(text(few), "raw peaks of this run. Steps whose second solution does not succeed are those"));
  EXPECT_FALSE(mentions(text(few), "Set contact/@law="));
  EXPECT_TRUE(mentions(text(failed), "is not known: a second solution to 1e-08 m/s did not succeed in any of 1 step"));
}

TEST(StepLoad, GoesOnAsSavedAndIsReadBackFromASummary) {
  StepLoads loads, rest;
  loads.add(step(1, 0.5));
  loads.add(step(3, 1));
  loads.add(step(5, 1, false));
  State state;
  loads.save(StateWriter(state));
  rest.restore(StateReader(state));
  const StepLoadError error = rest.error(checked_run(), k_all);
  EXPECT_EQ(step_load_text(error), step_load_text(loads.error(checked_run(), k_all)));
  EXPECT_EQ(step_load_text(step_load_error_of({{"step_load_error", step_load_json(error)}})), step_load_text(error));
  EXPECT_EQ(step_load_error_of({{"status", "done"}}).checked, 0) << "an older run";
}

}  // namespace step_load_test
}  // namespace nilas::output
