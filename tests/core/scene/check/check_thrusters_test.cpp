/// Reading and checks of <thrusters> and <control>.
#include <gtest/gtest.h>

#include "tests/core/scene/scene_files.h"

namespace nilas::scene {
namespace check_thrusters_test {

using testing::expect_fault;
using testing::in_scene;
using testing::SceneFolder;

const std::string k_bow = "<thruster name='bow' kind='tunnel' at='60 0 2' max_thrust='2e5' power='1.5e6'/>";
const std::string k_aft = "<thruster name='aft' kind='azimuth' at='3 0 2' max_thrust='5e5' power='3e6'/>";

std::string vessel(const std::string& inside) {
  return in_scene("<vessel><hull length='76.2'/><mass value='6e6'/>" + inside + "</vessel>");
}
/// The thrusters stand in line 4 of the scene.
std::string fitted(const std::string& thrusters, const std::string& control = "") {
  return vessel("\n<thrusters>\n" + thrusters + "\n</thrusters>" + control);
}

TEST(Thrusters, AreRead) {
  const SceneFolder folder;
  folder.write("loss.csv", "speed_m_s,thrust_share\n0,1\n");
  const Scene scene = folder.read(fitted(
      "<thruster name='a' kind='azimuth' at='3 4 5' max_thrust='5e5' max_astern='1e5' power='3e6' lag='2' rate='7e4' "
      "turn_rate_deg='9' forbidden_deg='80 100 -100 -80' loss='0.2' loss_table='loss.csv' fails_at='40' thrust='1e4' "
      "angle_deg='30'/>"
      "<thruster name='b' kind='propeller-rudder' at='1 0 0' max_thrust='6e5' power='4e6' free_speed='8' "
      "rudder_area='9' rudder_span='4' rudder_distance='2' diameter='3.6' rudder_limit_deg='30'/>"));
  ASSERT_EQ(scene.vessel->thrusters.size(), 2u);
  const ThrusterScene& a = scene.vessel->thrusters[0];
  EXPECT_EQ(a.name, "a");
  EXPECT_EQ(a.kind, ThrusterKind::azimuth);
  EXPECT_EQ(a.at, Vec3(3, 4, 5));
  EXPECT_EQ(a.max_thrust, 5e5);
  EXPECT_EQ(a.max_astern, 1e5);
  EXPECT_EQ(a.power, 3e6);
  EXPECT_EQ(a.lag, 2);
  EXPECT_EQ(a.rate, 7e4);
  EXPECT_EQ(a.turn_rate_deg, 9);
  EXPECT_EQ(a.forbidden_deg, (std::vector<double>{80, 100, -100, -80}));
  EXPECT_EQ(a.loss, 0.2);
  EXPECT_TRUE(a.loss_table.ends_with("loss.csv"));
  EXPECT_EQ(a.fails_at, 40);
  EXPECT_EQ(a.thrust, 1e4);
  EXPECT_EQ(a.angle_deg, 30);
  const ThrusterScene& b = scene.vessel->thrusters[1];
  EXPECT_EQ(b.kind, ThrusterKind::propeller_rudder);
  EXPECT_EQ(b.free_speed, 8);
  EXPECT_EQ(b.rudder_area, 9);
  EXPECT_EQ(b.rudder_span, 4);
  EXPECT_EQ(b.rudder_distance, 2);
  EXPECT_EQ(b.diameter, 3.6);
  EXPECT_EQ(b.rudder_limit_deg, 30);
}

TEST(Thrusters, ControlIsRead) {
  const SceneFolder folder;
  const Scene scene = folder.read(fitted(
      k_bow + k_aft,
      "<control mode='dp' setpoint='1 2' heading_deg='30' bandwidth='0.2 0.3 0.4' damping_ratio='0.8' "
      "filter_bandwidth='0.1 0.1 0.1' observer_bandwidth='1 1 2' wave_period='9' added_mass='1 2' added_inertia='3' "
      "damping='4 5' yaw_damping='6' wind_feed_forward='false' sensor_period='0.5' sensor_delay='1' "
      "position_noise='0.1' "
      "heading_noise_deg='0.2' watch_circle='3' most_offset='40'/>"));
  const ControlScene& dp = scene.vessel->control.value();
  EXPECT_EQ(dp.mode, ControlMode::dp);
  EXPECT_EQ(dp.setpoint, Vec2(1, 2));
  EXPECT_EQ(dp.heading_deg, 30);
  EXPECT_EQ(dp.bandwidth, Vec3(0.2, 0.3, 0.4));
  EXPECT_EQ(dp.damping_ratio, 0.8);
  EXPECT_EQ(dp.filter_bandwidth, Vec3(0.1, 0.1, 0.1));
  EXPECT_EQ(dp.observer_bandwidth, Vec3(1, 1, 2));
  EXPECT_EQ(dp.wave_period, 9);
  EXPECT_EQ(dp.added_mass, Vec2(1, 2));
  EXPECT_EQ(dp.added_inertia, 3);
  EXPECT_EQ(dp.damping, Vec2(4, 5));
  EXPECT_EQ(dp.yaw_damping, 6);
  EXPECT_FALSE(dp.wind_feed_forward);
  EXPECT_EQ(dp.sensor_period, 0.5);
  EXPECT_EQ(dp.sensor_delay, 1);
  EXPECT_EQ(dp.position_noise, 0.1);
  EXPECT_EQ(dp.heading_noise_deg, 0.2);
  EXPECT_EQ(dp.watch_circle, 3);
  EXPECT_EQ(dp.most_offset, 40);
}

/// At the length of the supply vessel the defaults of the schema are those of the structs.
TEST(Thrusters, HaveTheDefaultsOfTheirStructs) {
  const SceneFolder folder;
  const Scene scene = folder.read(fitted(k_bow + k_aft, "<control mode='dp'/>"));
  ThrusterScene plain;
  plain.name = "bow";
  plain.at = {60, 0, 2};
  plain.max_thrust = 2e5;
  plain.power = 1.5e6;
  plain.line = scene.vessel->thrusters[0].line;
  EXPECT_EQ(scene.vessel->thrusters[0], plain);
  ControlScene control;
  control.mode = ControlMode::dp;
  EXPECT_EQ(scene.vessel->control, control);
}

/// A model of 1:45 has its lag and its bandwidths by Froude: sqrt(45) = 6.708.
TEST(Thrusters, ModelsScaleTheirDefaultsByFroude) {
  const SceneFolder folder;
  std::string text = fitted(k_bow + k_aft, "<control mode='dp'/>");
  text.replace(text.find("76.2"), 4, "1.69333333");
  const Scene scene = folder.read(text);
  EXPECT_EQ(scene.vessel->thrusters[1].lag, 0.149);
  EXPECT_EQ(scene.vessel->thrusters[1].turn_rate_deg, 80.5);
  EXPECT_EQ(scene.vessel->control->bandwidth, Vec3(0.671, 0.671, 1.34));
}

struct Wrong {
  std::string thrusters, where;
  std::vector<std::string> words;
};

TEST(Thrusters, WrongOnesAreRefusedWithTheirPlace) {
  const SceneFolder folder;
  folder.write("loss.csv", "speed_m_s,thrust_share\n0,1\n");
  const std::string place = "<vessel><thrusters><thruster ";
  const std::vector<Wrong> cases{
      {"<thruster name='a' kind='tunel' at='0 0 0' max_thrust='1' power='1'/>", place + "kind>", {"tunel", "tunnel"}},
      {"<thruster name='a' kind='tunnel' at='0 0 0' max_thrust='-1' power='1'/>",
       place + "max_thrust>",
       {"'-1'", "> 0"}},
      {"<thruster name='a' kind='tunnel' at='0 0 0' max_thrust='1' max_astern='-1' power='1'/>",
       place + "max_astern>",
       {"'-1'", ">= 0"}},
      {"<thruster name='a' kind='tunnel' at='0 0 0' max_thrust='1' power='1' thrust='2'/>",
       place + "thrust>",
       {"-1 to 1"}},
      {"<thruster name='a' kind='tunnel' at='0 0 0' max_thrust='1' power='1' loss='1'/>",
       place + "loss>",
       {"'1'", "< 1"}},
      {"<thruster name='a' kind='azimuth' at='0 0 0' max_thrust='1' power='1' forbidden_deg='1 2 3'/>",
       place + "forbidden_deg>",
       {"3 numbers", "pairs"}},
      {"<thruster name='a' kind='azimuth' at='0 0 0' max_thrust='1' power='1' forbidden_deg='10 30 20 50'/>",
       place + "forbidden_deg>",
       {"'10 30' and '20 50'", "overlap"}},
      {"<thruster name='a' kind='azimuth' at='0 0 0' max_thrust='1' power='1' forbidden_deg='0 10 170 -170 175 178'/>",
       place + "forbidden_deg>",
       {"'170 -170' and '175 178'", "overlap"}},
      {"<thruster name='a' kind='azimuth' at='0 0 0' max_thrust='1' power='1' forbidden_deg='-180 180'/>",
       place + "forbidden_deg>",
       {"'-180 180'", "without width or a whole turn"}},
      {"<thruster name='a' kind='tunnel' at='0 0 0' max_thrust='1' power='1' free_speed='3' loss_table='loss.csv'/>",
       place + "loss_table>",
       {"one of them"}},
      {"<thruster name='a' kind='propeller-rudder' at='0 0 0' max_thrust='1' power='1' rudder_area='1' rudder_span='1' "
       "diameter='1'/>",
       "<vessel><thrusters><thruster>",
       {"rudder_distance"}},
      {k_bow + k_bow, place + "name>", {"'bow' twice"}}};
  for (const Wrong& c : cases) {
    SCOPED_TRACE(c.thrusters);
    expect_fault(folder.faults(fitted(c.thrusters)), 4, c.where, c.words);
  }
}

TEST(Thrusters, NeedAFreeVesselAndAStep) {
  const SceneFolder folder;
  expect_fault(folder.faults(fitted(k_bow, "<fixed/>")), 3, "<vessel><thrusters>", {"<fixed>", "free vessel"});
  expect_fault(folder.faults(fitted(k_bow, "<carriage speed='1'/>")), 3, "<vessel><thrusters>", {"<carriage>"});
  expect_fault(folder.faults(fitted("")), 3, "<vessel><thrusters>", {"no thruster"});
}

TEST(Thrusters, PositioningNeedsSurgeSwayAndYaw) {
  const SceneFolder folder;
  const std::string dp = "<control mode='dp'/>", at = "<vessel><thrusters>";
  const std::string main = "<thruster name='main' kind='propeller' at='3 0 2' max_thrust='5e5' power='3e6'/>";
  EXPECT_TRUE(folder.faults(fitted(k_bow + k_aft, dp)).empty());
  expect_fault(folder.faults(fitted(k_bow, dp)), 3, at, {"surge"});
  expect_fault(folder.faults(fitted(main, dp)), 3, at, {"sway"});
  // One tunnel and one propeller on the centre line: sway always comes with the same yaw.
  expect_fault(folder.faults(fitted(main + k_bow, dp)), 3, at, {"no thruster gives yaw"});
  expect_fault(folder.faults(vessel("\n" + dp)), 3, "<vessel><control mode>", {"needs <thrusters>"});
}

TEST(Thrusters, SamplesOfPositioningTakeAtLeastAStep) {
  const SceneFolder folder;
  const auto faults = [&](const std::string& period, const std::string& time) {
    std::string text = fitted(k_bow + k_aft, "<control mode='dp' sensor_period='" + period + "'/>");
    return folder.faults(text.replace(text.find("<vessel>"), 0, time));
  };
  const std::string at = "<vessel><control sensor_period>";
  // A hull of this length has a step of 0.05 s by default.
  expect_fault(faults("0.005", ""), 5, at, {"0.005", "shorter than the time step", "at least 0.05 [s]"});
  EXPECT_TRUE(faults("0.05", "").empty());
  expect_fault(faults("0.3", "<time step='0.5'/>"), 5, at, {"at least 0.5 [s]"});
}

TEST(Thrusters, PositioningTakesAPathOrASetPoint) {
  const SceneFolder folder;
  folder.write("path.csv", "t_s,x_m,y_m,heading_deg\n0,0,0,0\n");
  expect_fault(folder.faults(fitted(k_bow + k_aft, "<control mode='dp' path='path.csv' setpoint='0 0'/>")), 5,
               "<vessel><control setpoint>", {"one of them"});
}

}  // namespace check_thrusters_test
}  // namespace nilas::scene
