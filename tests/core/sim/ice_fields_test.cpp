/// Ice fields of every kind as bodies of a simulation.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/geometry/mass_properties.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/build/build_world.h"
#include "core/sim/simulation.h"
#include "tests/support/scratch_folder.h"

namespace ice_fields_test {

using namespace nilas;
using namespace nilas::sim;

std::string scene_of(const std::string& content) {
  return R"(<scene version="1" name="ice"><time step="0.01" end="60"/><seed value="3"/>
  <contact law="coulomb" solver="auto" tolerance="1e-9" detection="discrete"><friction between="* *" static="0.3"
    kinetic="0.3"/></contact>
  <water density="1005"/><hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>)" +
         content + "</scene>";
}

WorldParts world_of(const std::string& content) {
  const test::ScratchFolder folder;
  folder.write("floes.json", "[[0,0,3,0,3,1,1,1,1,2,0,2]]");
  WarningCounts warnings(make_logger("off", ""));
  return build_world(scene::read_scene(folder.write("scene.xml", scene_of(content))), 1, warnings);
}

/// Packed to 95 % without overlap, floes float in their places: nothing touches and nothing moves.
TEST(IceFields, ADenseFieldAtRestStaysAtRest) {
  const test::ScratchFolder folder;
  const auto file = folder.write(
      "scene.xml", scene_of(R"(<tank length="6" width="4" depth="2"/><ice thickness="0.04"><field region="0 -2 6 2"
        concentration="0.95" overlap_tolerance="0"><size mean="0.5" sd="0.15" min="0.25" max="0.9"/></field></ice>)"));
  WarningCounts warnings(make_logger("off", ""));
  Simulation simulation(scene::read_scene(file), 1, warnings);
  const std::vector<Vec3> start = simulation.bodies().p_GB;
  ASSERT_GT(simulation.info().floes, 60);
  EXPECT_NEAR(simulation.info().concentration, 0.95, 0.02);
  for (int k = 0; k < 6000; ++k) ASSERT_EQ(simulation.step().penetration_max, 0);  // 60 s
  double drift = 0;
  for (std::size_t b = 0; b < start.size(); ++b)
    drift = std::max(drift, (simulation.bodies().p_GB[b] - start[b]).norm());
  EXPECT_LT(drift, 1e-9);
}

TEST(IceFields, AVoronoiFieldHasTheAskedConcentration) {
  const WorldParts parts = world_of(R"(<ice><field kind="voronoi" region="0 0 8 6" concentration="0.9"/></ice>)");
  EXPECT_NEAR(parts.info.concentration, 0.9, 1e-9);
  EXPECT_NEAR(parts.info.ice_mass, 0.9 * 48 * 0.04 * 920, 1e-6);
}

TEST(IceFields, ALevelSheetLeavesTheHullAndItsTrackFree) {
  const WorldParts parts = world_of(R"(<vessel position="8 0 -0.3" heading_deg="180"><hull generate="wedge" length="4"
      beam="1" draught="0.3" depth="0.5" bow_length="1"/><mass value="800"/></vessel>
    <ice thickness="0.1"><field kind="level" region="0 -4 12 4" fixed="true"/></ice>)");
  ASSERT_EQ(parts.info.floes, 1);
  const int sheet = parts.bodies.size() - 1;
  EXPECT_FALSE(parts.bodies.is_free(sheet));
  // hull and margin: 1.1 m broad, open from the bow at x = 4 to the edge behind the stern, at x = 12
  const double area = geometry::polygon_moments(parts.bodies.shape[sheet]->outline).area;
  EXPECT_NEAR(area, 96 - (0.05 + 8 - 0.5) * 1.1, 0.1);
}

TEST(IceFields, AChannelHasFreeFloesBetweenFixedSheets) {
  const WorldParts parts = world_of(R"(<ice thickness="0.1"><field kind="channel" region="0 -4 12 4" channel_width="3"
      velocity="0.1 0 0"><size mean="0.5" sd="0.1"/></field></ice>)");
  int fixed = 0;
  for (int b = 0; b < parts.bodies.size(); ++b) {
    const auto i = static_cast<std::size_t>(b);
    if (parts.bodies.is_free(b)) {
      EXPECT_LT(std::abs(parts.bodies.p_GB[i].y()), 1.5);
    } else {
      ++fixed;
      EXPECT_NEAR(std::abs(parts.bodies.p_GB[i].y()), 2.75, 1e-12);
    }
  }
  EXPECT_EQ(fixed, 2);
  EXPECT_NEAR(parts.info.concentration, 0.8, 0.02);
}

TEST(IceFields, OutlinesOfALibraryAreDrawn) {
  const WorldParts parts =
      world_of(R"(<ice><field region="0 0 16 10" concentration="0.4"><size distribution="as-library"/>
      <shape library="floes.json"/></field></ice>)");
  EXPECT_EQ(parts.info.floes, 16);
  for (int b = 0; b < parts.bodies.size(); ++b) EXPECT_EQ(parts.bodies.shape[b]->outline.size(), 6u);
}

/// No length is forbidden: edges of a nanometre, and a floe that is no larger.
TEST(IceFields, NanometresAreTaken) {
  const WorldParts parts = world_of(R"(<ice><floe outline="0 0 1 0 1 1e-9 0 1"/>
      <floe thickness="1e-9" outline="2 0 2.000000001 0 2.000000001 1e-9 2 1e-9"/></ice>)");
  EXPECT_EQ(parts.info.floes, 2);
  EXPECT_GT(parts.bodies.mass[1], 0);
}

}  // namespace ice_fields_test
