#include "core/output/text/slowdown.h"

#include <gtest/gtest.h>

namespace nilas::output {
namespace slowdown_test {

sim::StepRecord step(double solver_ms, int contacts) {
  sim::StepRecord record;
  record.ms.fill(0);
  record.ms[static_cast<std::size_t>(sim::Phase::hydro)] = 5;
  record.ms[static_cast<std::size_t>(sim::Phase::solver)] = solver_ms;
  record.contacts = contacts;
  record.iterations = 2 * contacts;
  return record;
}

TEST(Slowdown, NamesWhatGrew) {
  StepCosts costs;
  for (int k = 0; k < 400; ++k) costs.add(step(k < 200 ? 5 : 45, k < 200 ? 10 : 300), k < 200 ? 10 : 50);
  const std::string text = costs.slowdown(0);
  EXPECT_NE(text.find("5 times as long"), std::string::npos) << text;
  EXPECT_NE(text.find("50 ms instead of 10 ms, with 50 ms of processor time instead of 10 ms."), std::string::npos)
      << text;
  EXPECT_EQ(text.find("busy"), std::string::npos) << text;
  EXPECT_NE(text.find("The solver took 100 % of the time added"), std::string::npos) << text;
  EXPECT_NE(text.find("300 contacts per step instead of 10, and 600 iterations instead of 20"), std::string::npos)
      << text;
  EXPECT_EQ(costs.slowdown(200), "") << "from there on nothing changed";
  EXPECT_EQ(costs.slowdown(390), "") << "too few steps";
}

/// A step of 50 ms with 12 ms of work waited for the processor, so its contacts are not to blame. With 39 ms of work,
/// about four times as much as before, both are causes.
TEST(Slowdown, TellsAMachineThatWasBusyFromIce) {
  for (const bool more_work : {false, true}) {
    StepCosts costs;
    for (int k = 0; k < 400; ++k)
      costs.add(step(k < 200 ? 5 : 45, k < 200 ? 10 : 11), k < 200 ? 10 : more_work ? 39 : 12);
    const std::string text = costs.slowdown(0);
    EXPECT_NE(text.find("50 ms instead of 10 ms, with "), std::string::npos) << text;
    EXPECT_NE(text.find("busy with other work, or its disk was slow."), std::string::npos) << text;
    EXPECT_EQ(text.find("contacts per step") != std::string::npos, more_work) << text;
  }
}

/// With two threads the processor time may be less in proportion where less of a step is shared, without any waiting.
TEST(Slowdown, FewerThreadsAtWorkAreNoOtherWork) {
  StepCosts costs;
  for (int k = 0; k < 400; ++k) costs.add(step(k < 200 ? 5 : 45, 10), k < 200 ? 20 : 50);
  const std::string text = costs.slowdown(0);
  EXPECT_EQ(text.find("busy"), std::string::npos) << text;
  EXPECT_NE(text.find("The solver took 100 % of the time added"), std::string::npos) << text;
}

/// Memory does not grow with the steps, and the figures stay the same: 5 ms or 45 ms in the steps of a quarter.
TEST(Slowdown, OfALongRunIsToldFromStretchesOfSteps) {
  StepCosts costs;
  constexpr int k_steps = 100'003, k_before = 50'000;
  std::vector<std::size_t> sizes;
  for (int k = 0; k < k_steps; ++k) {
    costs.add(step(k < k_before ? 5 : 45, k < k_before ? 10 : 300), k < k_before ? 10 : 50);
    if (k % 20'000 != 19'999) continue;
    State state;
    costs.save(StateWriter(state));
    sizes.push_back(std::get<std::vector<double>>(state.entries.at("stretches")).size());
    costs = StepCosts();
    costs.restore(StateReader(state));
  }
  for (const std::size_t size : sizes) EXPECT_LE(size, 1024u * 6);
  const std::string text = costs.slowdown(0);
  EXPECT_NE(text.find("5 times as long as those of the first: 50 ms instead of 10 ms, with 50 ms of"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("300 contacts per step instead of 10, and 600 iterations instead of 20"), std::string::npos)
      << text;
  EXPECT_EQ(costs.slowdown(k_before + 200), "") << "from there on nothing changed";
  EXPECT_EQ(costs.slowdown(k_steps - 100), "") << "less than four stretches";
}

TEST(Slowdown, SaysNothingOfShortRuns) {
  StepCosts costs;
  for (int k = 0; k < 100; ++k) costs.add(step(k < 50 ? 0.1 : 5, 1), 10);
  EXPECT_EQ(costs.slowdown(0), "");
}

}  // namespace slowdown_test
}  // namespace nilas::output
