/// A ship that drives itself through broken ice: more and thicker ice slows it down, and more revolutions speed it up.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/sim/scene_rig.h"
#include "tests/support/file_text.h"

namespace speed_in_ice_test {

using namespace nilas;

/// The icebreaker of free-running.xml in a channel of four beams, with floes of 14 m. The autopilot holds its heading,
/// and with speed_gain 0 its propeller turns at the rate that holds `speed` in open water.
struct Passage {
  double concentration = 0.5, thickness = 0.8, speed = 4;  ///< [-], [m], [m/s]
};

std::string scene_of(const Passage& p, int seed) {
  std::string ice;
  if (p.concentration > 0)
    ice = "<ice density='920' youngs_modulus='4e9' poisson='0.3' thickness='" + test::text(p.thickness) +
          "'><field kind='packed' region='112 -40 398 40' concentration='" + test::text(p.concentration) +
          "' breakable='false'><size distribution='lognormal' mean='14' sd='3' min='8' max='24'/>"
          "<shape kind='polygon' vertices='5 8'/></field></ice>";
  return "<time step='0.1' start='0' end='1000'/><seed value='" + std::to_string(seed) +
         "'/><contact law='coulomb' solver='auto' tolerance='1e-3' integrator='moreau'>"
         "<friction between='ice ice' static='0.3' kinetic='0.3'/><friction between='hull ice' static='0.1' "
         "kinetic='0.1'/><friction between='wall ice' static='0.1' kinetic='0.1'/></contact>"
         "<water density='1025'/><hydro><buoyancy/><drag form='1' skin='0.005'/></hydro>"
         "<tank length='400' width='80' depth='40' wall_thickness='4'/>"
         "<vessel name='ship' position='8 0' velocity='" +
         test::text(p.speed) +
         " 0 0'><hull generate='icebreaker' length='100' beam='20' draught='6' depth='10' stem_angle_deg='25'/>"
         "<mass draught='6'/><manoeuvring model='mmg' file='ship.csv' propulsion='thrust-curve' midship='45.7'/>"
         "<manoeuvre kind='course' heading_deg='0' speed='" +
         test::text(p.speed) + "' speed_gain='0'/></vessel>" + ice;
}

/// The mean speed over 200 m of way, of which the bow makes all but the first 4 m in ice, and over two fields [m/s].
double mean_speed(const Passage& p) {
  const test::SceneRig::Files files{{"ship.csv", test::read_text(NILAS_SOURCE_DIR "/apps/scenes/icebreaker-91m.csv")}};
  constexpr double k_way = 200, k_longest = 400;  // [m], [s]
  double sum = 0;
  for (const int seed : {1, 2}) {
    test::SceneRig rig(scene_of(p, seed), 1, files);
    const double start = rig.bodies().p_GB[0].x();
    double t = 0;
    while (rig.bodies().p_GB[0].x() < start + k_way && t < k_longest) t = rig.simulation.step().t;
    sum += (rig.bodies().p_GB[0].x() - start) / t;
  }
  return sum / 2;
}

/// Fields of other seeds differ by less than 0.1 m/s; the trends are demanded with that margin.
constexpr double k_margin = 0.1;

/// On an even keel the thrust at the rate of the curve meets the resistance exactly: a step leaves the speed as it is.
TEST(SpeedInIce, ThrustMeetsResistanceExactlyInOpenWater) {
  const test::SceneRig::Files files{{"ship.csv", test::read_text(NILAS_SOURCE_DIR "/apps/scenes/icebreaker-91m.csv")}};
  for (const double speed : {2.0, 3.0, 4.0, 5.0, 6.0}) {
    test::SceneRig rig(scene_of({.concentration = 0, .speed = speed}, 1), 1, files);
    rig.simulation.step();
    EXPECT_NEAR(rig.bodies().v_GB[0].x(), speed, 1e-13 * speed);
  }
}

/// In open water the ship trims by up to 0.02 rad while its thrust and its resistance settle. That tilts both, by 2e-4
/// of their size, so the mean speed is that of the curve to 2e-4 m/s. Ice of 30, 50 and 70 % takes more and more of it.
TEST(SpeedInIce, FallsWithTheConcentration) {
  double before = mean_speed({.concentration = 0});
  EXPECT_NEAR(before, 4, 2e-4);
  for (const double concentration : {0.3, 0.5, 0.7}) {
    const double now = mean_speed({.concentration = concentration});
    EXPECT_LT(now, before - k_margin) << concentration;
    before = now;
  }
  EXPECT_GT(before, 1) << "the ship still goes ahead";
}

TEST(SpeedInIce, FallsWithTheThickness) {
  double before = 4;
  for (const double thickness : {0.4, 0.8, 1.2}) {
    const double now = mean_speed({.thickness = thickness});
    EXPECT_LT(now, before - k_margin) << thickness;
    before = now;
  }
}

/// At the rates of revolutions that hold 3, 4 and 5 m/s in open water.
TEST(SpeedInIce, RisesWithTheRateOfThePropeller) {
  double before = 0;
  for (const double speed : {3.0, 4.0, 5.0}) {
    const double now = mean_speed({.speed = speed});
    EXPECT_GT(now, before + k_margin) << speed;
    EXPECT_LT(now, speed - k_margin) << "the ice costs speed at any rate";
    before = now;
  }
}

}  // namespace speed_in_ice_test
