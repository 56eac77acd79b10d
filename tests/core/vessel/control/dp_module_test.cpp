#include "core/vessel/control/dp_module.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/vessel/control/station_statistics.h"
#include "core/vessel/thrusters/thruster_module.h"
#include "tests/core/vessel/thrusters/example_thrusters.h"
#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace dp_module_test {

using namespace nilas;
using vessel::Thruster;

constexpr double k_step = 0.1;  // [s]

/// A ship of 6000 t in still water, without heave, roll and pitch: linear damping and a load of the surroundings.
struct Rig {
  bodies::Bodies bodies;
  std::shared_ptr<Channels> channels = std::make_shared<Channels>();
  std::unique_ptr<bodies::ForceModule> thrusters;
  std::unique_ptr<bodies::Module> dp;
  Wrench load;
  double t = 0;
  vessel::DpSettings settings;

  explicit Rig(const std::function<void(vessel::DpSettings&, std::vector<Thruster>&)>& change = {}) {
    bodies::BodySpec ship;
    ship.kind = bodies::BodyKind::vessel;
    ship.shape = std::make_shared<const geometry::Shape>(geometry::box_shape({76, 18, 10}));
    ship.mass = 6e6;
    ship.inertia_B = Vec3(2e8, 2.2e9, 2.3e9).asDiagonal();
    bodies.add(ship);
    settings.plan = vessel::PositioningPlan::hold(Vec3::Zero(), 0);
    settings.sensors = {.period = k_step, .delay = 0, .position_noise = 0.1, .heading_noise = 0.1 * k_deg, .seed = 1};
    settings.controller = {.mass = {6e6, 6e6, 2.3e9},
                           .damping = Vec3::Zero(),
                           .bandwidth = {0.1, 0.1, 0.2},
                           .damping_ratio = std::sqrt(0.5)};
    settings.observer = {
        .mass = settings.controller.mass, .damping = Vec3::Zero(), .bandwidth = {0.5, 0.5, 1}, .wave_period = {}};
    settings.filter_bandwidth = {0.1, 0.1, 0.2};
    settings.watch_circle = 5;
    settings.most_offset = 76;
    settings.window = {0, 1e9};
    std::vector<Thruster> all = test::supply_thrusters();
    for (Thruster& each : all) each.lag = 1;
    if (change) change(settings, all);
    vessel::ThrusterSettings fitted;
    fitted.thrusters = all;
    fitted.commands.resize(all.size());
    thrusters = vessel::make_thrusters(fitted, channels);
    dp = vessel::make_dp(settings, {all, Vec3::Zero()}, channels);
  }

  void step() {
    bodies::Wrenches out(1);
    thrusters->add_forces(bodies, t, out);
    out[0] += load;
    bodies.v_GB[0] += k_step / bodies.mass[0] * Vec3(out[0].force.x(), out[0].force.y(), 0);
    bodies.w_GB[0] += Vec3(0, 0, k_step * out[0].torque.z() / 2.3e9);
    const Quat turn(Eigen::AngleAxisd(k_step * bodies.w_GB[0].z(), Vec3::UnitZ()));
    bodies.set_pose(0, bodies.p_GB[0] + k_step * bodies.v_GB[0], turn * bodies.q_GB[0]);
    t += k_step;
    thrusters->end_substep(bodies, t, k_step);
    dp->end_substep(bodies, t, k_step);
  }
  void run(double seconds) {
    for (int k = 0; k < std::lround(seconds / k_step); ++k) step();
  }
  double sum(std::string_view name) const { return dp->total(name).value(); }
};

Wrench across(double force, double moment = 0) { return {Vec3(0, force, 0), Vec3(0, 0, moment)}; }

// A steady load of 150 kN on the side is less than the 800 kN of the tunnels. After 600 s the integral holds it: the
// offset is that of the noise, which the observer takes down to about 0.1 m sqrt(1.6 w T) = 0.03 m.
TEST(Dp, HoldsItsStationAgainstASteadyLoad) {
  Rig rig([](vessel::DpSettings& dp, std::vector<Thruster>&) { dp.window = {600, 900}; });
  rig.load = across(1.5e5, 1e6);
  rig.run(900);
  EXPECT_LT(rig.sum(vessel::k_dp_offset_rms), 0.1);
  EXPECT_LT(rig.sum(vessel::k_dp_heading_rms), 0.1 * k_deg);
  EXPECT_EQ(rig.sum(vessel::k_dp_outside), 0);
  EXPECT_NEAR(rig.sum(vessel::k_dp_time), 300, 1e-6);
  EXPECT_LT(rig.sum(vessel::k_dp_saturation_share), 0.05);
  EXPECT_GT(rig.thrusters->total(vessel::k_thruster_energy).value(), 0);
}

// The load acts suddenly: 150 kN over K_p = 60 kN/m would be 2.5 m. The integral takes that away by the slow root of
// s^3 + 0.1414 s^2 + 0.01 s + 0.0001 = 0, -0.0116 1/s: after ln(2.5 / 0.5) / 0.0116 = 139 s it is back within 0.5 m.
TEST(Dp, CountsTheTimeOutsideOfItsWatchCircle) {
  Rig rig([](vessel::DpSettings& dp, std::vector<Thruster>&) {
    dp.watch_circle = 0.5;
    dp.sensors.position_noise = dp.sensors.heading_noise = 0;
  });
  rig.load = across(1.5e5);
  rig.run(600);
  EXPECT_EQ(rig.sum(vessel::k_dp_alarms), 1);
  EXPECT_NEAR(rig.sum(vessel::k_dp_outside), 139, 25) << "the two fast roots shift it by their time, 10 to 20 s";
  EXPECT_NEAR(rig.sum(vessel::k_dp_offset_max), 2.5, 0.5);
}

// At 300 s two of the tunnels fail. The others take their share: the vessel moves, and holds again.
TEST(Dp, HoldsItsStationAfterABlackout) {
  Rig rig([](vessel::DpSettings& dp, std::vector<Thruster>& all) {
    dp.window = {900, 1200};
    all[0].fails_at = all[3].fails_at = 300;
  });
  rig.load = across(1.5e5);
  rig.run(300);
  const double before = (*rig.channels)[rig.channels->find("bow2.thrust_actual")];
  rig.run(900);
  EXPECT_NEAR((*rig.channels)[rig.channels->find("bow1.thrust_actual")], 0, 1e-9);
  EXPECT_EQ((*rig.channels)[rig.channels->find("bow1.works")], 0);
  EXPECT_NEAR((*rig.channels)[rig.channels->find("bow2.thrust_actual")], 2 * before, 0.3 * std::abs(before));
  EXPECT_LT(rig.sum(vessel::k_dp_offset_rms), 0.15);
}

// 1000 kN are more than the tunnels give: the vessel is driven off, and the run ends where it has lost 20 m. The
// control wants a force against the load all the time.
TEST(Dp, EndsTheRunWhereItHasLostTheVessel) {
  Rig rig([](vessel::DpSettings& dp, std::vector<Thruster>&) { dp.most_offset = 20; });
  rig.load = across(1e6);
  test::expect_refusal<SimulationError>([&] { rig.run(600); },
                                        {"at ", " s dynamic positioning has lost the vessel", "20", "most_offset",
                                         "The force that was wanted then pointed one way", "stronger thrusters"});
  EXPECT_GT(rig.bodies.p_GB[0].y(), 19);
}

// With samples of 3 s and a delay of 6 s the loop of 0.5 rad/s is unstable, whose phase margin allows about 1 s.
TEST(Dp, ADivergingControllerIsAnError) {
  Rig rig([](vessel::DpSettings& dp, std::vector<Thruster>&) {
    dp.controller.bandwidth.setConstant(0.5);
    dp.sensors.delay = 6;
    dp.most_offset = 10;
  });
  rig.load = across(1e5);
  test::expect_refusal<SimulationError>([&] { rig.run(5000); },
                                        {"has lost the vessel", "swung to and fro. So the control diverges",
                                         "a lower <control bandwidth>", "sensor_delay"});
}

// The same within the default most_offset goes on swinging, as far as the thrusters push. The report says so; that of a
// well tuned control does not.
TEST(Dp, AControlThatSwingsIsReported) {
  const auto report = [](double bandwidth, double delay) {
    Rig rig([&](vessel::DpSettings& dp, std::vector<Thruster>&) {
      dp.controller.bandwidth.setConstant(bandwidth);
      dp.sensors.delay = delay;
      dp.most_offset = 1e3;
    });
    rig.load = across(1e5);
    rig.run(600);
    return rig.dp->figures().back();
  };
  const bodies::RunFigure swinging = report(0.5, 6), tuned = report(0.1, 0.5);
  EXPECT_EQ(swinging.name, "swings_1");
  EXPECT_EQ(swinging.value, 1);
  EXPECT_NE(swinging.text.find("swung to and fro. So the control diverges"), std::string::npos) << swinging.text;
  EXPECT_EQ(tuned.value, 0);
  EXPECT_TRUE(tuned.label.empty());
}

// A moment of 60 MN m about the centre of mass is more than the thrusters give, so the vessel turns in place.
TEST(Dp, EndsTheRunWhereTheVesselTurnsAway) {
  Rig rig;
  rig.load = across(0, 6e7);
  test::expect_refusal<SimulationError>([&] { rig.run(600); },
                                        {"within the most_offset of 76 m", " deg from the heading of its reference",
                                         "The moment that was wanted then pointed one way"});
}

// A damping that the vessel does not have makes K_d = 2 zeta w M - D negative: the motion grows by itself.
TEST(Dp, AWrongDampingDiverges) {
  Rig rig([](vessel::DpSettings& dp, std::vector<Thruster>&) {
    dp.controller.damping = {2e6, 2e6, 0};
    dp.most_offset = 10;
  });
  rig.load = across(1e4);
  test::expect_refusal<SimulationError>([&] { rig.run(5000); }, {"has lost the vessel", "damping"});
}

TEST(Dp, RefusesAnObserverThatDoesNotConverge) {
  test::expect_refusal(
      [&] {
        Rig rig([](vessel::DpSettings& dp, std::vector<Thruster>&) {
          dp.observer.wave_period = 8;
          dp.sensors.period = 8;
        });
      },
      {"does not converge", "sensor_period"});
}

TEST(Dp, FollowsAPath) {
  const test::ScratchFolder folder;
  const auto file = folder.write("path.csv", "t_s,x_m,y_m,heading_deg\n50,0,0,350\n150,20,0,350\n250,20,20,10\n");
  Rig rig([&](vessel::DpSettings& dp, std::vector<Thruster>&) {
    dp.plan = vessel::PositioningPlan::path(file.string(), 0);
    dp.window = {500, 600};
  });
  EXPECT_NEAR(rig.settings.plan.at(200).position.z(), 0, 1e-12) << "350 to 10 degrees the shortest way";
  const auto scaled = vessel::PositioningPlan::path(file.string(), 0, 4);
  EXPECT_EQ(scaled.at(200).position.x(), 40) << "halfway, at the root of the scale times 100 s";
  rig.run(600);
  EXPECT_NEAR(rig.bodies.p_GB[0].x(), 20, 0.5);
  EXPECT_NEAR(rig.bodies.p_GB[0].y(), 20, 0.5);
  EXPECT_NEAR(vessel::plane_position(rig.bodies, 0).z() / k_deg, 10, 0.5);
  EXPECT_LT(rig.sum(vessel::k_dp_offset_rms), 0.5);
}

TEST(Dp, PathWhoseTimesDoNotRiseIsRefused) {
  const test::ScratchFolder folder;
  const auto file = folder.write("path.csv", "t_s,x_m,y_m,heading_deg\n0,0,0,0\n0,1,0,0\n");
  test::expect_refusal([&] { vessel::PositioningPlan::path(file.string(), 0); }, {"path.csv:3", "t_s must grow"});
}

// A sample is 0.7 s old, whatever the steps between which its time lies. Until the first is old enough the position at
// the start arrives. Without delay the present position arrives as it is.
TEST(Dp, SensorsDelayTheirSamplesByTheirDelay) {
  vessel::SensorSettings settings{.period = 0.5, .delay = 0.7, .position_noise = 0, .heading_noise = 0, .seed = 1};
  vessel::PositionSensors sensors(settings, 3, Vec3(-1, 0, 0));
  EXPECT_EQ(sensors.sample().x(), -1);
  sensors.note(3.5, Vec3(1, 0, 0));
  EXPECT_EQ(sensors.sample().x(), -1);
  sensors.note(4, Vec3(2, 0, 0));
  EXPECT_NEAR(sensors.sample().x(), -1 + 0.3 / 0.5 * 2, 1e-12);
  for (const double t : {4.1, 4.3, 4.4, 4.6}) sensors.note(t, Vec3(t, 0, 1));
  EXPECT_NEAR(sensors.sample().x(), 1 + 0.4 / 0.5, 1e-12) << "at 3.9 s";
  sensors.note(9, Vec3(9, 0, 2));
  EXPECT_NEAR(sensors.sample().x(), 8.3, 1e-12);
  settings.delay = 0;
  vessel::PositionSensors prompt(settings, 0, Vec3::Zero());
  prompt.note(1, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(prompt.sample(), Vec3(0.1, 0.2, 0.3));
}

TEST(Dp, ContinuesWithTheSameBits) {
  const auto change = [](vessel::DpSettings& dp, std::vector<Thruster>& all) {
    dp.sensors.delay = 0.5;
    dp.sensors.period = 0.25;  // not a multiple of the step
    all[0].fails_at = 40;
  };
  Rig whole(change), first(change), rest(change);
  whole.load = first.load = rest.load = across(1.5e5, 2e6);
  whole.run(100);
  first.run(30);
  State state;
  first.bodies.save(StateWriter(state).group("bodies"));
  first.thrusters->save(first.bodies, StateWriter(state).group("thruster"));
  first.dp->save(first.bodies, StateWriter(state).group("control"));
  first.channels->save(StateWriter(state).group("channels"));
  rest.bodies.restore(StateReader(state).group("bodies"));
  rest.thrusters->restore(StateReader(state).group("thruster"));
  rest.dp->restore(StateReader(state).group("control"));
  rest.channels->restore(StateReader(state).group("channels"));
  rest.t = first.t;
  rest.run(70);
  EXPECT_EQ(rest.bodies.p_GB[0], whole.bodies.p_GB[0]);
  EXPECT_EQ(rest.bodies.w_GB[0], whole.bodies.w_GB[0]);
  EXPECT_EQ(rest.sum(vessel::k_dp_offset_rms), whole.sum(vessel::k_dp_offset_rms));
}

}  // namespace dp_module_test
