/// Tests of hulls that are hardly intended: `nilas hull`, `check` and `run` report them, and the flags that they name
/// correct them.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/hull/hull_axes.h"
#include "tests/core/hull/hull_family.h"
#include "tests/support/program.h"
#include "tests/support/write_obj.h"

namespace hull_doubts_test {

using namespace nilas_test;
using nilas::hull::MeshAxes;

nlohmann::json report(const ProgramResult& made) {
  EXPECT_EQ(made.exit_code, 0) << made.err;
  return nlohmann::json::parse(made.out, nullptr, false);
}

/// A coaster with its bow along -y and its deck along x, in feet.
TriangleMesh drawn_otherwise() {
  const nilas::Mat3 R = MeshAxes{{1, -1}, {0, 1}}.to_vessel() * 0.3048;
  TriangleMesh mesh = coaster();
  for (auto& p : mesh.vertices) p = R.inverse() * p;
  return mesh;
}

std::string scene_with(const std::string& hull, const std::string& vessel) {
  return R"(<scene version="1" name="own hull">
  <time step="0.05" end="0.1"/>
  <water density="1025"/>
  <hydro><buoyancy/></hydro>
  <vessel hull=")" +
         hull + "\" " + vessel + R"(<carriage speed="1"/></vessel>
</scene>
)";
}

TEST(HullDoubts, TheFlagsThatAWarningNamesMendIt) {
  const ScratchFolder folder;
  write_obj(folder / "ship.obj", {drawn_otherwise()});
  const auto wrong = run_nilas("hull ship.obj --scale 0.3048 --json --out wrong", folder.path());
  const auto doubted = report(wrong);
  ASSERT_EQ(doubted["warnings"].size(), 1u) << wrong.out;
  const std::string warning = doubted["warnings"][0], command = "nilas hull ship.obj";
  EXPECT_EQ(doubted["bow"], "-y");
  EXPECT_NE(wrong.err.find("warning: The hull is"), std::string::npos) << wrong.err;
  ASSERT_NE(warning.find(command), std::string::npos) << warning;
  const auto mended =
      report(run_nilas(warning.substr(warning.find(command) + 6) + " --draught 6 --json --out right", folder.path()));
  EXPECT_TRUE(mended["warnings"].empty()) << mended["warnings"];
  EXPECT_NEAR(mended["length_m"], 100, 1e-3);
  EXPECT_NEAR(mended["beam_m"], 20, 1e-3);
  EXPECT_NEAR(mended["depth_m"], 9, 1e-3);
  EXPECT_EQ(mended["bow"], "x");
  EXPECT_NEAR(mended["high_m"][0].get<double>() - mended["centre_m"][0].get<double>(), 54, 2) << "sharp end ahead";
  // The value is below 6 m, since the rake of the stem is not part of the waterline's length.
  const double length = 92 + 8 * 6.0 / 9;
  EXPECT_NEAR(mended["block_coefficient"], mended["displaced_m3"].get<double>() / (length * 20 * 6), 1e-6);
  const auto description = nlohmann::json::parse(std::ifstream(folder / "right/hull.json"));
  EXPECT_EQ(description["forward"], "-y");
  EXPECT_EQ(description["up"], "x");
}

TEST(HullDoubts, ASceneIsWarnedWithThePlaceOfItsHull) {
  const ScratchFolder folder;
  write_obj(folder / "ship.obj", {coaster()});
  ASSERT_EQ(run_nilas("hull ship.obj --forward -y --out across", folder.path()).exit_code, 0);
  folder.write("across.xml", scene_with("across", "position=\"0 0\"><mass draught=\"6\"/>"));
  const auto checked = run_nilas("check across.xml", folder.path());
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  for (const char* word : {"across.xml:5:", "lies across, with y forward", "nilas hull across/fluid.stl --forward y",
                           "transverse GM is far above the longitudinal one"})
    EXPECT_NE(checked.out.find(word), std::string::npos) << word << " in " << checked.out;
  const auto listed = report(run_nilas("check across.xml --json", folder.path()));
  ASSERT_EQ(listed["warnings"].size(), 1u);
  ASSERT_EQ(run_nilas("run across.xml --quiet --out run", folder.path()).exit_code, 0);
  const auto summary = nlohmann::json::parse(std::ifstream(folder / "run/summary.json"));
  ASSERT_EQ(summary["warnings"].size(), 1u);
  const std::string told = summary["warnings"][0], placed = listed["warnings"][0];
  EXPECT_EQ("across.xml:5:11: " + told, placed) << "without file and line, which the folder's own scene has not";
}

TEST(HullDoubts, AMassInKilogramsTellsFeet) {
  const ScratchFolder folder;
  write_obj(folder / "ship.obj", {coaster()});
  ASSERT_EQ(run_nilas("hull ship.obj --scale 3.280839895 --out feet", folder.path()).exit_code, 0);
  ASSERT_EQ(run_nilas("hull ship.obj --out metres", folder.path()).exit_code, 0);
  const std::string mass = "><mass value=\"9.8e6\"/>";
  const auto warnings = [&](const std::string& hull, const std::string& position) {
    folder.write("scene.xml", scene_with(hull, "position=\"" + position + "\"" + mass));
    return report(run_nilas("check scene.xml --json", folder.path()))["warnings"].dump();
  };
  EXPECT_NE(warnings("feet", "0 0").find("large for its mass"), std::string::npos);
  EXPECT_NE(warnings("feet", "0 0 -19.685").find("The mesh is probably in feet"), std::string::npos);
  EXPECT_EQ(warnings("metres", "0 0"), "[]");
  EXPECT_EQ(warnings("metres", "0 0 -6"), "[]");
}

TEST(HullDoubts, TheReportBeginsWithWords) {
  const ScratchFolder folder;
  const auto made = run_nilas("hull --generate icebreaker --triangles 600 --out ship", folder.path());
  EXPECT_EQ(made.out.rfind("The hull is 6 m long, 1.27 m wide and 0.6 m deep.", 0), 0u) << made.out;
  EXPECT_NE(made.out.find("bow is at x = 6 m."), std::string::npos) << made.out;
  EXPECT_EQ(made.err, "");
}

TEST(HullDoubts, AxesThatAreNotAcrossEachOtherAreRefused) {
  const ScratchFolder folder;
  write_obj(folder / "ship.obj", {coaster()});
  for (const char* flags : {"--up x", "--forward z", "--forward -y --up y"}) {
    const auto refused = run_nilas(std::string("hull ship.obj --out made ") + flags, folder.path());
    EXPECT_EQ(refused.exit_code, 2) << flags;
    EXPECT_NE(refused.err.find("allowed: axes at right angles to each other"), std::string::npos) << refused.err;
  }
}

}  // namespace hull_doubts_test
