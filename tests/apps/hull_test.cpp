/// `nilas hull MESH`: files from drawing programs become hulls that a scene can use, or are refused with the place.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/geometry/mesh.h"
#include "tests/core/mesh/hull_shapes.h"
#include "tests/support/program.h"
#include "tests/support/write_obj.h"

namespace hull_test {

using namespace nilas_test;
using nilas::geometry::TriangleMesh;

/// Prepares the mesh file; a failed run leaves an empty report.
nlohmann::json prepared(const ScratchFolder& folder, const std::string& arguments) {
  const auto made = run_nilas("hull " + arguments + " --json", folder.path());
  EXPECT_EQ(made.exit_code, 0) << made.err;
  return made.exit_code == 0 ? nlohmann::json::parse(made.out, nullptr, false) : nlohmann::json{};
}

/// Floats at half its height among a few floes for a few steps.
void expect_usable(const ScratchFolder& folder, const std::string& hull, double low_z, double height) {
  const std::string scene = R"(<?xml version="1.0"?>
<scene version="1" name="prepared hull">
  <time step="0.01" end="0.05"/>
  <seed value="1"/>
  <water density="1000"/><hydro><buoyancy/></hydro>
  <vessel name="ship" hull=")" +
                            hull + R"(" position="0 0 )" + std::to_string(-low_z - 0.5 * height) +
                            R"("><fixed/></vessel>
  <ice thickness="0.04">
    <field kind="packed" region="-3 -3 8 3" concentration="0.5">
      <size distribution="lognormal" mean="0.5" sd="0.1" min="0.3" max="0.8"/>
    </field>
  </ice>
</scene>
)";
  folder.write("scene.xml", scene);
  const auto checked = run_nilas("check scene.xml", folder.path());
  EXPECT_EQ(checked.exit_code, 0) << hull << ": " << checked.err;
  const auto run = run_nilas("run scene.xml --out run --force --quiet", folder.path());
  EXPECT_EQ(run.exit_code, 0) << hull << ": " << run.err;
}

TEST(HullCommand, FiveShapesArePreparedAndFloatInIce) {
  const ScratchFolder folder;
  const TriangleMesh cone = nilas::mesh::cone_mesh(1, 1.5, 24), pool = nilas::mesh::moonpool_mesh(),
                     ship = nilas::mesh::ship_mesh(30, 6),
                     bulb = nilas::mesh::bulb_mesh({5.9, 0, 0.12}, {0.5, 0.09, 0.1}, 8),
                     wedge = nilas::mesh::wedge_mesh();
  struct Case {
    std::string name;
    std::vector<TriangleMesh> shells;
    double low_volume, high_volume;
  };
  const double semi = nilas::mesh::semisubmersible_volume(16),
               both = nilas::geometry::signed_volume(ship) + nilas::geometry::signed_volume(bulb);
  const std::vector<Case> cases{
      {"wedge", {wedge}, nilas::mesh::k_wedge_volume, nilas::mesh::k_wedge_volume},
      {"cone", {cone}, nilas::geometry::signed_volume(cone), nilas::geometry::signed_volume(cone)},
      {"moonpool", {pool}, nilas::mesh::k_moonpool_volume, nilas::mesh::k_moonpool_volume},
      {"bulb", {ship, bulb}, nilas::geometry::signed_volume(ship), both},
      {"semi", nilas::mesh::semisubmersible_shells(16), semi, semi},
  };
  for (const auto& c : cases) {
    write_obj(folder.path() / (c.name + ".obj"), c.shells);
    const auto report = prepared(folder, c.name + ".obj --out " + c.name + " --tolerance 0.02");
    if (!report.contains("volume_m3")) continue;
    const double volume = report["volume_m3"];
    EXPECT_GE(volume, c.low_volume * (1 - 1e-6)) << c.name;
    EXPECT_LE(volume, c.high_volume * (1 + 1e-6)) << c.name;
    EXPECT_EQ(report["closed"], true) << c.name;
    EXPECT_EQ(report["symmetric"], true) << c.name;
    EXPECT_LE(report["deviation_m"].get<double>(), 0.02) << c.name;
    EXPECT_EQ(report["part_counts"].back()["parts"], report["parts"]) << c.name;
    EXPECT_GT(fs::file_size(folder.path() / c.name / "hull.png"), 10000u) << c.name;
    const double low = report["low_m"][2], high = report["high_m"][2];
    expect_usable(folder, c.name, low, high - low);
  }
}

TEST(HullCommand, AHundredThousandTrianglesSomeOfThemWrong) {
  const ScratchFolder folder;
  TriangleMesh hull = nilas::mesh::bulb_mesh({2, 0, 0.3}, {2, 0.5, 0.3}, 160);
  ASSERT_GT(hull.triangles.size(), 100000u);
  const double volume = nilas::geometry::signed_volume(hull);
  for (std::size_t k = 500; k < hull.triangles.size(); k += 1000) std::swap(hull.triangles[k][0], hull.triangles[k][1]);
  for (std::size_t k = 5; k > 0; --k)  // small holes
    hull.triangles.erase(hull.triangles.begin() + static_cast<std::ptrdiff_t>(20000 * k));
  write_obj(folder.path() / "fine.obj", {hull});
  const auto report = prepared(folder, "fine.obj --out fine");
  ASSERT_TRUE(report.contains("volume_m3"));
  EXPECT_NEAR(report["volume_m3"], volume, 1e-6 * volume);
  EXPECT_EQ(report["closed"], true);
  EXPECT_LE(report["deviation_m"].get<double>(), 0.004);
}

TEST(HullCommand, ABarge) {
  // closed forms of a box of 4 x 1 x 0.5 at half draught, drawn in millimetres with y up
  const ScratchFolder folder;
  std::vector<TriangleMesh> shells{nilas::mesh::box_mesh({-2, 0, -0.5}, {2, 0.5, 0.5})};
  write_obj(folder.path() / "barge.obj", shells, 1e-3);
  const auto report = prepared(folder, "barge.obj --scale 0.001 --up y --draught 0.25");
  EXPECT_NEAR(report["volume_m3"], 2, 1e-9);
  EXPECT_NEAR(report["displaced_m3"], 1, 1e-9);
  EXPECT_NEAR(report["kb_m"], 0.125, 1e-9);
  EXPECT_NEAR(report["bm_m"], 1.0 / 12 / 0.25, 1e-9);
  EXPECT_NEAR(report["kg_m"], 0.25, 1e-9) << "half the depth";
  EXPECT_NEAR(report["gm_m"], 0.125 + 1.0 / 3 - 0.25, 1e-9);
  EXPECT_NEAR(report["wetted_area_m2"], 4 + 2 * (4 + 1) * 0.25, 1e-9);
  EXPECT_NEAR(report["waterplane_area_m2"], 4, 1e-9);
  EXPECT_NEAR(report["inertia_per_density_m5"][0], 2 * (1 + 0.25) / 12, 1e-9);
  EXPECT_NEAR(report["inertia_per_density_m5"][2], 2 * (16.0 + 1) / 12, 1e-9);
  EXPECT_EQ(report["parts"], 1);
  EXPECT_TRUE(report["mended"].empty());
}

TEST(HullCommand, AnOpenHullIsRefusedWithItsPlaceAndAPicture) {
  const ScratchFolder folder;
  TriangleMesh open = nilas::mesh::box_mesh({0, 0, 0}, {4, 1, 1});
  std::erase_if(open.triangles, [&](const auto& t) {
    return std::all_of(t.begin(), t.end(), [&](int v) { return open.vertices[v].z() == 1; });
  });
  write_obj(folder.path() / "open.obj", {open});
  const auto refused = run_nilas("hull open.obj --out made", folder.path());
  EXPECT_EQ(refused.exit_code, 2);
  for (const char* word : {"open.obj", "holes left open", "(2, 0.5, 1)", "--fill-holes", "faults.png"})
    EXPECT_NE(refused.err.find(word), std::string::npos) << word << " in " << refused.err;
  EXPECT_GT(fs::file_size(folder.path() / "made" / "faults.png"), 10000u);
  EXPECT_FALSE(fs::exists(folder.path() / "made" / "hull.json"));
  EXPECT_NEAR(prepared(folder, "open.obj --out made --fill-holes 5")["volume_m3"], 4, 1e-6);
}

TEST(HullCommand, FilesOfTheUserStay) {
  const ScratchFolder folder;
  fs::create_directories(folder.path() / "mine");
  for (const char* name : {"part-bow.stl", "part-01.stl"})
    nilas::geometry::write_stl(nilas::mesh::box_mesh({0, 0, 0}, {4, 1, 1}), folder.path() / "mine" / name);
  const auto names = [&] {
    return fs::exists(folder / "mine/part-bow.stl") && fs::exists(folder / "mine/part-01.stl");
  };
  for (const char* arguments : {"mine/part-bow.stl --out mine", "mine/part-bow.stl --out mine --force",
                                "mine/part-01.stl --out mine --force", "mine --out mine --force"}) {
    const auto refused = run_nilas(std::string("hull ") + arguments, folder.path());
    EXPECT_EQ(refused.exit_code, 2) << arguments << ": " << refused.err;
    EXPECT_TRUE(names()) << arguments;
  }
  fs::remove(folder / "mine/part-bow.stl");
  const auto taken = run_nilas("hull mine/part-01.stl --out mine --force", folder.path());
  EXPECT_EQ(taken.exit_code, 2);
  EXPECT_NE(taken.err.find("would replace it"), std::string::npos) << taken.err;
  prepared(folder, "mine/part-01.stl --out made");
  const auto again = run_nilas("hull mine/part-01.stl --out made", folder.path());
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_NE(again.err.find("--force"), std::string::npos) << again.err;
  prepared(folder, "mine/part-01.stl --out made --force");
}

TEST(HullCommand, PathsThatCannotBeOpenedOrMadeEndWith4) {
  const ScratchFolder folder;
  fs::create_symlink("loop", folder.path() / "loop");
  folder.write("file", "x");
  const std::string name(300, 'x');
  for (const std::string& arguments :
       {name, name + ".stl", std::string("loop"), "--generate wedge --out " + name,
        std::string("--generate wedge --out loop"), std::string("--generate wedge --out file")}) {
    const auto refused = run_nilas("hull " + arguments, folder.path());
    EXPECT_EQ(refused.exit_code, 4) << arguments << ": " << refused.err;
  }
  EXPECT_FALSE(fs::exists(folder / "hull"));
}

/// Runs the program with another PATH.
ProgramResult run_with_path(const std::string& path, const std::string& arguments, const ScratchFolder& folder) {
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", path.c_str(), 1);
  const auto result = run_nilas(arguments, folder.path());
  ::setenv("PATH", before.c_str(), 1);
  return result;
}

/// A PATH with a gnuplot that is this script.
std::string with_gnuplot(const std::string& script, const ScratchFolder& folder) {
  fs::permissions(folder.write("bin/gnuplot", "#!/bin/sh\n" + script), fs::perms::owner_all);
  return (folder / "bin").string() + ":" + std::getenv("PATH");
}

TEST(HullCommand, AFlatMeshIsDrawn) {
  const ScratchFolder folder;
  folder.write("sheet.obj", "v 0 0 0\nv 4 0 0\nv 4 1 0\nv 0 1 0\nf 1 2 3 4\n");
  const auto refused = run_nilas("hull sheet.obj --out made", folder.path());
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("marked in made/faults.png"), std::string::npos) << refused.err;
  EXPECT_GT(fs::file_size(folder / "made/faults.png"), 10000u);
}

TEST(HullCommand, WithoutItsPictureAHullIsWrittenAllTheSame) {
  const ScratchFolder folder;
  write_obj(folder / "box.obj", {nilas::mesh::box_mesh({0, 0, 0}, {4, 1, 1})});
  const auto failed = run_with_path(with_gnuplot("exit 3\n", folder), "hull box.obj --out failed", folder);
  const auto absent = run_with_path("/nowhere", "hull box.obj --out absent", folder);
  EXPECT_NE(failed.err.find("gnuplot failed"), std::string::npos) << failed.err;
  EXPECT_NE(absent.err.find("need gnuplot"), std::string::npos) << absent.err;
  for (const char* made : {"failed", "absent"}) {
    EXPECT_TRUE(fs::exists(folder / made / "hull.json")) << made;
    for (const auto& entry : fs::directory_iterator(folder / made))
      EXPECT_NE(entry.path().filename().string().front(), '.') << entry.path();
  }
}

TEST(HullCommand, SliversAreNotDrawnInPieces) {
  const ScratchFolder folder;
  constexpr int k_sides = 1000;
  std::string corners, lower, upper, sides;
  for (int k = 0; k < k_sides; ++k) {
    const double turn = 2 * nilas::k_pi * k / k_sides;
    const std::string yz = std::to_string(0.1 * std::cos(turn)) + " " + std::to_string(0.1 * std::sin(turn)) + "\n";
    corners += "v 0 " + yz + "v 4 " + yz;
    const int next = (k + 1) % k_sides;
    for (const int v : {2 * k + 1, 2 * next + 1, 2 * next + 2, 2 * k + 2})
      sides += (v == 2 * k + 1 ? "f " : " ") + std::to_string(v);
    sides += "\n";
    upper += " " + std::to_string(2 * k + 2);
    lower = " " + std::to_string(2 * k + 1) + lower;
  }
  folder.write("prism.obj", corners + sides + "f" + upper + "\nf" + lower + "\n");
  const auto made =
      run_with_path(with_gnuplot("echo bytes $(wc -c < .parts.dat) >&2; exit 3\n", folder), "hull prism.obj", folder);
  const auto at = made.err.find("bytes ");
  ASSERT_NE(at, std::string::npos) << made.err;
  EXPECT_LT(std::stol(made.err.substr(at + 6)), 2000000) << "of 4000 triangles";
}

TEST(HullCommand, AMissedToleranceIsSaid) {
  const ScratchFolder folder;
  write_obj(folder.path() / "pool.obj", {nilas::mesh::moonpool_mesh()});
  const auto run = run_nilas("hull pool.obj --parts 2 --json --out two", folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* word : {"warning", "asked: 0.004 m", "--parts"})
    EXPECT_NE(run.err.find(word), std::string::npos) << word << " in " << run.err;
  const auto report = nlohmann::json::parse(run.out, nullptr, false);
  EXPECT_NEAR(report["tolerance_m"], 0.004, 1e-9);
  EXPECT_EQ(report["within_tolerance"], false);
  const auto enough = run_nilas("hull pool.obj --json --out enough", folder.path());
  EXPECT_EQ(enough.err.find("warning"), std::string::npos) << enough.err;
  EXPECT_EQ(nlohmann::json::parse(enough.out, nullptr, false)["within_tolerance"], true);
}

TEST(HullCommand, CoordinatesTooFarOffForTheirSizeAreRefused) {
  const ScratchFolder folder;
  write_obj(folder.path() / "far.obj", {nilas::mesh::box_mesh({9e4, 0, 0}, {9e4 + 4, 1, 1})});
  write_obj(folder.path() / "near.obj", {nilas::mesh::box_mesh({500, 0, 0}, {504, 1, 1})});
  const auto refused = run_nilas("hull far.obj --out made", folder.path());
  EXPECT_EQ(refused.exit_code, 2);
  for (const char* word : {"far.obj", "from the origin", "Move the mesh within"})
    EXPECT_NE(refused.err.find(word), std::string::npos) << word << " in " << refused.err;
  EXPECT_NEAR(prepared(folder, "near.obj --out made")["volume_m3"], 4, 1e-3);
}

TEST(HullCommand, FlagsThatWouldDoNothingAreRefused) {
  const ScratchFolder folder;
  write_obj(folder.path() / "box.obj", {nilas::mesh::box_mesh({0, 0, 0}, {4, 1, 1})});
  ASSERT_EQ(prepared(folder, "box.obj --out hb")["deviation_m"], 0);
  for (const std::string beside : {"hb", "--generate wedge"})
    for (const std::string flag :
         {"--scale 0.001", "--forward y", "--up y", "--gap 1e-3", "--fill-holes 1", "--tolerance 0.1", "--parts 3"}) {
      const auto refused = run_nilas("hull " + beside + " " + flag + " --out made", folder.path());
      EXPECT_EQ(refused.exit_code, 2) << beside << ' ' << flag;
      for (const std::string& word : {"found " + flag.substr(0, flag.find(' ')) + " with ", std::string("allowed: ")})
        EXPECT_NE(refused.err.find(word), std::string::npos) << beside << ' ' << flag << ": " << refused.err;
      EXPECT_FALSE(fs::exists(folder / "made"));
    }
  const auto form = run_nilas("hull box.obj --stem-angle 30 --out made", folder.path());
  EXPECT_EQ(form.exit_code, 2);
  EXPECT_NE(form.err.find("found --stem-angle-deg with MESH"), std::string::npos) << form.err;
}

TEST(HullCommand, AHullFolderIsReportedAtAnotherDraught) {
  const ScratchFolder folder;
  write_obj(folder.path() / "box.obj", {nilas::mesh::box_mesh({0, 0, 0}, {4, 1, 1})});
  prepared(folder, "box.obj --out hb --scale 0.5");
  const auto report = prepared(folder, "hb --out again --draught 0.1");
  EXPECT_NEAR(report["displaced_m3"], 2 * 0.5 * 0.1, 1e-9);
  EXPECT_LT(report["deviation_m"], 1e-9);
  const auto description = nlohmann::json::parse(std::ifstream(folder / "again/hull.json"));
  EXPECT_EQ(description["mesh"], "hb");
  for (const char* key : {"scale", "up", "tolerance_m"}) EXPECT_FALSE(description.contains(key)) << key;
}

TEST(HullCommand, AGeneratedHullHasNoDeviation) {
  const ScratchFolder folder;
  const auto report = prepared(folder, "--generate wedge --triangles 400");
  EXPECT_EQ(report["parts"], 1);
  for (const char* key : {"deviation_m", "deviation_precision_m", "deviation_place_m", "tolerance_m"})
    EXPECT_FALSE(report.contains(key)) << key << " where nothing was cut";
}

TEST(HullCommand, TheLeastDraughtStillHasAMetacentricHeight) {
  const ScratchFolder folder;
  write_obj(folder.path() / "box.obj", {nilas::mesh::box_mesh({0, 0, 0}, {4, 1, 1})});
  const double least = 0.001;
  EXPECT_NEAR(prepared(folder, "box.obj --draught 0.001")["gm_m"], 0.5 * least + 1 / (12 * least) - 0.5, 1e-6);
}

TEST(HullCommand, WrongArgumentsAndFilesAreNamed) {
  const ScratchFolder folder;
  write_obj(folder.path() / "box.obj", {nilas::mesh::box_mesh({0, 0, 0}, {4, 1, 1})});
  folder.write("cut.off", "OFF\n8 6 0\n0 0 0\n1 0");
  folder.write("hull.step", "ISO-10303-21;");
  struct Case {
    std::string arguments;
    int exit_code;
    std::string word;
  };
  for (const auto& c : std::vector<Case>{{"box.obj --draught 2", 2, "below 1 m"},
                                         {"box.obj --draught -1", 2, "--draught"},
                                         {"box.obj --draught 1e-300", 2, "at least 0.001 m"},
                                         {"box.obj --length 3", 2, "--length"},
                                         {"box.obj --up x", 2, "--up"},
                                         {"box.obj --scale 0", 2, "--scale"},
                                         {"box.obj --scale 1e6", 2, "--scale 0.001"},
                                         {"box.obj --tolerance nan", 2, "--tolerance"},
                                         {"box.obj --parts 0", 2, "--parts"},
                                         {"box.obj --tolerance 1e-300", 2, "allowed: at least 4e-06 m"},
                                         {"cut.off", 2, "cut.off:4"},
                                         {"hull.step", 2, "allowed: .stl, .obj, .off, .ply"},
                                         {"absent.stl", 4, "absent.stl"},
                                         {"box.obj --generate wedge", 2, "either MESH or --generate"}}) {
    const auto refused = run_nilas("hull " + c.arguments + " --out made", folder.path());
    EXPECT_EQ(refused.exit_code, c.exit_code) << c.arguments << ": " << refused.err;
    EXPECT_NE(refused.err.find(c.word), std::string::npos) << c.arguments << ": " << refused.err;
    EXPECT_FALSE(fs::exists(folder.path() / "made" / "hull.json")) << c.arguments;
  }
}

}  // namespace hull_test
