#include "core/output/loads/ice_load.h"

#include <gtest/gtest.h>

#include <sstream>

#include "core/output/loads/ice_load_json.h"
#include "core/output/loads/ice_load_text.h"
#include "core/output/loads/run_statistics.h"
#include "core/output/tables/vessel_channels.h"
#include "tests/core/output/sample_run.h"

namespace nilas::output {
namespace ice_load_test {

/// 200 steps of 0.01 s of a tow along Y with a ramp of 0.5 s: ice presses from 1 s on with -30 N along the course and
/// 4 N to port, water with -5 N, and the vessel of 1500 kg gains 0.01 m/s in each step.
/// A wall bears `others` [N] throughout. From 1.5 s on floes break, and the solver misses its tolerance, where
/// requested.
RunStatistics towed(sim::RunInfo info, double others = 0, bool breaks = false) {
  info.course = sim::CourseKind::carriage;
  info.ramp_end = 0.5;
  info.vessel_length = 4;
  RunStatistics statistics(info);
  statistics.start(0, sim::Ledger{.works = {0, 0}});
  const VesselChannels channels(info);
  std::vector<double> values;
  for (int k = 0; k < 200; ++k) {
    sim::StepRecord record = test::full_record();
    record.t = 0.01 * (k + 1);
    record.solver_short = breaks && k >= 150;
    if (breaks && k == 150) record.broken.emplace_back();
    sim::VesselRecord& vessel = *record.vessel;
    vessel.course = Vec2::UnitY();
    vessel.touches_ice = k >= 100;
    vessel.ice = k >= 100 ? Vec3(-4, -30, 1) : Vec3::Zero();
    vessel.contact.force = vessel.ice - Vec3(0, others, 0);
    vessel.hydro->force = Vec3(0, -5, 9);
    vessel.carriage->about_com.force = Vec3(0, 30 + 5 + others + 1500, 0);
    vessel.state.v = Vec3(0, 0.01 * k, 0);
    channels.read(vessel, values);
    statistics.add(record, values);
  }
  return statistics;
}

TEST(IceLoad, IsToldAlongAndAcrossTheCourseFromTheFirstIceOn) {
  const auto load = towed(test::full_run()).ice_load(nullptr);
  ASSERT_TRUE(load.has_value());
  EXPECT_TRUE(load->touched);
  EXPECT_EQ(load->window.first, 100u);
  EXPECT_DOUBLE_EQ(load->along.statistics.mean, 30) << "positive astern";
  EXPECT_DOUBLE_EQ(load->across.statistics.mean, 4) << "positive to port: -x of a course along y";
  EXPECT_DOUBLE_EQ(load->filter, 0.2 / 5);
  EXPECT_EQ(load->along.half_width, 0) << "a constant load, and residuals of 0";
}

TEST(IceLoad, TheTowForceIsIceWaterAndInertia) {
  const auto load = towed(test::full_run()).ice_load(nullptr);
  ASSERT_TRUE(load->tow.has_value());
  EXPECT_DOUBLE_EQ(load->tow->mean, 1535);
  EXPECT_DOUBLE_EQ(load->tow->ice, 30);
  EXPECT_DOUBLE_EQ(load->tow->water, 5);
  EXPECT_DOUBLE_EQ(load->tow->inertia, 1500) << "m dv/dt";
  EXPECT_NEAR(load->tow->speed, 1.495, 1e-12);
}

TEST(IceLoad, WhatWallsAndBodiesTakeIsNoIceLoad) {
  const auto load = towed(test::full_run(), 7).ice_load(nullptr);
  EXPECT_DOUBLE_EQ(load->along.statistics.mean, 30);
  EXPECT_DOUBLE_EQ(load->tow->mean, 1542);
  EXPECT_DOUBLE_EQ(load->tow->others, 7);
  EXPECT_DOUBLE_EQ(load->tow->inertia, 1500);
}

TEST(IceLoad, TheWindowAskedForCounts) {
  sim::RunInfo info = test::full_run();
  info.statistics = {0.5, 1.5};
  const auto load = towed(info).ice_load(nullptr);
  EXPECT_EQ(load->window.steps(), 100u);
  EXPECT_DOUBLE_EQ(load->along.statistics.mean, 15);
}

TEST(IceLoad, LinesFitTheScreenAndNameWhatPeaksDependOn) {
  RunStatistics statistics = towed(test::full_run());
  auto load = statistics.ice_load(nullptr);
  const LoadError error = statistics.load_error(nullptr).value();
  load->in_largest = 0.5;
  load->tow->open_water = 5;
  load->tow->open_water_source = "towed without ice";
  const std::string text = ice_load_lines(*load, error);
  EXPECT_NE(text.find("ice load              30 N +- 0 N astern, 4 N +- 0 N to port\n"), std::string::npos) << text;
  EXPECT_NE(text.find("1 s to 2 s, from the first contact with ice"), std::string::npos) << text;
  EXPECT_NE(text.find("step of 0.01 s"), std::string::npos) << text;
  EXPECT_NE(text.find("  advice              1 % of the window's steps carry 50 % of its load: single\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("<fracture><crushing>"), std::string::npos) << text;
  EXPECT_NE(text.find("  to be used          Use the mean with its +-, the filtered peak and the 99th\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("1530 N after deduction of 5 N in open water"), std::string::npos) << text;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) EXPECT_LE(line.size(), 80u) << line;
  load->rigid = false;
  EXPECT_FALSE(load->impacts_dominate()) << "what crushes is limited already";
}

TEST(IceLoad, ARawPeakOfOneOrTwoStepsIsAnImpulseOverTheStep) {
  RunStatistics statistics = towed(test::full_run());
  auto load = statistics.ice_load(nullptr);
  EXPECT_FALSE(load->peak_is_impulse_over_step()) << "a constant load";
  EXPECT_EQ(raw_peak_depends_on(*load).find("impulse over"), std::string::npos);
  load->along.peak.raw = 300;
  for (const int steps : {1, 2, 3}) {
    load->along.peak.event_to = load->along.peak.event_from + steps * load->step;
    EXPECT_EQ(load->peak_is_impulse_over_step(), steps < 3) << steps;
    const std::string text = raw_peak_depends_on(*load);
    EXPECT_EQ(
        text.find("is the impulse over the time step of 0.01 s: half the step gives about twice") != std::string::npos,
        steps < 3)
        << text;
    EXPECT_EQ(ice_load_json(*load, sim::CourseKind::carriage)["peaks"]["raw_is_impulse_over_step"], steps < 3);
  }
  load->along.peak.event_to = load->along.peak.event_from + load->step;
  load->rigid = false;
  EXPECT_FALSE(load->peak_is_impulse_over_step()) << "crushing limits it";
  load->elastic = true;
  EXPECT_TRUE(load->peak_is_impulse_over_step()) << "stiffer than the step resolves";
  load->along.peak.event_to += load->step * 20;
  EXPECT_NE(raw_peak_depends_on(*load).find("stiffness of the contacts"), std::string::npos);
}

/// The side stands in words, so no number of a load has a sign.
TEST(IceLoad, ALoadToTheOtherSideIsPositiveToo) {
  RunStatistics statistics = towed(test::full_run());
  auto load = statistics.ice_load(nullptr);
  for (ComponentLoad* part : {&load->along, &load->across}) {
    part->statistics.mean *= -1;
    part->peak.raw *= -1;
    part->peak.filtered *= -1;
    part->peak.event_impulse *= -1;
  }
  load->tow.reset();
  const std::string text = ice_load_lines(*load, statistics.load_error(nullptr).value());
  EXPECT_NE(text.find("ice load              30 N +- 0 N forward, 4 N +- 0 N to starboard\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("30 N forward at "), std::string::npos) << text;
  EXPECT_NE(text.find(" s, 4 N to starboard: means over 0.04"), std::string::npos) << text;
  EXPECT_NE(text.find("30 N forward in one step"), std::string::npos) << text;
  for (const char digit : {'3', '4'}) EXPECT_EQ(text.find(std::string(" -") + digit), std::string::npos) << text;
  EXPECT_EQ(sided_force(-7.506, k_to_port), "7.506 N to starboard");
  EXPECT_EQ(sided_force(0, k_to_port), "0 N to port");
  EXPECT_EQ(sided_force(-7.506, {"across"}), "-7.506 N across") << "no word tells the side";
}

TEST(IceLoad, SaysWhereTheHalvesOfTheWindowDiffer) {
  RunStatistics statistics = towed(test::full_run());
  auto load = statistics.ice_load(nullptr);
  const LoadError error = statistics.load_error(nullptr).value();
  ASSERT_TRUE(load->along.halves.has_value());
  EXPECT_EQ(ice_load_lines(*load, error).find("not steady"), std::string::npos) << "a constant load";
  load->along.halves = HalfMeans{{11.79, 0.3867}, {19.97, 0.4546}};
  load->across.halves = HalfMeans{{1, 0.5}, {-1, 0.4}};
  const std::string text = ice_load_lines(*load, error);
  EXPECT_NE(text.find("  not steady          The mean was 11.79 N +- 0.39 N astern over the first half\n"
                      "                      of the window and 19.97 N +- 0.45 N astern over the\n"
                      "                      second. Either the load still changes or the window holds\n"
                      "                      too little ice: run longer.\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("1 N +- 0.50 N to port over the first"), std::string::npos) << text;
  EXPECT_NE(text.find("1 N +- 0.40 N to starboard"), std::string::npos) << text;
  const auto json = ice_load_json(*load, sim::CourseKind::carriage)["along"]["halves"];
  EXPECT_EQ(json["mean_N"], (std::vector<double>{11.79, 19.97}));
  EXPECT_EQ(json["estimate_N"], (std::vector<double>{0.3867, 0.4546}));
  EXPECT_EQ(json["differ"], true);
  load->along.halves.reset();
  EXPECT_TRUE(ice_load_json(*load, sim::CourseKind::carriage)["along"]["halves"].is_null());
}

TEST(IceLoad, WhereTheSolverStoppedShortTheErrorIsALowerBound) {
  RunStatistics statistics = towed(test::full_run(), 0, true);
  const LoadError error = statistics.load_error(nullptr).value();
  EXPECT_TRUE(error.ice_broke);
  EXPECT_DOUBLE_EQ(error.share_short, 0.5);
  const std::string text = ice_load_lines(*statistics.ice_load(nullptr), error);
  EXPECT_NE(text.find("30 N +- at least 0 N astern, 4 N +- at least 0 N to port"), std::string::npos) << text;
  EXPECT_NE(text.find("In 50\n                      % of the window's steps the solver residual was above the\n        "
                      "              scene's"),
            std::string::npos)
      << text;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) EXPECT_LE(line.size(), 80u) << line;
}

TEST(IceLoad, BreaksBehindTheWindowAreNoneOfIts) {
  sim::RunInfo info = test::full_run();
  info.statistics = {0.5, 1.5};
  const LoadError error = towed(info, 0, true).load_error(nullptr).value();
  EXPECT_FALSE(error.ice_broke);
  EXPECT_EQ(error.share_short, 0);
}

TEST(IceLoad, SaysThatNoIceTouched) {
  sim::RunInfo info = test::full_run();
  RunStatistics statistics(info);
  sim::StepRecord record = test::full_record();
  record.vessel->contact = {};
  record.vessel->ice.setZero();
  std::vector<double> values;
  VesselChannels(info).read(*record.vessel, values);
  statistics.add(record, values);
  const std::string text = ice_load_lines(*statistics.ice_load(nullptr), *statistics.load_error(nullptr));
  EXPECT_NE(text.find("none: no ice pressed on the hull"), std::string::npos) << text;
}

TEST(IceLoad, ForcesHaveFourDigitsAndTheirUnit) {
  EXPECT_EQ(force_text(16.8765), "16.88 N");
  EXPECT_EQ(force_text(-252345), "-252.3 kN");
  EXPECT_EQ(force_text(9.746e9), "9746 MN");
}

TEST(StructureLoads, AreToldPerFixedBody) {
  sim::RunInfo info;
  info.structures = {{"pier", 4}, {"pile", 4}};
  info.drift_course = Vec2(-1, 0);
  RunStatistics statistics(info);
  statistics.start(0, sim::Ledger{});
  sim::StepRecord record;
  record.h = 0.1;
  record.structures.resize(2);
  for (int k = 0; k < 40; ++k) {
    record.t = 0.1 * (k + 1);
    record.structures[0].touches_ice = k >= 20;
    record.structures[0].ice = k >= 20 ? Vec3(8, 2, 0) : Vec3::Zero();
    statistics.add(record, {});
  }
  const auto loads = statistics.structure_loads();
  ASSERT_EQ(loads.size(), 2u);
  EXPECT_TRUE(loads[0].ice.touched);
  EXPECT_FALSE(loads[1].ice.touched);
  EXPECT_DOUBLE_EQ(loads[0].ice.window.from, 2);
  EXPECT_DOUBLE_EQ(loads[0].ice.along.statistics.mean, 8) << "with the drift";
  EXPECT_DOUBLE_EQ(loads[0].ice.across.statistics.mean, -2) << "port of what faces -x is -y";
  EXPECT_EQ(loads[0].loads.front().first, "contact_fx_N");
  State state;
  statistics.save(StateWriter(state));
  RunStatistics rest(info);
  rest.restore(StateReader(state));
  EXPECT_EQ(rest.structure_loads()[0].ice.along.statistics.mean, 8);
  EXPECT_EQ(rest.structure_loads()[0].ice.window.from, loads[0].ice.window.from);
}

}  // namespace ice_load_test
}  // namespace nilas::output
