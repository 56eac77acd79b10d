/// Scenes with many modules at another scale. With 16 all factors are powers of two, so that every number has the same
/// bits once it is scaled back.
#include <gtest/gtest.h>

#include <string>

#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/core/sim/together/all_modules.h"

namespace scale_test {

using namespace nilas;
using namespace nilas::sim;

const std::string k_begin = "<scene version='1'><time step='0.1' end='1000'/><seed value='5'/>";

std::string contact() {
  return test::contact("solver='nsgs' tolerance='0' max_iterations='60' stabilisation='split-impulse'");
}

/// Steps a scene of the ship and the same at 16 times its scale, and demands the same bits.
void expect_same_bits(const std::string& scene, int steps) {
  const test::ScratchFolder folder;
  for (const auto& [name, content] : test::ship_files()) folder.write(name, content);
  folder.write("path.csv", "t_s,x_m,y_m,heading_deg\n0,0,0,0\n2,1,0.5,3\n");
  const auto file = folder.write("scene.xml", scene + "</scene>");
  WarningCounts warnings{make_logger("off", "")};
  constexpr double k_length = 16, k_time = 4, k_mass = k_length * k_length * k_length, k_moment = k_mass * k_length;
  Simulation model(scene::read_scene(file), 1, warnings),
      large(scene::read_scene(file, scene::Overrides{}, k_length), 1, warnings);
  int contacts = 0;
  for (int k = 0; k < steps && !testing::Test::HasFailure(); ++k) {
    SCOPED_TRACE("step " + std::to_string(k + 1));
    const StepRecord a = model.step(), b = large.step();
    contacts += a.contacts;
    const bodies::Bodies &of_model = model.bodies(), &of_large = large.bodies();
    ASSERT_EQ(of_model.size(), of_large.size());
    for (int body = 0; body < of_model.size(); ++body) {
      EXPECT_EQ(Vec3(k_length * of_model.p_GB[body]), of_large.p_GB[body]) << of_model.name[body];
      EXPECT_EQ(of_model.q_GB[body].coeffs(), of_large.q_GB[body].coeffs()) << of_model.name[body];
      EXPECT_EQ(Vec3(k_time * of_model.v_GB[body]), of_large.v_GB[body]) << of_model.name[body];
      EXPECT_EQ(Vec3(of_model.w_GB[body] / k_time), of_large.w_GB[body]) << of_model.name[body];
    }
    const auto expect = [&](const std::string& what, const Wrench& in_a, const Wrench& in_b) {
      EXPECT_EQ(Vec3(k_mass * in_a.force), in_b.force) << what;
      EXPECT_EQ(Vec3(k_moment * in_a.torque), in_b.torque) << what;
    };
    expect("water", *a.vessel->hydro, *b.vessel->hydro);
    for (std::size_t m = 0; m < a.vessel->module_loads.size(); ++m)
      expect(model.info().vessel_loads[m], a.vessel->module_loads[m], b.vessel->module_loads[m]);
    for (std::size_t m = 0; m < a.ledger.works.size(); ++m)
      EXPECT_EQ(k_moment * a.ledger.works[m], b.ledger.works[m]) << model.info().work_names[m];
  }
  EXPECT_GT(contacts, steps / 2);
}

const std::string k_waves =
    "<water density='1025'><current velocity='-0.4 0.2 0'/><waves kind='jonswap' height='2.5' period='9' "
    "heading_deg='165' components='10' shortest_period='6' spreading='12' ramp='3' attenuation='meylan' "
    "ice_edge='105 0'/></water>";

TEST(Scale, LeavesTheBitsOfAMooredShipThatHoldsItsStation) {
  expect_same_bits(k_begin + contact() + k_waves +
                       "<hydro><buoyancy/><drag/><added_mass vessel='database'/><radiation model='convolution'/>"
                       "<wave_loads vessel='database' drift='newman'/>" +
                       test::k_jets + test::k_database + "</hydro>" + test::wind() +
                       test::ship(test::ship_thrusters("path='path.csv' " + test::k_noisy_sensors) +
                                  test::ship_mooring(test::TurnedScene(), "start='as-placed'")) +
                       test::k_breaking_ice,
                   40);
}

TEST(Scale, LeavesTheBitsOfAShipThatSails) {
  expect_same_bits(k_begin + contact() + k_waves +
                       "<hydro><buoyancy/><drag/><restoring/><added_mass/><wave_loads vessel='database'/>"
                       "<propeller_wash><jet thruster='propeller' diameter='6' position='2 0 3'/></propeller_wash>" +
                       test::k_database + "</hydro>" + test::wind() +
                       test::ship("<manoeuvring preset='kvlcc2' length='200' midship='100'/>"
                                  "<manoeuvre kind='course' heading_deg='10' speed='3'/>",
                                  test::TurnedScene(), "velocity='3 0 0'") +
                       test::k_breaking_ice,
                   40);
}

}  // namespace scale_test
