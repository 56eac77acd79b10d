/// The database of a scene: its place in the vessel, its doubts and what is refused.
#include "core/sim/build/load_database.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/build/build_world.h"
#include "hydro/database/bemio.h"
#include "hydro/database/read_database.h"
#include "hydro/radiation/retardation.h"
#include "tests/support/mentions.h"
#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace nilas::sim {
namespace load_database_test {

const std::string k_data = std::string(NILAS_SOURCE_DIR) + "/tests/data/hydro/";

class LoadDatabase : public ::testing::Test {
 protected:
  WorldParts build(const std::string& hydro, const std::string& place = "3 1 -0.4") {
    const scene::Scene scene = scene::read_scene(folder_.write(
        "scene.xml",
        "<scene version='1'><water density='1000' level='0.5'/><hydro><buoyancy/>" + hydro +
            "</hydro><vessel position='" + place +
            "'><hull generate='icebreaker' length='12' beam='4' depth='2' draught='1'/><mass value='30000' cog='6 0 "
            "1'/></vessel></scene>"));
    return build_world(scene, 1, warnings_);
  }
  static bool is_doubted(const WorldParts& parts, const std::string& words) {
    return std::any_of(parts.info.warnings.begin(), parts.info.warnings.end(),
                       [&](const Fault& fault) { return test::mentions(fault.message, words); });
  }

  test::ScratchFolder folder_;
  WarningCounts warnings_{make_logger("off", "")};
};

const std::string k_sphere = "<database file='" + k_data + "hydrochrono/sphere.h5' depth='1000' ";

/// Frame D lies in the still water above or below the origin of V: 0.9 m above it here.
TEST_F(LoadDatabase, LiesInTheStillWater) {
  const WorldParts parts = build(k_sphere + "/>");
  ASSERT_TRUE(parts.database);
  EXPECT_LT((parts.database->in_V.p - Vec3(0, 0, 0.9)).norm(), 1e-12);
  EXPECT_EQ(parts.database->values->frequency.size(), 240u);
  const WorldParts placed = build(k_sphere + "origin='6 0 1' rotation_deg='180'/>");
  EXPECT_EQ(placed.database->in_V.p, Vec3(6, 0, 1));
  EXPECT_LT((placed.database->in_V.q * Vec3::UnitX() + Vec3::UnitX()).norm(), 1e-12);
}

/// A force in heave at the origin of D has a moment about a point 2 m aft of it, and half a turn reverses couplings of
/// surge and heave.
TEST_F(LoadDatabase, MovesMatricesToAPointOfTheVessel) {
  VesselDatabase database;
  database.in_V.p = Vec3(6, 0, 1);
  database.in_V.q = Quat(Eigen::AngleAxisd(k_pi, Vec3::UnitZ()));
  Mat6 matrix = Mat6::Zero();
  matrix(2, 2) = 3;
  matrix(0, 2) = matrix(2, 0) = 0.5;
  const Mat6 moved = database.about(matrix, Vec3(4, 0, 1));
  EXPECT_NEAR(moved(2, 2), 3, 1e-14);
  EXPECT_NEAR(moved(0, 2), -0.5, 1e-14);
  EXPECT_NEAR(moved(2, 4), -3 * 2, 1e-13);  // positive pitch lowers the bow
  EXPECT_NEAR(moved(4, 4), 3 * 4, 1e-13);
}

TEST_F(LoadDatabase, DoubtsAnotherVolumeAndGivesTheAddedMass) {
  const WorldParts parts = build(k_sphere + "/><added_mass vessel='database'/>");
  EXPECT_TRUE(is_doubted(parts, "displaces 261.72 m^3, but the hull displaces"));
  EXPECT_TRUE(is_doubted(parts, "values of damping are negative"));
  EXPECT_FALSE(is_doubted(parts, "computed for a density"));
  ASSERT_TRUE(parts.hull_water);
  EXPECT_NEAR(parts.hull_water->added_B(2, 2), 130876.8, 0.1);
}

TEST_F(LoadDatabase, DoubtsAnotherDensity) {
  const std::string fpso = "<database file='" + k_data + "mss/fpso.1' density='1025' gravity='9.81' ";
  EXPECT_TRUE(is_doubted(build(fpso + "length='1'/>"), "computed for a density of 1025 kg/m^3"));
  test::expect_refusal([&] { build(fpso + "length='2'/>"); }, {"scene.xml", "<hydro><database", "ULEN"});
}

/// The database of Capytaine has no infinite frequency, and added mass needs it.
TEST_F(LoadDatabase, NamesTheMissingInfiniteFrequency) {
  test::expect_refusal(
      [&] {
        build("<database file='" + k_data +
              "wec-sim/sphere_capytaine.nc' reference='0 0 -2'/><added_mass vessel='database'/>");
      },
      {"sphere_capytaine.nc", "infinite frequency", "omega = inf", "--complete --out"});
}

/// A file that lacks it serves a run once it was completed and written: within 0.1 % of what the file had.
TEST_F(LoadDatabase, TakesACompletedDatabase) {
  hydro::DatabaseSettings settings;
  settings.depth = 1000;
  hydro::Database lacking = hydro::read_database(k_data + "hydrochrono/sphere.h5", settings);
  lacking.added_mass_infinite.reset();
  const auto file = folder_.path() / "completed.h5";
  hydro::write_bemio(hydro::with_infinite_added_mass(lacking), file);
  const WorldParts parts = build("<database file='" + file.string() + "'/><added_mass vessel='database'/>");
  ASSERT_TRUE(parts.hull_water);
  EXPECT_NEAR(parts.hull_water->added_B(2, 2), 130876.8, 1e-3 * 130876.8);
}

/// All files of the stem are inputs of the run, with the stem of the file that is named.
TEST_F(LoadDatabase, ListsAllFilesOfTheStemAsInputs) {
  const scene::Scene scene = scene::read_scene(folder_.write(
      "scene.xml", "<scene version='1'><hydro><database file='" + k_data +
                       "mss/fpso.3' length='1' density='1025' gravity='9.81'/></hydro><vessel><hull/><mass "
                       "value='1500'/><fixed/></vessel></scene>"));
  std::vector<std::string> copies;
  for (const scene::InputFile& input : scene.inputs) copies.push_back(input.copy);
  EXPECT_EQ(copies, (std::vector<std::string>{"inputs/fpso.1", "inputs/fpso.3", "inputs/fpso.4", "inputs/fpso.hst"}));
}

}  // namespace load_database_test
}  // namespace nilas::sim
