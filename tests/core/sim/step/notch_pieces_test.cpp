/// Wedges that a ship breaks out of its floes at full scale: they stay out of the notches that they were cut from.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/core/sim/scene_rig.h"

namespace notch_pieces_test {

using namespace nilas;

/// A ship of 36 m at 2.2 m/s in 17 floes of 12 m, 0.5 m thick, that crush, bend and split.
const std::string k_ship_in_floes =
    "<time step='0.02' end='1000'/><seed value='7'/>"
    "<contact tolerance='1e-3'><friction between='ice ice' static='0.3' kinetic='0.3'/>"
    "<friction between='hull ice' static='0.1' kinetic='0.1'/>"
    "<friction between='wall ice' static='0.1' kinetic='0.1'/></contact>"
    "<water density='1025' level='0'/><hydro><buoyancy/><drag form='1' skin='0.005'/></hydro>"
    "<tank length='120' width='40' depth='15' wall_thickness='2' floor='true'/>"
    "<vessel name='ship' position='10 0'>"
    "<hull generate='icebreaker' length='36' beam='9' draught='2.5' depth='4.5' stem_angle_deg='25'/>"
    "<mass draught='2.5'/><carriage speed='2.2' ramp='1' free='heave'><force_balance kind='six-cells'/></carriage>"
    "</vessel>"
    "<ice preset='full-scale sea ice' thickness='0.5'>"
    "<field kind='packed' region='42 -20 118 20' concentration='0.8' breakable='true'>"
    "<size distribution='fixed' mean='12'/><shape kind='polygon' vertices='5 8'/></field></ice>"
    "<fracture><crushing model='explicit'/><bending model='nevel'/><splitting model='geometric'/></fracture>";

/// With their contacts missing, wedges were pushed 4 mm into the sheet in a step, and nothing could part them again.
TEST(NotchPieces, WedgesStayOutOfTheirNotch) {
  test::SceneRig rig(k_ship_in_floes);
  std::size_t broken = 0;
  double deepest = 0;
  for (int k = 0; k < 140; ++k) {
    const sim::StepRecord record = rig.simulation.step();
    broken += record.broken.size();
    deepest = std::max(deepest, record.penetration_max);
    EXPECT_TRUE(record.positions_corrected) << record.t;
    EXPECT_FALSE(record.solver_short) << record.t;
  }
  EXPECT_GE(broken, 1u);
  EXPECT_LE(deepest, 1e-3);
}

}  // namespace notch_pieces_test
