/// Scenes that are valid but hardly intended.
#include "core/sim/build/implausible.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/scene/read/read_scene.h"
#include "core/sim/build/build_world.h"
#include "core/sim/simulation.h"
#include "core/sim/world/course.h"
#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace nilas::sim {
namespace implausible_test {

class Implausible : public ::testing::Test {
 protected:
  scene::Scene read(const std::string& content) {
    return scene::read_scene(folder_.write("scene.xml", "<scene version=\"1\">\n" + content + "\n</scene>\n"));
  }
  std::vector<Fault> warnings(const std::string& content) {
    const scene::Scene scene = read(content);
    WarningCounts counts(make_logger("off", ""));
    return build_world(scene, 1, counts).info.warnings;
  }
  void expect_warning(const std::string& content, const std::string& where, const std::string& words) {
    const auto all = warnings(content);
    EXPECT_TRUE(std::any_of(
        all.begin(), all.end(),
        [&](const Fault& w) { return w.where == where && w.message.find(words) != std::string::npos && w.line > 0; }))
        << content << "\n"
        << words << text(all);
  }
  static std::string text(const std::vector<Fault>& all) {
    std::string text;
    for (const auto& w : all) text += "\n" + w.text();
    return text;
  }

  test::ScratchFolder folder_;
};

const std::string k_wet = "<time step='0.01' end='10'/><water/><hydro><buoyancy/><drag/></hydro>\n";
const std::string k_floe = "<ice thickness='0.04'><floe outline='10 -1 11 -1 11 1 10 1'/></ice>\n";

/// A hull of 3 m whose stern stands at x = 1, towed.
std::string towed(const std::string& carriage) {
  return "<vessel position='1 0'><hull length='3' beam='0.6'/><mass draught='0.175'/>" + carriage + "</vessel>\n";
}

TEST_F(Implausible, ATowThroughIceThatStaysIsNot) {
  const auto all = warnings(k_wet + towed("<carriage speed='1' ramp='2' free='heave'/>") + k_floe +
                            "<tank length='30' width='8' depth='3'/>");
  EXPECT_TRUE(all.empty()) << text(all);
}

TEST_F(Implausible, IceThatSinks) {
  expect_warning(k_wet + "<ice density='1100'><floe outline='0 0 1 0 1 1' velocity='1 0 0'/></ice>", "<ice density>",
                 "sinks");
}

TEST_F(Implausible, WaterThatCarriesNothing) {
  expect_warning("<water/>" + k_floe, "<water>", "no <hydro>");
  expect_warning("<water/>" + k_floe, "<ice>", "1 free floes have weight but no buoyancy");
  const auto dry = warnings("<gravity value='0 0 0'/><ice><floe outline='0 0 1 0 1 1' velocity='1 0 0'/></ice>");
  EXPECT_TRUE(dry.empty()) << text(dry);
}

TEST_F(Implausible, FrictionThatNoIceHas) {
  expect_warning("<contact><friction between='ice ice' kinetic='30'/></contact>" + k_wet + k_floe,
                 "<contact><friction kinetic>", "below 1");
}

TEST_F(Implausible, NothingThatMoves) {
  expect_warning("", "<scene>", "no bodies");
  expect_warning("<body name='a' shape='box' fixed='true'/>", "<scene>", "no body of the scene can move");
  expect_warning(k_wet + towed("") + k_floe, "<vessel>", "nothing drives ice and vessel");
}

/// A propeller sets a ship in motion that starts at rest, and so may a program outside.
TEST_F(Implausible, AShipThatDrivesItselfIsNot) {
  for (const std::string drive : {"<manoeuvring preset='kvlcc2' length='3' midship='1.5'/><manoeuvre kind='course' "
                                  "speed='0.5'/>",
                                  "<remote_control socket='no.sock' force='true'/>"})
    for (const Fault& warning : warnings(k_wet + towed(drive) + k_floe))
      EXPECT_EQ(warning.message.find("nothing drives"), std::string::npos) << warning.text();
}

/// The hydrostatics of a database carry a vessel without the pressure on its mesh.
TEST_F(Implausible, AVesselThatADatabaseCarriesDoesNotFall) {
  const auto fall = [&](const std::string& hydro) {
    const auto all = warnings("<water density='1000'/><hydro>" + hydro + "<database file='" + NILAS_SOURCE_DIR +
                              "/tests/data/hydro/wec-sim/sphere.1' length='1' density='1000' gravity='9.81' "
                              "depth='50' origin='1.5 0 0.3'/></hydro><vessel position='0 0 -0.3' velocity='1 0 0'>"
                              "<hull length='3' beam='0.6'/><mass value='261800'/></vessel>");
    return std::any_of(all.begin(), all.end(),
                       [](const Fault& w) { return w.message.find("so it falls") != std::string::npos; });
  };
  EXPECT_TRUE(fall(""));
  EXPECT_FALSE(fall("<restoring/>"));
}

TEST_F(Implausible, ACourseThatNeverMeetsIceOrLeavesIt) {
  expect_warning(k_wet + towed("<carriage speed='0.1' free='heave'/>") + k_floe, "<vessel><carriage speed>",
                 "does not reach the ice within the run");
  expect_warning(k_wet + towed("<carriage speed='2' free='heave'/>") + k_floe, "<vessel><carriage speed>",
                 "left the ice behind at 5 s of 10 s");
}

TEST_F(Implausible, AWindowThatEndsBeforeTheIceDoesSilencesTheWarning) {
  const auto all =
      warnings(k_wet + towed("<carriage speed='2' free='heave'/>") + k_floe + "<output statistics='2 4'/>");
  EXPECT_TRUE(all.empty()) << text(all);
  expect_warning(
      k_wet + towed("<carriage speed='1' ramp='2' free='heave'/>") + k_floe + "<output statistics='90 100'/>",
      "<output statistics>", "has no step of the run");
}

TEST_F(Implausible, ATowAsternIsATow) {
  const auto all = warnings(k_wet + towed("<carriage speed='-1' heading_deg='180' ramp='2' free='heave'/>") + k_floe);
  EXPECT_TRUE(all.empty()) << text(all);
  const scene::Scene scene = read(k_wet + towed("<carriage speed='-1' heading_deg='180' free='heave'/>") + k_floe);
  WarningCounts counts(make_logger("off", ""));
  const StepRecord record = Simulation(scene, 1, counts).step();
  EXPECT_NEAR(record.vessel->course.x(), 1, 1e-12) << "it moves forward";
}

TEST_F(Implausible, ADriftOfZeroHidesNoOther) {
  const scene::Scene scene = read(
      "<water><current velocity='0 0 0'/></water><hydro><buoyancy/><virtual_drag coefficient='1'/></hydro>\n"
      "<body name='pier' shape='cylinder' radius='1' height='4' fixed='true'/><body name='bed' shape='plane' "
      "position='0 0 -3'/>"
      "<ice thickness='0.1'><floe outline='-1 -4 1 -4 1 -2 -1 -2' velocity='0 0.5 0'/></ice>");
  WarningCounts counts(make_logger("off", ""));
  const RunInfo info = build_world(scene, 1, counts).info;
  EXPECT_NEAR(info.drift_course.y(), -1, 1e-12);
  ASSERT_EQ(info.structures.size(), 1u) << "a plane is the ground";
  EXPECT_EQ(info.structures[0].name, "pier");
}

TEST_F(Implausible, ACourseThroughAWallEndsThere) {
  const std::string scene =
      k_wet + towed("<carriage speed='2' free='heave'/>") + k_floe + "<tank length='12' width='8' depth='3'/>";
  expect_warning(scene, "<vessel><carriage speed>", "the hull reaches the tank's end wall (x = 12 m) at 4 s");
  expect_warning(
      k_wet + towed("<carriage speed='2' heading_deg='90' free='heave'/>") + "<tank length='12' width='8' depth='3'/>",
      "<vessel><carriage speed>", "port wall (y = 4 m)");
  WarningCounts counts(make_logger("off", ""));
  Simulation simulation(
      read(k_wet + towed("<carriage speed='2' free='heave'/>") + "<tank length='12' width='8' depth='3'/>"), 1, counts);
  for (int k = 0; simulation.end_of_course().empty() && k < 1000; ++k) simulation.step();
  EXPECT_NEAR(simulation.time(), 4, 0.011) << "8 m at 2 m/s";
  EXPECT_EQ(simulation.end_of_course(), "the carriage would drive the hull into the tank's end wall (x = 12 m)");
}

TEST_F(Implausible, APathThatEndsOrJumps) {
  folder_.write("path.csv", "t_s,x_m,y_m,yaw_deg\n1,0,0,0\n2,1,0,0\n3,2,0,0\n");
  const std::string scene = k_wet + towed("<carriage free='heave'><path file='path.csv'/></carriage>") + k_floe;
  expect_warning(scene, "<vessel><carriage><path>", "the path ends at 3 s; the run ends there");
  expect_warning(scene, "<vessel><carriage><path>", "rests until the path begins at 1 s and then jumps to 1 m/s");
  WarningCounts counts(make_logger("off", ""));
  Simulation simulation(read(scene), 1, counts);
  for (int k = 0; simulation.end_of_course().empty() && k < 1000; ++k) simulation.step();
  EXPECT_NEAR(simulation.time(), 3, 1e-9);
  EXPECT_EQ(simulation.end_of_course(), "the carriage's path ends at 3 s");
}

TEST_F(Implausible, APathThatHasEndedBeforeTheStartIsRefused) {
  folder_.write("path.csv", "t_s,x_m,y_m,yaw_deg\n0,0,0,0\n3,2,0,0\n");
  const std::string scene = "<time step='0.01' start='3' end='4'/><water/><hydro><buoyancy/></hydro>" +
                            towed("<carriage free='heave'><path file='path.csv'/></carriage>") + k_floe;
  WarningCounts counts(make_logger("off", ""));
  test::expect_refusal<InputError>([&] { Simulation(read(scene), 1, counts); },
                                   {"path.csv", "the path ends at 3 s, and the scene starts at 3 s"});
}

TEST_F(Implausible, OverlapsThatIntegratorReferenceKeeps) {
  const std::string boxes = "<body name='one'/><body name='two'/>";
  expect_warning("<contact integrator='reference'/>" + boxes, "<contact>",
                 "'one' and 'two' overlap by 1 m at the start; integrator reference removes no overlap");
  EXPECT_EQ(text(warnings("<contact integrator='moreau'/>" + boxes)).find("overlap"), std::string::npos);
}

TEST_F(Implausible, ARampAndAStepThatDoNotFitThePeriods) {
  const auto on_cells = [](const std::string& stiffness, const std::string& ramp, const std::string& shape = "linear") {
    return towed("<carriage speed='1' ramp='" + ramp + "' ramp_shape='" + shape +
                 "' free='heave'><force_balance kind='six-cells' damping='1' stiffness='" + stiffness +
                 "'/></carriage>") +
           k_floe;
  };
  expect_warning(k_wet + on_cells("1e3", "2"), "<vessel><carriage ramp>", "sets the vessel swinging");
  // a smooth ramp of the same length leaves less than one in twenty of a swing that a linear one leaves a tenth of
  expect_warning(k_wet + on_cells("2e4", "2"), "<vessel><carriage ramp>", "sets the vessel swinging");
  const auto smooth = warnings(k_wet + on_cells("2e4", "2", "smooth"));
  EXPECT_TRUE(smooth.empty()) << text(smooth);
  expect_warning(k_wet + on_cells("2e4", "0", "smooth"), "<vessel><carriage ramp>", "sets the vessel swinging");
  expect_warning("<time step='0.2' end='10'/><water/><hydro><buoyancy/></hydro>\n" + on_cells("1e6", "2"),
                 "<time step>", "misses the vessel's surge on the load cells");
  const auto stiff = warnings(k_wet + on_cells("1e6", "2"));
  EXPECT_TRUE(stiff.empty()) << text(stiff);
}

}  // namespace implausible_test
}  // namespace nilas::sim
