/// <manoeuvring> and <manoeuvre>: their values arrive, and what contradicts itself is refused.
#include <gtest/gtest.h>

#include "tests/core/scene/scene_files.h"

namespace nilas::scene {
namespace check_manoeuvring_test {

using testing::expect_fault;
using testing::in_scene;
using testing::SceneFolder;
using testing::text_of;

const std::string k_ship = "<manoeuvring preset='kvlcc2'/>";

std::string vessel_with(const std::string& inside, const std::string& water = "<water/>") {
  return in_scene(water + "<vessel position='0 0 0'><hull/><mass value='1'/>\n" + inside + "</vessel>");
}

std::vector<Fault> faults_of(const std::string& inside, const std::string& water = "<water/>") {
  const SceneFolder folder;
  folder.write("ship.csv", "name,value\n");
  folder.write("orders.csv", "t_s,heading_deg,speed_m_s\n0,0,1\n");
  return folder.faults(vessel_with(inside, water));
}

TEST(CheckManoeuvring, ValuesArrive) {
  const SceneFolder folder;
  folder.write("ship.csv", "name,value\n");
  folder.write("orders.csv", "t_s,heading_deg,speed_m_s\n0,0,1\n");
  const Scene scene =
      folder.read(vessel_with("<manoeuvring model='derivatives' file='ship.csv' propulsion='thrust-curve' midship='3' "
                              "rudder_rate_deg_s='5' max_rudder_deg='40' propeller='2' propeller_rate='0.3'/>"
                              "<manoeuvre kind='course' start='7' heading_gain='3' yaw_rate_gain='4' heading_time='5' "
                              "speed_gain='6' speed_time='8' file='orders.csv'/>"));
  const ManoeuvringScene& ship = scene.vessel.value().manoeuvring.value();
  EXPECT_EQ(ship.model, ManoeuvringModel::derivatives);
  EXPECT_EQ(ship.file, (folder.path() / "ship.csv").string());
  EXPECT_EQ(ship.propulsion, PropulsionKind::thrust_curve);
  EXPECT_EQ(ship.midship, 3);
  EXPECT_EQ(ship.rudder_rate_deg_s, 5);
  EXPECT_EQ(ship.max_rudder_deg, 40);
  EXPECT_EQ(ship.propeller, 2);
  EXPECT_EQ(ship.propeller_rate, 0.3);
  const ManoeuvreScene& manoeuvre = scene.vessel->manoeuvre.value();
  EXPECT_EQ(manoeuvre.kind, ManoeuvreKind::course);
  EXPECT_EQ(manoeuvre.start, 7);
  EXPECT_EQ(manoeuvre.heading_gain, 3);
  EXPECT_EQ(manoeuvre.yaw_rate_gain, 4);
  EXPECT_EQ(manoeuvre.heading_time, 5);
  EXPECT_EQ(manoeuvre.speed_gain, 6);
  EXPECT_EQ(manoeuvre.speed_time, 8);
  EXPECT_EQ(manoeuvre.file, (folder.path() / "orders.csv").string());
}

TEST(CheckManoeuvring, DefaultsAreThoseOfThePlainStructs) {
  const SceneFolder folder;
  const Scene scene = folder.read(vessel_with(k_ship + "<manoeuvre/>"));
  ManoeuvringScene ship;
  ship.preset = ManoeuvringPreset::kvlcc2;
  EXPECT_EQ(scene.vessel.value().manoeuvring.value(), ship);
  EXPECT_EQ(scene.vessel->manoeuvre.value(), ManoeuvreScene{});
}

TEST(CheckManoeuvring, WholeScenesAreTaken) {
  for (const std::string manoeuvre :
       {"", "<manoeuvre kind='turning-circle' angle_deg='-35'/>", "<manoeuvre kind='zigzag' heading_deg='20'/>",
        "<manoeuvre kind='course' heading_deg='-20' speed='0'/>", "<manoeuvre kind='course' file='orders.csv'/>"})
    EXPECT_TRUE(faults_of(k_ship + manoeuvre).empty()) << text_of(faults_of(k_ship + manoeuvre));
  EXPECT_TRUE(faults_of("<manoeuvring preset='supply' model='derivatives' length='30'/>").empty());
}

TEST(CheckManoeuvring, CoefficientsComeFromOnePlace) {
  expect_fault(faults_of("<manoeuvring/>"), 3, "<vessel><manoeuvring>", {"no coefficients", "preset="});
  expect_fault(faults_of("<manoeuvring preset='kvlcc2' file='ship.csv'/>"), 3, "<vessel><manoeuvring>",
               {"a preset and a file"});
  expect_fault(faults_of("<manoeuvring preset='supply'/>"), 3, "<vessel><manoeuvring preset>",
               {"with model 'mmg'", "model=\"derivatives\""});
  expect_fault(faults_of("<manoeuvring file='ship.csv' length='3'/>"), 3, "<vessel><manoeuvring length>", {"length_m"});
  expect_fault(faults_of("<manoeuvring preset='kvlcc2' propulsion='open-water'/>"), 3,
               "<vessel><manoeuvring propulsion>", {"with a file"});
}

/// A run folder holds the scene with its defaults, and a run that is resumed reads it again.
TEST(CheckManoeuvring, ASceneOfARunFolderIsReadAgain) {
  const SceneFolder folder;
  const Scene scene = folder.read(vessel_with(k_ship + "<manoeuvre kind='zigzag'/>"));
  EXPECT_NO_THROW(folder.read(scene.as_run));
}

TEST(CheckManoeuvring, PositioningGivesCommandsToo) {
  expect_fault(faults_of(k_ship + "<manoeuvre/><thrusters><thruster name='a' kind='azimuth' at='1 0 0' max_thrust='1' "
                                  "power='1'/><thruster name='b' kind='azimuth' at='-1 0 0' max_thrust='1' "
                                  "power='1'/></thrusters><control mode='dp'/>"),
               3, "<vessel><manoeuvre>", {"found <control mode=\"dp\">", "one of them"});
}

TEST(CheckManoeuvring, NeedsAFreeVesselInWater) {
  expect_fault(faults_of(k_ship + "<carriage/>"), 3, "<vessel><manoeuvring>", {"found <carriage>", "a free vessel"});
  expect_fault(faults_of(k_ship + "<fixed/>"), 3, "<vessel><manoeuvring>", {"found <fixed>"});
  expect_fault(faults_of(k_ship, ""), 3, "<vessel><manoeuvring>", {"no water"});
  expect_fault(faults_of(k_ship, "<water/><hydro><added_mass vessel='matrix' matrix='1 1 1 1 1 1'/></hydro>"), 2,
               "<hydro><added_mass vessel>", {"of its own model"});
}

TEST(CheckManoeuvring, ReferenceIsRefused) {
  expect_fault(faults_of(k_ship, "<water/><contact integrator='reference'/>"), 3, "<vessel><manoeuvring>",
               {"integrator 'reference'", "have a state"});
}

TEST(CheckManoeuvring, ManoeuvresFitTheShip) {
  expect_fault(faults_of("<manoeuvre/>"), 3, "<vessel><manoeuvre>", {"with <manoeuvring>"});
  expect_fault(faults_of(k_ship + "<manoeuvre kind='turning-circle' angle_deg='36'/>"), 3,
               "<vessel><manoeuvre angle_deg>", {"found 36", "max_rudder_deg"});
  expect_fault(faults_of(k_ship + "<manoeuvre kind='zigzag' heading_deg='-10'/>"), 3, "<vessel><manoeuvre heading_deg>",
               {"> 0 [deg]"});
  expect_fault(faults_of(k_ship + "<manoeuvre kind='course' file='orders.csv' speed='1'/>"), 3,
               "<vessel><manoeuvre speed>", {"one of them"});
}

}  // namespace check_manoeuvring_test
}  // namespace nilas::scene
