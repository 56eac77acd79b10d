/// Doubts about the water around a vessel, its database and its mooring.
#include "core/sim/build/water_doubts.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/mesh.h"
#include "core/geometry/shape.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/build/build_world.h"
#include "core/sim/build/natural_periods.h"
#include "tests/support/scratch_folder.h"

namespace nilas::sim {
namespace water_doubts_test {

const std::string k_sphere =
    std::string("<database file='") + NILAS_SOURCE_DIR + "/tests/data/hydro/hydrochrono/sphere.h5' depth='1000'/>";

/// A hull of 2 m x 1 m x 0.5 m with 500 kg, half afloat in fresh water.
class WaterDoubts : public ::testing::Test {
 protected:
  std::vector<WaterDoubt> doubts(const std::string& before, const std::string& vessel, const std::string& mass = "") {
    geometry::write_stl(geometry::box_shape(Vec3(2, 1, 0.5)).surface, folder_ / "box.stl");
    scene_ = scene::read_scene(
        folder_.write("scene.xml", "<scene version='1'>" + before +
                                       "<vessel name='hull' hull='box.stl' position='0 0'><mass value='500'" + mass +
                                       "/>" + vessel + "</vessel></scene>"));
    parts_ = std::make_unique<WorldParts>(build_world(scene_, 1, warnings_, modules_));
    return water_doubts(scene_, *parts_);
  }

  test::ScratchFolder folder_;
  WarningCounts warnings_{make_logger("off", "")};
  ModuleList modules_;  ///< none, so that no library of MoorDyn is needed
  scene::Scene scene_;
  std::unique_ptr<WorldParts> parts_;
};

const std::string k_afloat = "<water density='1000'/><hydro><buoyancy/>";

TEST_F(WaterDoubts, AddedMassOfAFixedVessel) {
  const std::string added = "<added_mass vessel='matrix' matrix='1 1 1 1 1 1'/></hydro>";
  const auto fixed = doubts(k_afloat + added, "<fixed/>");
  ASSERT_EQ(fixed.size(), 1u);
  EXPECT_EQ(fixed[0].path, "hydro/added_mass/@vessel");
  EXPECT_NE(fixed[0].message.find("no effect"), std::string::npos);
  EXPECT_TRUE(doubts(k_afloat + added, "").empty());
  EXPECT_TRUE(doubts(k_afloat + "<added_mass/></hydro>", "<fixed/>").empty()) << "that of floes has an effect";
}

/// A box with its centre of mass a ahead of the middle trims by tan(trim) (GM + BM/2 tan^2) = a, with BM = L^2/(12 T)
/// and GM = BM - T/2 for a centre of mass at the level of the middle, in the still water.
TEST_F(WaterDoubts, LinearHydrostaticsOfAHullWithTrim) {
  const std::string water = k_afloat + "<restoring/>" + k_sphere + "</hydro>";
  EXPECT_TRUE(doubts(water, "").empty());
  constexpr double k_draught = 0.25, k_metacentre = 2 * 2 / (12 * k_draught), k_tangent = 0.1;
  const double ahead = k_tangent * (k_metacentre - k_draught / 2 + 0.5 * k_metacentre * k_tangent * k_tangent);
  const auto trimmed = doubts(water, "", " cog='" + std::to_string(ahead) + " 0 0'");
  ASSERT_EQ(trimmed.size(), 1u);
  EXPECT_EQ(trimmed[0].path, "hydro/restoring");
  EXPECT_NE(trimmed[0].message.find("a trim of 5.71 deg"), std::string::npos) << trimmed[0].message;
}

/// Two lines along the hull, each with c = 1000 N s/m, slow 500 kg at the rate of 2 c/m = 4 1/s.
TEST_F(WaterDoubts, DampingThatTheStepDoesNotBear) {
  const auto moored = [](double step) {
    return std::pair("<time step='" + std::to_string(step) + "' end='1'/>" + k_afloat + "</hydro>",
                     std::string("<mooring start='as-placed'><spring_line name='a' fairlead='1 0 0' anchor='30 0 0' "
                                 "length='28' stiffness='300' damping='1000'/><spring_line name='b' fairlead='-1 0 0' "
                                 "anchor='-30 0 0' length='29.5' stiffness='300' damping='1000'/></mooring>"));
  };
  const auto [water, lines] = moored(0.2);
  EXPECT_TRUE(doubts(water, lines).empty());
  EXPECT_NEAR(mooring_damping_rate(*parts_), 4, 1e-9);
  const auto overshoots = doubts(moored(0.3).first, lines), grows = doubts(moored(0.6).first, lines);
  ASSERT_EQ(overshoots.size(), 1u);
  EXPECT_EQ(overshoots[0].path, "vessel/mooring");
  EXPECT_NE(overshoots[0].message.find("is 1.2; above 1 explicit damping overshoots; take a step of at most 0.25 s, or "
                                       "0.833 times the damping"),
            std::string::npos)
      << overshoots[0].message;
  ASSERT_EQ(grows.size(), 1u);
  EXPECT_NE(grows[0].message.find("makes velocities grow"), std::string::npos);
}

TEST_F(WaterDoubts, AFileOfMoordynForOtherWater) {
  const std::string lines = "<mooring model='moordyn' file='lines.txt'/>";
  const auto write = [&](const std::string& options) {
    folder_.write("lines.txt", "--- MoorDyn ---\n--- LINE TYPES ---\n1000 rho nonsense\n--- OPTIONS ---\n" + options +
                                   "--- OUTPUTS ---\n");
  };
  const std::string water =
      "<water density='1000'><waves height='0' period='5' depth='60'/></water><hydro><buoyancy/></hydro>";
  write("61 WtrDpth\n1000.0  rho  water\n9.81 g\n0.001 dtM\n");
  EXPECT_TRUE(doubts(water, lines).empty());
  write("seabed.txt WtrDpth\n");
  EXPECT_TRUE(doubts(water, lines).empty());
  write("80 WtrDpth   depth of the water\n1025 WtrDnsty\n1.62 gravity\n");
  const auto found = doubts(water, lines);
  ASSERT_EQ(found.size(), 3u);
  for (const WaterDoubt& doubt : found) EXPECT_EQ(doubt.path, "vessel/mooring/@file");
  EXPECT_NE(found[0].message.find("states the depth 80 m, but that of the scene is 60 m"), std::string::npos);
  EXPECT_NE(found[1].message.find("density of the water 1025 kg/m^3, but that of the scene is 1000 kg/m^3"),
            std::string::npos);
  EXPECT_NE(found[2].message.find("gravity 1.62 m/s^2"), std::string::npos);
}

}  // namespace water_doubts_test
}  // namespace nilas::sim
