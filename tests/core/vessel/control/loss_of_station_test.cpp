#include "core/vessel/control/loss_of_station.h"

#include <gtest/gtest.h>

namespace loss_of_station_test {

using namespace nilas;
using vessel::LossOfStation;
using vessel::Shortfall;

/// 100 s; `force` over time [N] where the thrusters fall short in the last `short_time` seconds.
LossOfStation under(double (*force)(int second), int short_time) {
  LossOfStation loss;
  for (int k = 0; k < 100; ++k)
    loss.add(Vec2(force(k), 0), 0, k >= 100 - short_time ? Shortfall::force : Shortfall::none, 1);
  return loss;
}

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

TEST(LossOfStation, TellsAnOverloadFromASwing) {
  const auto steady = [](int) { return -2e5; };
  const auto swing = [](int k) { return k % 10 < 5 ? 2e5 : -2e5; };
  EXPECT_TRUE(has(under(steady, 60).text(), "in 60 % of the time. The force that was wanted then pointed one way"));
  EXPECT_TRUE(has(under(swing, 60).text(), "in 60 % of the time. The force that was wanted then swung to and fro"));
  EXPECT_TRUE(has(under(swing, 4).text(), "gave what the control wanted in 96 % of the time"));
  EXPECT_TRUE(has(LossOfStation().text(), "in 100 % of the time"));
}

/// Only a load that swings while the thrusters fall short most of the time counts as a control that swings.
TEST(LossOfStation, SwingsNeedASwingingLoadForLong) {
  const auto steady = [](int) { return -2e5; };
  const auto swing = [](int k) { return k % 10 < 5 ? 2e5 : -2e5; };
  EXPECT_FALSE(under(swing, 60).swinging().empty());
  EXPECT_TRUE(under(swing, 40).swinging().empty());
  EXPECT_TRUE(under(steady, 100).swinging().empty());
  EXPECT_TRUE(LossOfStation().swinging().empty());
}

/// The moment is missing for longer than the force, which swings: the message is about the moment.
TEST(LossOfStation, SpeaksOfWhatIsMissingForLonger) {
  LossOfStation loss;
  for (int k = 0; k < 100; ++k)
    loss.add(Vec2(k % 2 == 0 ? 1e5 : -1e5, 0), 3e6, k < 30 ? Shortfall::force : Shortfall::moment, 1);
  EXPECT_TRUE(has(loss.text(), "The moment that was wanted then pointed one way")) << loss.text();
  EXPECT_TRUE(loss.swinging().empty());
}

TEST(LossOfStation, GoesOnAsSaved) {
  const LossOfStation loss = under([](int k) { return k % 3 == 0 ? 2e5 : -1e5; }, 70);
  State state;
  loss.save(StateWriter(state));
  LossOfStation again;
  again.restore(StateReader(state));
  EXPECT_EQ(again.text(), loss.text());
}

}  // namespace loss_of_station_test
