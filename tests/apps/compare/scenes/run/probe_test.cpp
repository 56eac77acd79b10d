/// Tests of the cost model of a short run, with hand-made times.
#include "apps/compare/scenes/run/probe.h"

#include <gtest/gtest.h>

namespace probe_test {

using namespace nilas::compare;

/// Two steps of 0.5 s that take 100 ms, 60 of them in the solver, and 10 ms of writing.
Probe two_steps() {
  Probe found;
  found.steps = 2;
  found.length = 1;
  found.time_s = {0.5, 1};
  found.ms = {100, 100};
  found.solver_ms = {60, 60};
  found.output_ms = {10, 10};
  return found;
}

TEST(Probe, CountsWritingAfterAStepAsThatStepAndNotAsSetUp) {
  EXPECT_DOUBLE_EQ(two_steps().outside_steps_s(3), 3 - 0.22);
  EXPECT_EQ(two_steps().outside_steps_s(0.1), 0) << "clocks differ a little";
  const CostModel cost = cost_model(two_steps(), 0);
  ASSERT_EQ(cost.rate.size(), 2U);
  for (const auto& stretch : cost.rate) {
    EXPECT_DOUBLE_EQ(stretch.other, 0.1) << "50 ms in half a second";
    EXPECT_DOUBLE_EQ(stretch.solver, 0.12);
  }
  EXPECT_NEAR(cost.steps_seconds(10), 2.2, 1e-12);
}

}  // namespace probe_test
