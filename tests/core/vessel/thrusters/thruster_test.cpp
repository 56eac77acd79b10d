#include "core/vessel/thrusters/thruster.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace thruster_test {

using namespace nilas;
using vessel::Thruster;

Thruster propeller() {
  Thruster thruster;
  thruster.name = "main";
  thruster.kind = ThrusterKind::propeller;
  thruster.most_ahead = 8e5;
  thruster.most_astern = 5e5;
  thruster.lag = 1;
  thruster.power = 5e6;
  return thruster;
}

TEST(Thruster, TakesPowerByTheThrustToThePowerOfOneAndAHalf) {
  EXPECT_DOUBLE_EQ(propeller().power_at(8e5), 5e6);
  EXPECT_DOUBLE_EQ(propeller().power_at(-2e5), 5e6 / 8);
}

TEST(Thruster, StaysWithinItsLimits) {
  EXPECT_EQ(propeller().limited(1e9), 8e5);
  EXPECT_EQ(propeller().limited(-1e9), -5e5);
  EXPECT_DOUBLE_EQ(propeller().saturation(-2.5e5), 0.5);
  const auto after = vessel::advanced(propeller(), {}, 1e9, 0, 0, 1e3);
  EXPECT_DOUBLE_EQ(after.thrust, 8e5);
}

// A blackout at 2 s: until then the thrust rises by the lag, afterwards it falls by it.
TEST(Thruster, LosesItsThrustFromTheTimeOfItsFailure) {
  Thruster thruster = propeller();
  thruster.fails_at = 2;
  const double before = 8e5 * (1 - std::exp(-2)), after = before * std::exp(-3);
  EXPECT_NEAR(vessel::advanced(thruster, {}, 8e5, 0, 0, 5).thrust, after, 1e-9);
  vessel::ThrusterState state;
  for (int k = 0; k < 50; ++k) state = vessel::advanced(thruster, state, 8e5, 0, 0.1 * k, 0.1);
  EXPECT_NEAR(state.thrust, after, 1e-8) << "the failure at a step's end";
  EXPECT_TRUE(thruster.works(1.9));
  EXPECT_FALSE(thruster.works(2));
}

TEST(Thruster, AzimuthTurnsAtItsRateAndStopsWhenItFails) {
  Thruster thruster = propeller();
  thruster.kind = ThrusterKind::azimuth;
  thruster.turn_rate = 12 * k_deg;
  thruster.fails_at = 3;
  EXPECT_NEAR(vessel::advanced(thruster, {}, 0, k_pi / 2, 0, 2).angle, 24 * k_deg, 1e-14);
  EXPECT_NEAR(vessel::advanced(thruster, {}, 0, k_pi / 2, 0, 7).angle, 36 * k_deg, 1e-14);
  EXPECT_NEAR(vessel::thruster_force(thruster, {1e5, 30 * k_deg}, Vec2::Zero()).y(), 0.5e5, 1e-9);
}

// Juva and Riska at half the free speed: 1 - 1/6 - 1/6 = 2/3; nothing at the free speed; at a quarter of the thrust the
// free speed is half.
TEST(Thruster, LosesThrustWithTheSpeedOfAdvance) {
  Thruster thruster = propeller();
  thruster.free_speed = 8;
  EXPECT_DOUBLE_EQ(vessel::remaining_share(thruster, 8e5, 0), 1);
  EXPECT_NEAR(vessel::remaining_share(thruster, 8e5, 4), 2.0 / 3, 1e-15);
  EXPECT_NEAR(vessel::remaining_share(thruster, 8e5, 8), 0, 1e-15);
  EXPECT_NEAR(vessel::remaining_share(thruster, 2e5, 2), 2.0 / 3, 1e-15);
  EXPECT_EQ(vessel::remaining_share(thruster, 2e5, 20), 0);
  EXPECT_EQ(vessel::remaining_share(thruster, 8e5, -2), 1);
  thruster.loss = 0.25;
  EXPECT_NEAR(vessel::thruster_force(thruster, {8e5, 0}, Vec2(4, 0)).x(), 8e5 * 0.75 * 2 / 3, 1e-9);
  EXPECT_NEAR(vessel::thruster_force(thruster, {-4e5, 0}, Vec2(1, 0)).x(), -4e5 * 0.75, 1e-9)
      << "astern, motion ahead is no loss";
}

TEST(Thruster, KeepsOutOfForbiddenSectors) {
  Thruster thruster = propeller();
  thruster.kind = ThrusterKind::azimuth;
  thruster.forbidden = {{170 * k_deg, -150 * k_deg}};
  EXPECT_TRUE(thruster.is_forbidden(180 * k_deg));
  EXPECT_TRUE(thruster.is_forbidden(-160 * k_deg));
  EXPECT_FALSE(thruster.is_forbidden(0));
  EXPECT_FALSE(thruster.is_forbidden(170 * k_deg));
  EXPECT_NEAR(thruster.allowed_angle(-179 * k_deg), 170 * k_deg, 1e-12);
  EXPECT_NEAR(thruster.allowed_angle(-155 * k_deg), -150 * k_deg, 1e-12);
  EXPECT_EQ(thruster.allowed_angle(1), 1);
}

class LossTable : public ::testing::Test {
 protected:
  std::string table(const std::string& rows) const {
    return folder_.write("loss.csv", "speed_m_s,thrust_share\n" + rows).string();
  }
  test::ScratchFolder folder_;
};

TEST_F(LossTable, IsLinearBetweenItsRows) {
  const auto loss = vessel::ThrustLoss::read(table("0,1\n2,0.8\n6,0\n"));
  EXPECT_EQ(loss.share(-1), 1);
  EXPECT_DOUBLE_EQ(loss.share(1), 0.9);
  EXPECT_DOUBLE_EQ(loss.share(4), 0.4);
  EXPECT_EQ(loss.share(9), 0);
  const auto scaled = vessel::ThrustLoss::read(table("0,1\n2,0.8\n6,0\n"), 4);
  EXPECT_DOUBLE_EQ(scaled.share(2), 0.9) << "speeds go with the root of the scale";
}

TEST_F(LossTable, IsRefusedWhereItIsNotMonotonic) {
  test::expect_refusal([&] { vessel::ThrustLoss::read(table("0,1\n2,0.8\n2,0.5\n")); }, {"loss.csv:4", "must rise"});
  test::expect_refusal([&] { vessel::ThrustLoss::read(table("0,0.8\n2,0.9\n")); }, {"loss.csv:3", "must not rise"});
  test::expect_refusal([&] { vessel::ThrustLoss::read(table("0,1.2\n")); }, {"loss.csv:2", "0 to 1"});
}

}  // namespace thruster_test
