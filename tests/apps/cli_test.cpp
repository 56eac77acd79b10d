/// The command line as a user meets it: exit codes, messages, refusals, interruption.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/apps/small_scenes.h"
#include "tests/support/mentions.h"
#include "tests/support/program.h"

namespace cli_test {

using namespace nilas_test;

TEST(Cli, HelpNamesEveryCommand) {
  const ScratchFolder folder;
  const auto help = run_nilas("--help", folder.path());
  EXPECT_EQ(help.exit_code, 0);
  for (const char* command : {"run", "check", "hull", "field", "solve", "solvers", "schema", "verify"}) {
    EXPECT_TRUE(mentions(help.out, command)) << command;
    EXPECT_EQ(run_nilas(std::string(command) + " --help", folder.path()).exit_code, 0) << command;
  }
}

/// docs/reference/command-line.md must equal the program's own help texts.
TEST(Cli, ThePageOfCommandsIsThatOfTheProgram) {
  const ScratchFolder folder;
  const auto page = run_nilas("schema --commands", folder.path());
  EXPECT_EQ(page.exit_code, 0);
  EXPECT_EQ(page.out, read_text(fs::path(NILAS_SOURCE_DIR) / "docs/reference/command-line.md"))
      << "write it again: build/release/nilas schema --commands > docs/reference/command-line.md";
}

TEST(Cli, VersionNamesTheProgramInItsFirstLineAndThenItsLibraries) {
  const ScratchFolder folder;
  const auto version = run_nilas("--version", folder.path());
  ASSERT_EQ(version.exit_code, 0);
  const std::string project = read_text(fs::path(NILAS_SOURCE_DIR) / "CMakeLists.txt");
  const std::string head = "project(nilas VERSION ";
  const std::size_t at = project.find(head) + head.size();
  EXPECT_EQ(version.out.substr(0, version.out.find('\n')), "nilas " + project.substr(at, project.find(' ', at) - at));
  const std::string eigen = std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
                            std::to_string(EIGEN_MINOR_VERSION);
  EXPECT_TRUE(mentions(version.out, "eigen " + eigen)) << version.out;
  for (const char* name : {"cgal", "compiler", "fcl", "hdf5", "simbody", "sundials", "tinyxml2"}) {
    const std::size_t place = version.out.find(std::string(name) + " ");
    ASSERT_NE(place, std::string::npos) << name << " is missing in " << version.out;
    const std::string value = version.out.substr(place, version.out.find_first_of(",\n", place) - place);
    EXPECT_NE(value.find_first_of("0123456789", std::string(name).size()), std::string::npos)
        << name << " has no version: CMake's package does not tell it";
  }
}

TEST(Cli, UsageErrorsExitWithTwo) {
  const ScratchFolder folder;
  EXPECT_EQ(run_nilas("", folder.path()).exit_code, 2);
  EXPECT_EQ(run_nilas("fly", folder.path()).exit_code, 2);
  EXPECT_EQ(run_nilas("run", folder.path()).exit_code, 2);
  EXPECT_EQ(run_nilas("run scene.xml --threads none", folder.path()).exit_code, 2);
}

TEST(Cli, ARunEndsWithTheFirstStepThatReachesItsEnd) {
  const ScratchFolder folder;
  folder.write("box.xml", k_box);
  for (const auto& [step, steps] : std::vector<std::pair<const char*, int>>{{"0.01", 20}, {"0.03", 7}, {"5", 1}}) {
    const auto result = run_nilas(std::string("run box.xml --out run --force --json --dt ") + step, folder.path());
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(nlohmann::json::parse(result.out)["steps"], steps) << step;
  }
}

TEST(Cli, ADryBoxRunsAndStops) {
  const ScratchFolder folder;
  folder.write("box.xml", k_box);
  const auto result = run_nilas("run box.xml --out run --json", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto summary = nlohmann::json::parse(result.out);
  EXPECT_EQ(summary["status"], "done");
  EXPECT_EQ(summary["steps"], 20);
  for (const char* file : {"scene.xml", "steps.csv", "bodies.csv", "summary.json", "nilas.log", "trajectory.pvd"})
    EXPECT_TRUE(fs::exists(folder.path() / "run" / file)) << file;
  EXPECT_FALSE(fs::exists(folder.path() / "run" / "vessel.csv")) << "no vessel, no vessel.csv";
  // sliding friction: v = v0 - mu g t
  const Table bodies(folder.path() / "run/bodies.csv");
  EXPECT_NEAR(bodies["vx_m_s"].back(), 1 - 0.3 * 9.81 * 0.2, 1e-8);
}

TEST(Cli, FiveFaultsGiveFiveMessagesWithPlaces) {
  const ScratchFolder folder;
  folder.write("bad.xml", R"(<scene version="1" name="bad">
  <time step="0.01" start="5" end="1"/>
  <contcat law="coulomb"/>
  <body name="a" shape="box" mass="-2"/>
  <body name="b" shape="bxo"/>
  <water densty="1025"/>
</scene>
)");
  const auto result = run_nilas("run bad.xml --out run", folder.path());
  EXPECT_EQ(result.exit_code, 2);
  for (const char* place : {"bad.xml:2:", "bad.xml:3:", "bad.xml:4:", "bad.xml:5:", "bad.xml:6:"})
    EXPECT_TRUE(mentions(result.err, place)) << place << "\n" << result.err;
  EXPECT_TRUE(mentions(result.err, "contact"));
  EXPECT_TRUE(mentions(result.err, "density"));
  EXPECT_TRUE(mentions(result.err, "5 faults")) << result.err;
  EXPECT_FALSE(fs::exists(folder.path() / "run")) << "nothing is written for a scene that cannot run";
}

TEST(Cli, MissingFilesAndUnwritableOutput) {
  const ScratchFolder folder;
  folder.write("box.xml", k_box);
  EXPECT_EQ(run_nilas("run none.xml", folder.path()).exit_code, 4);
  const auto misspelt = run_nilas("run bx.xml", folder.path());
  EXPECT_EQ(misspelt.exit_code, 4);
  EXPECT_TRUE(mentions(misspelt.err, "bx.xml: there is no such file or folder; nearest: box.xml")) << misspelt.err;
  const auto no_run = run_nilas("report bux.xml --contacts 1", folder.path());
  EXPECT_EQ(no_run.exit_code, 4);
  EXPECT_TRUE(mentions(no_run.err, "bux.xml: there is no such run folder; nearest: box.xml")) << no_run.err;
  folder.write("file", "not a folder");
  EXPECT_EQ(run_nilas("run box.xml --out file/run", folder.path()).exit_code, 4);
  fs::create_directories(folder.path() / "full");
  folder.write("full/notes.txt", "mine");
  const auto refused = run_nilas("run box.xml --out full", folder.path());
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_TRUE(mentions(refused.err, "--force"));
  EXPECT_EQ(run_nilas("run box.xml --out full --force --quiet", folder.path()).exit_code, 0);
  EXPECT_EQ(read_text(folder.path() / "full/notes.txt"), "mine");
}

constexpr const char* k_hull_in_water = R"(<scene version="1" name="ship">
  <time end="0.1"/>
  <water density="1000"/>
  <hydro><buoyancy/></hydro>
  <vessel name="ship" hull="HULL" position="0 0"><mass draught="0.2"/></vessel>
</scene>
)";

std::string ship_with(const std::string& hull) {
  std::string text = k_hull_in_water;
  return text.replace(text.find("HULL"), 4, hull);
}

TEST(Cli, AMissingHullAndAnOpenHullAreNamed) {
  const ScratchFolder folder;
  folder.write("missing.xml", ship_with("nowhere"));
  const auto missing = run_nilas("check missing.xml", folder.path());
  EXPECT_EQ(missing.exit_code, 4);
  EXPECT_TRUE(mentions(missing.err, "nowhere")) << missing.err;

  // Together with a fault in the scene itself it is one of several faults.
  folder.write("two.xml", ship_with("nowhere\" headin=\"3"));
  const auto two = run_nilas("check two.xml", folder.path());
  EXPECT_EQ(two.exit_code, 2);
  EXPECT_TRUE(mentions(two.err, "nowhere") && mentions(two.err, "2 faults")) << two.err;

  // a tetrahedron without its fourth face
  folder.write("open.stl",
               "solid open\n"
               "facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
               "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
               "facet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\n"
               "endsolid open\n");
  folder.write("open.xml", ship_with("open.stl"));
  const auto open = run_nilas("check open.xml", folder.path());
  EXPECT_EQ(open.exit_code, 2);
  EXPECT_TRUE(mentions(open.err, "open.stl")) << open.err;
  EXPECT_TRUE(mentions(open.err, "open edge")) << open.err;
}

TEST(Cli, OverlappingFloesAreNamed) {
  const ScratchFolder folder;
  folder.write("overlap.xml", R"(<scene version="1" name="overlap">
  <time end="0.1"/>
  <ice thickness="0.1">
    <floe name="left" outline="0 0 1 0 1 1 0 1"/>
    <floe name="right" outline="0.9 0 2 0 2 1 0.9 1"/>
  </ice>
</scene>
)");
  const auto result = run_nilas("run overlap.xml --out run", folder.path());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(mentions(result.err, "left") && mentions(result.err, "right")) << result.err;
  EXPECT_FALSE(fs::exists(folder.path() / "run")) << "a run that could not begin leaves no folder";
}

TEST(Cli, AVesselInAWallOrDeeperThanItsHullIsRefused) {
  const ScratchFolder folder;
  const std::string hull = "hull --generate icebreaker --length 3 --beam 0.6 --draught 0.2 --out ship";
  ASSERT_EQ(run_nilas(hull, folder.path()).exit_code, 0);
  std::string text = ship_with("ship");
  folder.write("deep.xml", std::string(text).replace(text.find("0.2\"/>"), 3, "2.2"));
  const auto deep = run_nilas("run deep.xml --out run", folder.path());
  EXPECT_EQ(deep.exit_code, 2);
  EXPECT_TRUE(mentions(deep.err, "draught 2.2 m")) << deep.err;
  text.replace(text.find("  <vessel"), 0, "  <tank length=\"9\" width=\"4\" depth=\"1\" wall_thickness=\"0.2\"/>\n");
  folder.write("wall.xml", text.replace(text.find("0 0\">"), 3, "-1 0"));
  const auto wall = run_nilas("run wall.xml --out run", folder.path());
  EXPECT_EQ(wall.exit_code, 2);
  EXPECT_TRUE(mentions(wall.err, "'ship'") && mentions(wall.err, "overlap")) << wall.err;
}

TEST(Cli, HelpFitsATerminal) {
  const ScratchFolder folder;
  for (const char* command : {"", "run", "check", "hull", "field", "solve", "solvers", "schema", "verify"}) {
    const auto help = run_nilas(std::string(command) + " --help", folder.path());
    ASSERT_EQ(help.exit_code, 0);
    std::istringstream lines(help.out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << command << ": " << line;
  }
}

TEST(Cli, InterruptionLeavesCompleteOutputs) {
  const ScratchFolder folder;
  folder.write("box.xml", k_box);
  const std::string command = "cd '" + folder.path().string() +
                              "' && timeout -s INT 1 '" NILAS_PROGRAM
                              "' run box.xml --until 100000 --out run >out.txt 2>err.txt";
  const int status = std::system(command.c_str());
  // timeout reports 124 when it sent the signal, whatever the program answered; the summary holds the program's own
  // code
  EXPECT_EQ(WEXITSTATUS(status), 124);
  const auto summary = nlohmann::json::parse(read_text(folder.path() / "run/summary.json"));
  EXPECT_EQ(summary["status"], "interrupted");
  EXPECT_EQ(summary["exit_code"], 130);
  const std::string said = read_text(folder.path() / "err.txt");
  EXPECT_TRUE(mentions(said, "warning: The run was interrupted at ")) << said;
  EXPECT_TRUE(mentions(said, "`nilas run --resume run` continues the run.")) << said;
  const std::string account = read_text(folder.path() / "out.txt");
  EXPECT_EQ(account.rfind("interrupted           at ", 0), 0u) << account;
  const Table steps(folder.path() / "run/steps.csv");
  EXPECT_EQ(static_cast<long>(steps.rows()), summary["steps"].get<long>());
}

TEST(Cli, InterruptionBeforeTheFirstStepSaysSoAndLeavesTheFolderUsable) {
  const ScratchFolder folder;
  folder.write("dense.xml", R"(<scene version="1" name="dense">
  <time end="0.02"/>
  <ice thickness="0.1"><field kind="packed" region="0 0 60 60" concentration="0.85">
    <size distribution="fixed" mean="1"/></field></ice>
</scene>
)");
  // The signal comes as soon as the program catches it (signal 15 in the kernel's mask), while it packs 3000 floes.
  const std::string command = "cd '" + folder.path().string() +
                              "' && { '" NILAS_PROGRAM
                              "' run dense.xml --out run >out.txt 2>err.txt & p=$!; "
                              "until grep -Eq '^SigCgt:.*[4-7c-f]...$' /proc/$p/status; do kill -0 $p || break; "
                              "sleep 0.01; done; kill -TERM $p; wait $p; }";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 130);
  EXPECT_EQ(read_text(folder.path() / "err.txt"), "The program was interrupted before it had finished.\n");
  folder.write("box.xml", k_box);
  EXPECT_EQ(run_nilas("run box.xml --quiet --out run", folder.path()).exit_code, 0);
}

TEST(Cli, SetOverridesOneAttribute) {
  const ScratchFolder folder;
  folder.write("box.xml", k_box);
  ASSERT_EQ(
      run_nilas("run box.xml --quiet --out run --set \"body[@name='box']/@velocity=2 0 0\" --dt 0.005 --until 0.1",
                folder.path())
          .exit_code,
      0);
  const Table bodies(folder.path() / "run/bodies.csv");
  EXPECT_NEAR(bodies["vx_m_s"].back(), 2 - 0.3 * 9.81 * 0.1, 1e-8);
  const auto wrong = run_nilas("check box.xml --set contact/@tolerence=1", folder.path());
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(mentions(wrong.err, "tolerance")) << wrong.err;
}

TEST(Cli, CheckSaysWhatIsBuilt) {
  const ScratchFolder folder;
  const auto result = run_nilas("check '" + shipped_scene("mirror-25.xml").string() + "' --json", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_TRUE(json["modules"].contains("buoyancy"));
  EXPECT_EQ(json["floes"], 50);
  const auto& absent = json["not_built"];
  EXPECT_NE(std::find(absent.begin(), absent.end(), "fracture"), absent.end());
}

TEST(Cli, HullGenerateReportsAndWritesAFolderThatScenesTake) {
  const ScratchFolder folder;
  const auto made = run_nilas(
      "hull --generate icebreaker --length 3 --beam 0.6 --draught 0.2 --stem-angle 30 "
      "--triangles 1000 --out ship --json",
      folder.path());
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const auto report = nlohmann::json::parse(made.out);
  EXPECT_TRUE(report["closed"].get<bool>());
  EXPECT_TRUE(report["symmetric"].get<bool>());
  EXPECT_GT(report["volume_m3"].get<double>(), 0);
  folder.write("ship.xml", ship_with("ship"));
  EXPECT_EQ(run_nilas("run ship.xml --quiet --out run", folder.path()).exit_code, 0);
}

TEST(Cli, SchemaIsXml) {
  const ScratchFolder folder;
  const auto xsd = run_nilas("schema --xsd", folder.path());
  EXPECT_EQ(xsd.exit_code, 0);
  EXPECT_TRUE(mentions(xsd.out, "<xs:schema"));
}

}  // namespace cli_test
