/// Where floating bodies come to rest: the equilibrium that is solved for against the motion that is simulated.
#include <gtest/gtest.h>

#include <cmath>

#include "core/scene/read/read_scene.h"
#include "core/sim/build/build_world.h"
#include "core/sim/simulation.h"
#include "hydro/equilibrium.h"
#include "tests/support/scratch_folder.h"

namespace floating_test {

using namespace nilas;
using namespace nilas::sim;

/// A loaded hull let go level, in heave balance, under heavy drag, rolls and pitches about the solved pose and settles
/// there: the means over its last ten seconds.
TEST(Floating, ADraggedHullSettlesInTheSolvedEquilibrium) {
  const test::ScratchFolder folder;
  const auto file = folder.write("scene.xml", R"(<scene version="1" name="settling">
  <time step="0.005" end="60"/><water density="1000"/>
  <hydro><buoyancy/><drag form="60" skin="1"/></hydro>
  <vessel position="0 0" heading_deg="30"><hull generate="icebreaker" length="3" beam="0.6" depth="0.5"/>
    <mass value="250" cog="1.57 0.008 0.2"/></vessel></scene>
)");
  const scene::Scene scene = scene::read_scene(file);
  WarningCounts warnings(make_logger("off", ""));
  const WorldParts parts = build_world(scene, 1, warnings);
  const auto b = static_cast<std::size_t>(parts.vessel_index);
  const hydro::FloatingEquilibrium solved =
      hydro::floating_equilibrium(*parts.bodies.shape[b], parts.bodies.mass[b], parts.bodies.q_GB[b], *parts.water);
  ASSERT_TRUE(solved.stable());
  ASSERT_GT(std::abs(solved.trim), 0.01);
  ASSERT_GT(std::abs(solved.heel), 0.01);

  Simulation simulation(scene, 1, warnings);
  double height = 0, trim = 0, heel = 0;
  int count = 0;
  for (int k = 0; k < 12000; ++k) {
    simulation.step();
    if (k < 10000) continue;
    const Mat3& R = simulation.bodies().R_GB[b];
    height += simulation.bodies().p_GB[b].z();
    trim -= std::asin(R(2, 0));
    heel += std::atan2(R(2, 1), R(2, 2));
    ++count;
  }
  EXPECT_NEAR(height / count, solved.pose.p.z(), 1e-5);
  EXPECT_NEAR(trim / count, solved.trim, 1e-3 * std::abs(solved.trim));
  EXPECT_NEAR(heel / count, solved.heel, 1e-3 * std::abs(solved.heel));
}

}  // namespace floating_test
