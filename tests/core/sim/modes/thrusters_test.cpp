/// Thrusters and dynamic positioning in whole scenes.
#include <gtest/gtest.h>

#include "tests/core/sim/scene_rig.h"
#include "tests/support/refusal.h"

namespace thrusters_test {

using namespace nilas;
using namespace nilas::sim;

using Rig = test::SceneRig;

const std::string k_water = "<water density='1000'/><hydro><buoyancy/><drag form='1' skin='0'/></hydro>";

/// A box of 2 m x 1 m x 0.5 m and 500 kg, which floats at a draught of 0.25 m.
std::string box(const std::string& inside, const std::string& attributes = "position='0 0'") {
  return test::box_vessel(attributes, inside, 500);
}
std::string propeller(const std::string& more = "") {
  return "<thrusters><thruster name='main' kind='propeller' at='-1 0 -0.125' max_thrust='20' power='100' lag='0.5' " +
         more + "/></thrusters>";
}
const std::string k_station =
    "<thrusters><thruster name='bow' kind='tunnel' at='0.8 0 0' max_thrust='30' power='60' lag='0.1'/>"
    "<thruster name='stern' kind='tunnel' at='-0.8 0 0' max_thrust='30' power='60' lag='0.1'/>"
    "<thruster name='main' kind='azimuth' at='-1 0 0' max_thrust='40' power='80' lag='0.1' turn_rate_deg='60'/>"
    "</thrusters>";

// Drag on the bow, 1/2 rho C_f A v^2 with A = 1 m x 0.25 m, meets a thrust of 5 N at v = sqrt(2 * 5 / 250) = 0.2 m/s.
// Thrust and drag act at the height of the centre of mass, so that the box does not pitch. From 0.1 m/s the difference
// decays with m / (rho C_f A v) = 10 s: after 150 s 3e-8 m/s are left.
TEST(Thrusters, SteadySpeedIsWhereThrustMeetsDrag) {
  Rig rig(test::steps_of(0.05) + k_water +
          "<vessel hull='box.stl' position='0 0' velocity='0.1 0 0'><mass value='500' cog='0 0 -0.125'/>" +
          propeller("thrust='5'") + "</vessel>");
  for (int k = 0; k < 3000; ++k) rig.simulation.step();
  EXPECT_NEAR(rig.bodies().v_GB[0].x(), 0.2, 1e-6);
  const StepRecord record = rig.balanced_step(1e-12, 1e-11);
  EXPECT_NEAR(record.vessel->hydro->force.x(), -5, 1e-5);
}

TEST(Thrusters, AccountsCloseAndBitsGoOnAfterACheckpoint) {
  const std::string scene = test::steps_of(0.02) + k_water + "<seed value='3'/>" +
                            box(k_station +
                                "<control mode='dp' setpoint='0.5 0.2' heading_deg='20' position_noise='0.01' "
                                "heading_noise_deg='0.2' sensor_period='0.05' sensor_delay='0.1'/>");
  Rig whole(scene), first(scene), rest(scene, 2);
  StepRecord record;
  for (int k = 0; k < 400; ++k) record = whole.balanced_step(1e-11, 1e-10);
  test::expect_energy_kept(record, 1e-9);
  for (int k = 0; k < 150; ++k) first.simulation.step();
  State state;
  first.simulation.save(StateWriter(state));
  rest.simulation.restore(StateReader(state));
  StepRecord last;
  for (int k = 0; k < 250; ++k) last = rest.simulation.step();
  EXPECT_EQ(last.state_hash, record.state_hash);
}

TEST(Thrusters, PositioningReachesItsSetPoint) {
  Rig rig(test::steps_of(0.02) + k_water + box(k_station + "<control mode='dp' setpoint='0.5 0.2' heading_deg='20'/>"));
  for (int k = 0; k < 5000; ++k) rig.simulation.step();
  const bodies::Bodies& b = rig.bodies();
  EXPECT_NEAR(b.p_GB[0].x(), 0.5, 0.01);
  EXPECT_NEAR(b.p_GB[0].y(), 0.2, 0.01);
  EXPECT_NEAR(std::atan2(b.R_GB[0](1, 0), b.R_GB[0](0, 0)) / k_deg, 20, 0.5);
}

TEST(Thrusters, ATableThatIsNotMonotonicIsRefused) {
  test::expect_refusal(
      [] {
        Rig rig(test::steps_of(0.02) + k_water + box(propeller("loss_table='loss.csv'")), 1,
                {{"loss.csv", "speed_m_s,thrust_share\n0,1\n0,0.5\n"}});
      },
      {"loss.csv:3", "speed_m_s must rise"});
}

TEST(Thrusters, ADriftingVesselEndsTheRun) {
  Rig rig(test::steps_of(0.02) +
          "<water density='1000'><current velocity='0 -1 0'/></water>"
          "<hydro><buoyancy/><drag form='1' skin='0'/></hydro>" +
          box(k_station + "<control mode='dp' most_offset='0.5'/>"));
  test::expect_refusal<SimulationError>(
      [&] {
        for (int k = 0; k < 5000; ++k) rig.simulation.step();
      },
      {"at ", "has lost the vessel", "most_offset of 0.5 m"});
}

}  // namespace thrusters_test
