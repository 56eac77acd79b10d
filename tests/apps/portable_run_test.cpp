/// A run folder that is copied elsewhere, without the files that its scene was written with, works as it did.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <set>

#include "tests/support/mentions.h"
#include "tests/support/started_program.h"

namespace portable_run_test {

using namespace nilas_test;

constexpr const char* k_scene = R"(<scene version="1" name="ship">
  <time step="0.01" end="1"/>
  <contact law="coulomb" solver="nsgs" tolerance="1e-5">
    <friction between="hull ice" static="0.1" kinetic="0.1"/>
    <friction between="ice ice" static="0.3" kinetic="0.3"/>
  </contact>
  <water density="1005"/>
  <hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>
  <vessel name="ship" hull="../hulls/ship" position="0.1 0">
    <mass draught="0.2"/>
    <carriage free="heave">
      <path file="../paths/way.csv"/>
      <force_balance kind="six-cells" stiffness="1e6" damping="1e3" layout="../cells/way.csv"/>
    </carriage>
  </vessel>
  <ice thickness="0.05"><field kind="file" file="../ice/field.geojson"/></ice>
  <output trajectory_every="0.2" bodies="true" checkpoint_every="0.4"/>
</scene>
)";

constexpr const char* k_ice = R"(<scene version="1" name="ice">
  <ice thickness="0.05"><field kind="packed" region="3.2 -0.8 5 0.8" concentration="0.6">
    <size distribution="lognormal" mean="0.4" sd="0.1" min="0.2" max="0.6"/></field></ice>
</scene>
)";

class PortableRun : public ::testing::Test {
 protected:
  /// Makes study/scene.xml with its files in neighbouring folders, and runs it into study/run.
  void SetUp() override {
    fs::create_directories(in("ice"));
    fs::create_directories(in("study"));
    folder.write("ice.xml", k_ice);
    folder.write("paths/way.csv", "t_s,x_m,y_m,yaw_deg\n0,0,0,0\n1,0.6,0,0\n2,1.3,0,0\n3,2,0,0\n");
    folder.write("cells/way.csv",
                 "x_m,y_m,z_m,ax,ay,az\n0,0,0,1,0,0\n1,0,0,0,1,0\n-1,0,0,0,1,0\n1,0,0,0,0,1\n-1,0.3,0,0,0,1\n"
                 "-1,-0.3,0,0,0,1\n");
    folder.write("study/scene.xml", k_scene);
    demand("field ice.xml --no-picture --out ice/field.geojson");
    demand(
        "hull --generate icebreaker --length 3 --beam 0.8 --draught 0.2 --depth 0.4 --triangles 600 --out hulls/ship");
    demand("run study/scene.xml --quiet --out study/run");
  }
  ProgramResult nilas(const std::string& words) const { return run_nilas(words, folder.path()); }
  void demand(const std::string& words) const {
    const auto result = nilas(words);
    ASSERT_EQ(result.exit_code, 0) << words << ": " << result.err;
  }
  fs::path in(const std::string& file) const { return folder.path() / file; }
  /// Moves the run folder alone to another place; the files with which the scene was written are deleted.
  void move_away() const {
    fs::create_directories(in("far"));
    fs::copy(in("study/run"), in("far/copy"), fs::copy_options::recursive);
    for (const char* gone : {"study", "hulls", "paths", "cells", "ice"}) fs::remove_all(in(gone));
  }
  /// Rows of vessel.csv and the state's hash of every step.
  void expect_same_bits(const std::string& run, const std::string& vessel,
                        const std::vector<std::string>& hashes) const {
    EXPECT_EQ(read_text(in(run + "/vessel.csv")), vessel) << run;
    EXPECT_EQ(Table(in(run + "/steps.csv")).text("state_hash"), hashes) << run;
  }

  ScratchFolder folder;
};

TEST_F(PortableRun, AMovedFolderRunsAgainReportsAndGoesOn) {
  const std::string vessel = read_text(in("study/run/vessel.csv")), scene = read_text(in("study/run/scene.xml"));
  const auto hashes = Table(in("study/run/steps.csv")).text("state_hash");
  const auto forces = Table(in("study/run/vessel.csv"))["contact_fx_N"];
  ASSERT_GT(std::count_if(forces.begin(), forces.end(), [](double f) { return f != 0; }), 3) << "the ship met no ice";
  EXPECT_FALSE(mentions(scene, folder.path().string())) << scene;
  for (const char* copy : {"inputs/ship/fluid.stl", "inputs/ship/part-0001.stl", "inputs/way.csv", "inputs/way-2.csv",
                           "inputs/field.geojson"})
    EXPECT_TRUE(mentions(scene, std::string("<input file=\"") + copy)) << copy << "\n" << scene;
  demand("run study/scene.xml --quiet --until 2 --out study/long");
  const std::string longer = read_text(in("study/long/vessel.csv"));
  const auto longer_hashes = Table(in("study/long/steps.csv")).text("state_hash");
  move_away();

  demand("run far/copy/scene.xml --quiet --out again");
  expect_same_bits("again", vessel, hashes);
  EXPECT_EQ(read_text(in("again/scene.xml")), scene);
  demand("run again/scene.xml --quiet --out third");
  EXPECT_EQ(read_text(in("third/scene.xml")), scene) << "of a copy of a copy";
  demand("report far/copy --contacts 0.9");
  EXPECT_TRUE(fs::exists(in("far/copy/contacts.svg")));
  demand("run --quiet --resume far/copy --until 2");
  expect_same_bits("far/copy", longer, longer_hashes);
}

TEST_F(PortableRun, AFolderRunsAgainInItself) {
  const std::string vessel = read_text(in("study/run/vessel.csv")), scene = read_text(in("study/run/scene.xml"));
  const auto hashes = Table(in("study/run/steps.csv")).text("state_hash");
  move_away();
  demand("run far/copy/scene.xml --quiet --force --out far/copy");
  expect_same_bits("far/copy", vessel, hashes);
  EXPECT_EQ(read_text(in("far/copy/scene.xml")), scene);
  EXPECT_EQ(
      std::system(("cd '" + in("far/copy/inputs").string() + "' && sha256sum --quiet -c nilas-inputs.sha256").c_str()),
      0);
}

TEST_F(PortableRun, ACopyThatWasChangedOrIsMissingIsNamed) {
  std::ofstream(in("study/run/inputs/ship/fluid.stl"), std::ios::app) << " ";
  const auto changed = nilas("run study/run/scene.xml --out again");
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_TRUE(mentions(changed.err, "<input sha256>") && mentions(changed.err, "has changed")) << changed.err;
  fs::remove(in("study/run/inputs/ship/fluid.stl"));
  const auto missing = nilas("report study/run --contacts 0.5");
  EXPECT_EQ(missing.exit_code, 4);
  EXPECT_TRUE(mentions(missing.err, "run/inputs/ship/fluid.stl")) << missing.err;
}

/// The folder has absolute paths, as older builds wrote them.
TEST_F(PortableRun, AnOlderFolderWithAbsolutePathsIsRead) {
  const std::string vessel = read_text(in("study/run/vessel.csv"));
  std::string scene = read_text(in("study/run/scene.xml"));
  fs::rename(in("study/run/inputs"), in("study/files"));
  for (auto at = scene.find("\"inputs/"); at != std::string::npos; at = scene.find("\"inputs/"))
    scene.replace(at, 8, "\"" + in("study/files").string() + "/");
  folder.write("study/run/scene.xml", scene);
  demand("run study/run/scene.xml --quiet --out again");
  EXPECT_EQ(read_text(in("again/vessel.csv")), vessel);
  EXPECT_TRUE(fs::exists(in("again/inputs/ship/fluid.stl")));
}

TEST_F(PortableRun, AFullDiskIsAFileErrorThatNamesTheCopy) {
  const std::string command = "cd '" + folder.path().string() +
                              "' && ulimit -f 8 && '" NILAS_PROGRAM
                              "' run study/scene.xml --out full >out.txt 2>err.txt";
  const int status = std::system(("bash -c \"" + command + "\"").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 4);
  EXPECT_TRUE(mentions(read_text(in("err.txt")), "full/inputs/")) << read_text(in("err.txt"));
  EXPECT_FALSE(fs::exists(in("full/inputs"))) << "no half copies are left";
  demand("run study/scene.xml --quiet --out full");
}

TEST_F(PortableRun, ForceReplacesTheCopiesOfAnotherScene) {
  folder.write("study/run/inputs/mine.txt", "mine");
  folder.write("box.xml", "<scene version='1'><time end='0.02'/><body/></scene>");
  demand("run box.xml --quiet --force --out study/run");
  std::set<std::string> left;
  for (const auto& entry : fs::recursive_directory_iterator(in("study/run/inputs")))
    left.insert(entry.path().filename().string());
  EXPECT_EQ(left, std::set<std::string>{"mine.txt"});
}

}  // namespace portable_run_test
