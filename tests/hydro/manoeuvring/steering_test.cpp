/// Scripted manoeuvres of KVLCC2, measured by the module of steering on a ship that Runge and Kutta's method moves.
#include "hydro/manoeuvring/steering.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "hydro/manoeuvring/imo_criteria.h"
#include "tests/hydro/manoeuvring/steered_ship.h"
#include "tests/support/scratch_folder.h"

namespace nilas::steering_test {

using test::SteeredShip;

constexpr double k_step = 0.1;  // [s]

hydro::ManoeuvreFrame frame(const Vec3& current = Vec3::Zero()) { return {320, current.head<2>()}; }

/// The figures of an independent integration; the rudder begins one substep late, 0.8 m or 0.0025 L of way.
TEST(Steering, MeasuresATurningCircle) {
  SteeredShip ship = test::kvlcc2_under_way();
  ship.steer(hydro::make_turning_circle(frame(), 35 * k_deg), 5);
  ship.go(1800, k_step);
  EXPECT_NEAR(ship.figure("advance_m") / 320, 2.974, 0.01);
  EXPECT_NEAR(ship.figure("tactical_diameter_m") / 320, 3.001, 0.01);
  EXPECT_NEAR(ship.figure("steady_diameter_m") / 320, 2 * 1.121, 0.005);
  EXPECT_NEAR(ship.figure("steady_drift_deg"), 19.42, 0.05);
  EXPECT_NEAR(ship.figure("steady_speed_ratio_1"), 0.376, 0.002);
  EXPECT_GT(ship.figure("transfer_m"), 0);
  EXPECT_NE(ship.text("advance_m").find("IMO at most 4.5 L"), std::string::npos);
}

TEST(Steering, MeasuresACircleToPort) {
  SteeredShip ship = test::kvlcc2_under_way();
  ship.steer(hydro::make_turning_circle(frame(), -35 * k_deg));
  ship.go(700, k_step);
  EXPECT_NEAR(ship.figure("advance_m") / 320, 2.999, 0.01);
  EXPECT_NEAR(ship.figure("tactical_diameter_m") / 320, 3.009, 0.01);
  EXPECT_GT(ship.bodies().p_GB[0].y(), 0);
}

/// The ways are those through the water: a current of 1 m/s changes no figure.
TEST(Steering, ACurrentChangesNoFigure) {
  const Vec3 current(0.6, -0.8, 0);
  SteeredShip still = test::kvlcc2_under_way(), carried = test::kvlcc2_under_way(current);
  still.steer(hydro::make_turning_circle(frame(), 35 * k_deg));
  carried.steer(hydro::make_turning_circle(frame(current), 35 * k_deg));
  still.go(500, k_step);
  carried.go(500, k_step);
  EXPECT_NEAR(still.figure("advance_m"), carried.figure("advance_m"), 1e-6);
  EXPECT_NEAR(still.figure("tactical_diameter_m"), carried.figure("tactical_diameter_m"), 1e-6);
}

TEST(Steering, MeasuresZigzags) {
  SteeredShip ten = test::kvlcc2_under_way(), twenty = test::kvlcc2_under_way();
  ten.steer(hydro::make_zigzag(frame(), 10 * k_deg, 10 * k_deg));
  twenty.steer(hydro::make_zigzag(frame(), 20 * k_deg, 20 * k_deg));
  ten.go(900, k_step);
  twenty.go(900, k_step);
  // The switch is up to a substep late and the order a second one: at 0.5 deg/s, 0.1 deg.
  EXPECT_NEAR(ten.figure("overshoot_1_deg"), 4.89, 0.1);
  EXPECT_NEAR(ten.figure("overshoot_2_deg"), 13.14, 0.1);
  EXPECT_NEAR(twenty.figure("overshoot_1_deg"), 10.46, 0.1);
  EXPECT_NEAR(twenty.figure("overshoot_2_deg"), 15.32, 0.1);
  EXPECT_LT(ten.figure("initial_turning_m"), 2.5 * 320);
  // L/V is 320/7.974 = 40.1 s, beyond 30 s, where the limits are 20 and 40 degrees.
  EXPECT_NE(ten.text("overshoot_1_deg").find("IMO at most 20 deg"), std::string::npos);
  EXPECT_NE(ten.text("overshoot_2_deg").find("IMO at most 40 deg"), std::string::npos);
  EXPECT_NE(twenty.text("overshoot_1_deg").find("IMO at most 25 deg"), std::string::npos);
}

/// MSC.137(76), 5.3.3: 10 degrees below L/V of 10 s, 20 above 30 s, 5 + (L/V)/2 between; 25, 40 and 17.5 + 0.75 (L/V).
TEST(Steering, KnowsTheLimitsOfOvershoots) {
  EXPECT_EQ(hydro::imo_overshoot(10, 10, 1, 5), 10);
  EXPECT_EQ(hydro::imo_overshoot(-10, 10, 1, 20), 15);
  EXPECT_EQ(hydro::imo_overshoot(10, 10, 1, 40), 20);
  EXPECT_EQ(hydro::imo_overshoot(10, 10, 2, 5), 25);
  EXPECT_EQ(hydro::imo_overshoot(10, 10, 2, 20), 32.5);
  EXPECT_EQ(hydro::imo_overshoot(20, 20, 1, 12), 25);
  EXPECT_FALSE(hydro::imo_overshoot(20, 20, 2, 12).has_value());
  EXPECT_FALSE(hydro::imo_overshoot(20, 10, 1, 12).has_value());
}

hydro::AutopilotGains gains(const SteeredShip& ship, double speed) {
  hydro::AutopilotGains g;
  g.yaw_rate_gain = 3 * 320 / speed;
  g.heading_time = 50 * 320 / speed;
  g.speed_gain = 2;
  g.speed_time = 10 * 320 / speed;
  g.rps_per_speed = ship.rps() / speed;
  g.max_rudder = 35 * k_deg;
  g.max_rps = 2;
  return g;
}

/// A change of heading of 40 degrees and of speed from 8 to 6 m/s: both are reached without an error that stays, and
/// the heading does not swing on by more than a few degrees.
TEST(Steering, AutopilotReachesHeadingAndSpeed) {
  SteeredShip ship = test::kvlcc2_under_way();
  ship.steer(hydro::make_course(frame(), {{0, 0, 8}, {100, 40 * k_deg, 6}}, gains(ship, 8)));
  ship.go(100, k_step);
  EXPECT_NEAR(ship.state.heading, 0, 1e-3);
  double most = 0;
  for (int k = 0; k < 60; ++k) {
    ship.go(100, k_step);
    most = std::max(most, -ship.state.heading);
  }
  EXPECT_LT(most / k_deg, 44);
  EXPECT_NEAR(-ship.state.heading / k_deg, 40, 0.05);
  EXPECT_NEAR(ship.state.motion.u, 6, 1e-3);
  EXPECT_NEAR(ship.rps() / ship.state.motion.u, 106.66 / 60 / (15.5 * 1852 / 3600), 1e-3);
}

TEST(Steering, GoesOnAsSaved) {
  const auto make = [](const std::string& kind) -> std::unique_ptr<hydro::Manoeuvre> {
    if (kind == "circle") return hydro::make_turning_circle(frame(), 35 * k_deg);
    if (kind == "zigzag") return hydro::make_zigzag(frame(), -20 * k_deg, 20 * k_deg);
    if (kind == "straight") return hydro::make_straight(frame());
    return hydro::make_course(frame(), {{0, 0.2, 8}}, {1, 40, 800, 2, 400, 0.2, 0.6, 2});
  };
  for (const std::string kind : {"circle", "zigzag", "straight", "course"}) {
    SteeredShip whole = test::kvlcc2_under_way();
    whole.steer(make(kind));
    whole.go(200, k_step);
    State state;
    whole.steering->save(whole.bodies(), StateWriter(state));
    auto fresh = make(kind);
    fresh->restore(StateReader(state));
    State again;
    fresh->save(StateWriter(again));
    EXPECT_EQ(state.entries, again.entries) << kind;
    const auto a = whole.steering->figures(), b = fresh->figures();
    ASSERT_EQ(a.size(), b.size()) << kind;
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a[k].text, b[k].text) << kind;
  }
}

TEST(Steering, NeedsSomethingThatFollows) {
  EXPECT_THROW(make_steering({}, hydro::make_straight(frame()), std::make_shared<Channels>()), InputError);
}

TEST(Steering, ReadsOrders) {
  const test::ScratchFolder folder;
  const std::string good = folder.write("good.csv", "t_s,heading_deg,speed_m_s\n0,10,3\n60,-20,2\n").string();
  const auto orders = hydro::read_course_orders(good);
  ASSERT_EQ(orders.size(), 2u);
  EXPECT_EQ(orders[1].t, 60);
  EXPECT_NEAR(orders[1].heading, -20 * k_deg, 1e-15);
  const std::string bad = folder.write("bad.csv", "t_s,heading_deg,speed_m_s\n0,10,3\n0,-20,2\n").string();
  try {
    hydro::read_course_orders(bad);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("bad.csv:3: t_s is 0 after 0"), std::string::npos) << error.what();
  }
}

}  // namespace nilas::steering_test
