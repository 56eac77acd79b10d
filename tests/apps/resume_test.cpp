/// A run that is killed and resumed leaves the same run folder as one that never stopped.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>
#include <set>
#include <thread>
#include <tuple>

#include "core/hdf5/hdf5_file.h"
#include "tests/core/output/replay/replay_reader.h"
#include "tests/support/mentions.h"
#include "tests/support/started_program.h"

namespace resume_test {

using namespace nilas_test;

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), folder).string());
  return files;
}

/// All columns but the times.
void expect_same_steps(const fs::path& one, const fs::path& other) {
  const Table a(one), b(other);
  ASSERT_EQ(a.header(), b.header());
  for (const auto& name : a.header()) {
    if (name.rfind("ms_", 0) != 0) {
      EXPECT_EQ(a.text(name), b.text(name)) << name;
    }
  }
}

nlohmann::json untimed_summary(const fs::path& file) {
  auto summary = nlohmann::json::parse(read_text(file));
  for (const char* time : {"wall_s", "processor_s", "resuming_s", "real_time_factor", "threads", "slowdown"})
    summary.erase(time);
  summary["modules"].erase("ms_per_step");
  return summary;
}

/// HDF5 notes when a dataset was made, so the files themselves differ.
void expect_same_problem(const fs::path& one, const fs::path& other) {
  const nilas::hdf5::Hdf5Reader a(one), b(other);
  const auto names = a.datasets("fclib_global");
  EXPECT_EQ(b.datasets("fclib_global"), names);
  ASSERT_GT(names.size(), 5u);
  for (const auto& name : names) {
    const std::string place = "fclib_global/" + name;
    ASSERT_EQ(a.kind(place), b.kind(place)) << name;
    if (a.kind(place) == nilas::hdf5::Hdf5Reader::Kind::numbers) {
      EXPECT_EQ(a.exact_numbers(place), b.exact_numbers(place)) << name;
    }
    if (a.kind(place) == nilas::hdf5::Hdf5Reader::Kind::integers) {
      EXPECT_EQ(a.wide_integers(place), b.wide_integers(place)) << name;
    }
  }
}

/// Rows written together differ with the wall time, so the files' bytes do.
void expect_same_contacts(const fs::path& one, const fs::path& other) {
  const nilas::hdf5::Hdf5Reader a(one), b(other);
  const auto names = a.datasets("contacts");
  EXPECT_EQ(b.datasets("contacts"), names);
  ASSERT_GT(names.size(), 15u);
  for (const auto& name : names) {
    const std::string place = "contacts/" + name;
    ASSERT_EQ(a.kind(place), b.kind(place)) << name;
    if (a.kind(place) == nilas::hdf5::Hdf5Reader::Kind::numbers) {
      EXPECT_EQ(a.exact_numbers(place), b.exact_numbers(place)) << name;
    } else {
      EXPECT_EQ(a.wide_integers(place), b.wide_integers(place)) << name;
    }
  }
  EXPECT_EQ(a.wide_integers("steps"), b.wide_integers("steps"));
}

/// The order of pairs in a frame depends on when they came together since the last key frame.
std::vector<nilas::test::ReplayContact> in_order(std::vector<nilas::test::ReplayContact> contacts) {
  std::stable_sort(contacts.begin(), contacts.end(), [](const auto& a, const auto& b) {
    return std::tuple(!a.exact, a.first, a.second) < std::tuple(!b.exact, b.first, b.second);
  });
  return contacts;
}

/// Before the first step channels are not a number.
bool same_channel(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return a == b || (std::isnan(a[0]) && std::isnan(b[0]));
}

/// Frames apart from the times that phases took. Where key frames lie depends on where the run was stopped.
void expect_same_replay(const fs::path& one, const fs::path& other) {
  const nilas::test::Replay a(read_text(one)), b(read_text(other));
  EXPECT_EQ(a.head, b.head);
  EXPECT_EQ(a.end, b.end);
  ASSERT_EQ(a.frames.size(), b.frames.size());
  for (std::size_t k = 0; k < a.frames.size(); ++k) {
    const auto &x = a.frames[k], &y = b.frames[k];
    EXPECT_EQ(x.t, y.t);
    ASSERT_EQ(x.bodies.size(), y.bodies.size());
    for (std::size_t i = 0; i < x.bodies.size(); ++i) EXPECT_EQ(x.bodies[i].now, y.bodies[i].now);
    const auto p = in_order(x.contacts), q = in_order(y.contacts);
    ASSERT_EQ(p.size(), q.size());
    for (std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(p[i].force, q[i].force);
    for (std::size_t i = 0; i < x.channels.size(); ++i) {
      if (a.head.at("channels")[i].at("group") != "time") {
        EXPECT_TRUE(same_channel(x.channels[i], y.channels[i])) << a.head.at("channels")[i];
      }
    }
  }
}

/// Compares every file of both folders except the log, the checkpoint and wall times.
void expect_same_run(const fs::path& one, const fs::path& other) {
  EXPECT_EQ(files_in(one), files_in(other));
  for (const auto& file : files_in(one)) {
    if (file == "nilas.log" || file == "checkpoint.h5") continue;
    if (file == "steps.csv") {
      expect_same_steps(one / file, other / file);
    } else if (file == "replay.bin") {
      expect_same_replay(one / file, other / file);
    } else if (file == "contacts.h5") {
      expect_same_contacts(one / file, other / file);
    } else if (fs::path(file).extension() == ".hdf5") {
      expect_same_problem(one / file, other / file);
    } else if (file == "summary.json") {
      EXPECT_EQ(untimed_summary(one / file), untimed_summary(other / file));
    } else {
      EXPECT_EQ(read_text(one / file), read_text(other / file)) << file;
    }
  }
}

constexpr const char* k_ice = R"(<scene version="1" name="ice">
  <time step="0.01" end="2.5"/>
  <contact law="coulomb" solver="nsgs" tolerance="1e-5">
    <friction between="ice ice" static="0.5" kinetic="0.3"/>
    <friction between="hull ice" static="0.1" kinetic="0.1"/>
  </contact>
  <water density="1005"/>
  <hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>
  <tank length="9" width="3" depth="1" wall_thickness="0.2" floor="true"/>
  <vessel name="ship" position="0.1 0">
    <hull generate="icebreaker" length="3" beam="0.8" draught="0.2" depth="0.4" triangles="600"/>
    <mass draught="0.2"/>
    <carriage speed="0.5" ramp="0.1" free="heave"><force_balance kind="six-cells" stiffness="1e6" damping="1e3"/></carriage>
  </vessel>
  <ice thickness="0.05">
    <field kind="packed" region="3 -1.5 6 1.5" concentration="0.7"><size distribution="lognormal" mean="0.4" sd="0.1" min="0.2" max="0.6"/></field>
  </ice>
  <output trajectory_every="0.07" bodies="true" problems="worst"/>
</scene>
)";

class Resume : public ::testing::Test {
 protected:
  Resume() { folder.write("ice.xml", k_ice); }
  ProgramResult nilas(const std::string& arguments) const { return run_nilas(arguments, folder.path()); }
  void demand(const std::string& arguments) const {
    const auto result = nilas(arguments);
    ASSERT_EQ(result.exit_code, 0) << arguments << ": " << result.err;
  }
  void run_whole(const std::string& flags = "") const {
    demand("run ice.xml --quiet --checkpoint-every 0.3 --out whole " + flags);
  }
  fs::path in(const std::string& file) const { return folder.path() / file; }

  ScratchFolder folder;
};

/// Killed again and again, at moments that depend on nothing, until the run comes to its end.
TEST_F(Resume, KilledAtAnyMomentsLeavesTheSameRun) {
  run_whole();
  const Table steps(in("whole/steps.csv"));
  ASSERT_EQ(steps.rows(), 250u);
  const Table vessel(in("whole/vessel.csv"));
  const auto struck = [](double force) { return force != 0; };
  ASSERT_GT(std::count_if(vessel["contact_fx_N"].begin(), vessel["contact_fx_N"].end(), struck), 50);
  ASSERT_GT(nilas::hdf5::Hdf5Reader(in("whole/contacts.h5")).size("contacts/time_s"), 100u);
  std::mt19937 random(7);
  for (int trial = 0; trial < 4; ++trial) {
    const std::string out = "cut" + std::to_string(trial);
    std::string command = "run ice.xml --quiet --checkpoint-every 0.3 --out " + out;
    int kills = 0;
    for (bool done = false; !done;) {
      Started run(command, folder.path());
      const std::size_t rows = 1 + random() % 120;
      const bool reached = run.reaches(in(out + "/steps.csv"), lines_of(in(out + "/steps.csv")).size() + rows);
      std::this_thread::sleep_for(std::chrono::microseconds(random() % 4000));
      if (kills < 3 && reached && run.runs()) {
        EXPECT_EQ(run.stop(SIGKILL), 128 + SIGKILL);
        ++kills;
      } else {
        while (run.runs()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        ASSERT_EQ(run.stop(SIGKILL), 0) << read_text(in("err.txt"));
        done = true;
      }
      command = "run --quiet --resume " + out + (kills % 2 == 0 ? " --threads 2" : "");
    }
    EXPECT_GE(kills, 1);
    SCOPED_TRACE(out + " after " + std::to_string(kills) + " kills");
    expect_same_run(in("whole"), in(out));
  }
}

/// The folder is in the state that a kill at the worst moments leaves: half rows, frames that no list names, a
/// checkpoint half written.
TEST_F(Resume, WhatIsBeyondTheCheckpointIsWrittenAgain) {
  run_whole();
  {
    Started run("run ice.xml --quiet --checkpoint-every 0.3 --out cut", folder.path());
    ASSERT_TRUE(run.reaches(in("cut/steps.csv"), 100));
    run.stop(SIGKILL);
  }
  std::ofstream(in("cut/steps.csv"), std::ios::app) << "1.23,4";
  std::ofstream(in("cut/vessel.csv"), std::ios::app) << "0.1";
  std::ofstream(in("cut/trajectory/step-999999.vtp")) << "of a step that the rest does not have";
  std::ofstream(in("cut/checkpoint.h5.part")) << "half";
  std::ofstream(in("cut/trajectory/step-000999.vtp.part")) << "half";
  ASSERT_EQ(nilas("run --quiet --resume cut").exit_code, 0);
  expect_same_run(in("whole"), in("cut"));
}

TEST_F(Resume, BeforeTheFirstCheckpointTheRunBeginsAgain) {
  run_whole();
  {
    Started run("run ice.xml --quiet --checkpoint-every 0.3 --out cut", folder.path());
    ASSERT_TRUE(run.reaches(in("cut/steps.csv"), 5));
    run.stop(SIGKILL);
  }
  ASSERT_FALSE(fs::exists(in("cut/checkpoint.h5"))) << "the test was too slow";
  const auto result = nilas("run --resume cut");
  ASSERT_EQ(result.exit_code, 0);
  EXPECT_TRUE(mentions(result.err, "begins again")) << result.err;
  expect_same_run(in("whole"), in("cut"));
}

/// Though it asked for no checkpoints.
TEST_F(Resume, AnInterruptedRunGoesOnWhereItStopped) {
  run_whole();
  {
    Started run("run ice.xml --quiet --out cut", folder.path());
    ASSERT_TRUE(run.reaches(in("cut/steps.csv"), 40));
    EXPECT_EQ(run.stop(SIGINT), 130);
  }
  const auto summary = nlohmann::json::parse(read_text(in("cut/summary.json")));
  EXPECT_EQ(summary["status"], "interrupted");
  EXPECT_TRUE(mentions(read_text(in("cut/nilas.log")), "`nilas run --resume cut` continues the run."));
  const auto result = nilas("run --resume cut --checkpoint-every 0.3");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(mentions(result.err, "continues from")) << result.err;
  EXPECT_FALSE(summary.contains("resuming_s"));
  const auto resumed = nlohmann::json::parse(read_text(in("cut/summary.json")));
  EXPECT_GT(resumed.at("resuming_s").get<double>(), 0);
  EXPECT_LT(resumed.at("resuming_s").get<double>(), resumed.at("wall_s").get<double>());
  expect_same_run(in("whole"), in("cut"));
}

TEST_F(Resume, UntilMakesARunLonger) {
  run_whole();
  ASSERT_EQ(nilas("run ice.xml --quiet --checkpoint-every 0.3 --until 1.1 --out short").exit_code, 0);
  const auto earlier = nilas("run --resume short --until 0.5");
  EXPECT_EQ(earlier.exit_code, 2);
  EXPECT_TRUE(mentions(earlier.err, "has reached 1.1 s")) << earlier.err;
  {
    Started longer("run --quiet --resume short --until 2.5", folder.path());
    ASSERT_TRUE(longer.reaches(in("short/steps.csv"), 190));
    longer.stop(SIGKILL);
  }
  ASSERT_EQ(nilas("run --quiet --resume short").exit_code, 0) << "the new end is kept";
  expect_same_run(in("whole"), in("short"));
}

/// The checkpoint is far older than the content of the folder, as after a kill, and the resumed run ends before that
/// content.
TEST_F(Resume, ProblemsBeyondTheCheckpointAreRemoved) {
  for (const std::string which : {"worst", "every"}) {
    SCOPED_TRACE(which);
    const std::string asked = " --set output/@problems=" + which + " --out ";
    demand("run ice.xml --quiet --checkpoint-every 0.3" + asked + "long-" + which);
    const auto residual = Table(in("long-" + which + "/steps.csv"))["law_map_m_s"];
    const auto worst = std::max_element(residual.begin(), residual.end()) - residual.begin();
    ASSERT_GT(worst, 60) << "the worst step is to come after the checkpoint";
    const std::string stop = std::to_string(0.006 * static_cast<double>(worst));
    const std::string end = std::to_string(0.008 * static_cast<double>(worst));
    demand("run ice.xml --quiet --checkpoint-every 0.3 --until " + end + asked + "whole-" + which);
    const fs::path cut = in("cut-" + which);
    demand("run ice.xml --quiet --checkpoint-every 0.3 --until " + stop + asked + cut.string());
    demand("run --quiet --checkpoint-every 0 --until 2.5 --resume " + cut.string());
    ASSERT_EQ(files_in(cut).count("problems/worst.hdf5"), which == "worst" ? 1u : 0u);
    for (const char* name : {"last.hdf5", "worst.hdf5.part", "step-00000003.hdf5.part"})
      std::ofstream(cut / "problems" / name) << "of a run that was killed";
    demand("run --quiet --checkpoint-every 0.3 --until " + end + " --resume " + cut.string());
    expect_same_run(in("whole-" + which), cut);
    demand("run --quiet --until 2.5 --resume " + cut.string());
    expect_same_run(in("long-" + which), cut);
  }
}

TEST_F(Resume, AFolderHasOneWriterAtATime) {
  Started run("run ice.xml --quiet --checkpoint-every 0.1 --until 1000 --out run", folder.path());
  ASSERT_TRUE(run.reaches(in("run/steps.csv"), 30));
  for (const char* second : {"run --resume run", "run ice.xml --out run --force", "verify --out run --force"}) {
    const auto result = nilas(second);
    EXPECT_EQ(result.exit_code, 4) << second;
    EXPECT_TRUE(mentions(result.err, "another program is writing this run")) << second << ": " << result.err;
  }
  ASSERT_TRUE(run.reaches(in("run/steps.csv"), lines_of(in("run/steps.csv")).size() + 10)) << "the first goes on";
  EXPECT_EQ(run.stop(SIGKILL), 128 + SIGKILL);
  demand("run ice.xml --quiet --until 0.05 --out run --force");
}

TEST_F(Resume, ADoneRunSaysSo) {
  ASSERT_EQ(nilas("run ice.xml --quiet --until 0.2 --out run").exit_code, 0);
  const auto before = files_in(in("run"));
  const std::string log = read_text(in("run/nilas.log")), summary = read_text(in("run/summary.json"));
  const auto result = nilas("run --resume run");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(mentions(result.out, "done already")) << result.out;
  EXPECT_EQ(nilas("run --resume run --json").out, summary);
  EXPECT_EQ(files_in(in("run")), before);
  EXPECT_EQ(read_text(in("run/nilas.log")), log);
  const auto longer = nilas("run --resume run --until 0.4");
  EXPECT_EQ(longer.exit_code, 4);
  EXPECT_TRUE(mentions(longer.err, "not asked for checkpoints")) << longer.err;
}

TEST_F(Resume, FlagsThatWouldChangeThePastAreRefused) {
  ASSERT_EQ(nilas("run ice.xml --quiet --until 0.1 --checkpoint-every 0.05 --out run").exit_code, 0);
  for (const std::string flag : {"ice.xml", "--dt 0.02", "--solver pgs", "--law ccp", "--seed 3", "--force",
                                 "--set contact/@tolerance=1", "--twins 2", "--out other"}) {
    const auto result = nilas("run --resume run " + flag);
    EXPECT_EQ(result.exit_code, 2) << flag;
    const std::string name = flag == "ice.xml" ? "scene" : flag.substr(0, flag.find(' '));
    EXPECT_TRUE(mentions(result.err, "remove " + name)) << flag << ": " << result.err;
  }
  EXPECT_FALSE(fs::exists(in("other")));
}

TEST_F(Resume, WhatIsNoRunIsRefused) {
  const auto refused = [&](const std::string& run, int code, const std::string& word) {
    const auto result = nilas("run --resume " + run);
    EXPECT_EQ(result.exit_code, code) << run << ": " << result.err;
    EXPECT_TRUE(mentions(result.err, word)) << run << ": " << result.err;
  };
  refused("nowhere", 4, "nowhere: there is no such run folder");
  refused("ice.xml", 4, "is no run folder");
  fs::create_directory(in("empty"));
  refused("empty", 4, "it has no scene.xml");
  EXPECT_TRUE(files_in(in("empty")).empty());

  ASSERT_EQ(nilas("run ice.xml --quiet --until 0.3 --checkpoint-every 0.1 --out run").exit_code, 0);
  fs::remove(in("run/summary.json"));
  const std::string checkpoint = read_text(in("run/checkpoint.h5")), scene = read_text(in("run/scene.xml"));
  const std::string steps = read_text(in("run/steps.csv"));
  for (const double share : {0.0, 0.01, 0.3, 0.7, 0.999}) {
    const auto length = static_cast<std::size_t>(share * static_cast<double>(checkpoint.size()));
    folder.write("run/checkpoint.h5", checkpoint.substr(0, length));
    refused("run", 2, "checkpoint.h5");
  }
  folder.write("run/checkpoint.h5", checkpoint);
  folder.write("run/scene.xml",
               std::regex_replace(scene, std::regex("concentration=\"0.7\""), "concentration=\"0.6\""));
  refused("run", 2, "another scene");
  folder.write("run/scene.xml", scene);
  folder.write("run/steps.csv", steps.substr(0, steps.size() / 2));
  refused("run", 2, "steps.csv: holds");
  folder.write("run/steps.csv", "inserted" + steps);
  refused("run", 2, "steps.csv: has changed");
  fs::remove(in("run/steps.csv"));
  refused("run", 4, "steps.csv");
  folder.write("run/steps.csv", steps);
  EXPECT_EQ(nilas("run --quiet --resume run").exit_code, 0);
  EXPECT_EQ(read_text(in("run/steps.csv")), steps);
}

TEST_F(Resume, AnotherBuildOfTheProgramIsRefused) {
  demand("run ice.xml --quiet --until 0.2 --checkpoint-every 0.1 --out run");
  const std::string program = nilas::hdf5::Hdf5Reader(in("run/checkpoint.h5")).text("program");
  for (const char* word : {"nilas ", "GNU ", "-O", "simbody ", "fcl ", "eigen ", "cgal ", "sundials "})
    EXPECT_TRUE(mentions(program, word)) << word << ": " << program;
  // The same but for a byte after all that is loaded.
  fs::copy_file(NILAS_PROGRAM, in("rebuilt"));
  std::ofstream(in("rebuilt"), std::ios::app) << "x";
  const auto resume = [&] {
    const std::string command =
        "cd '" + folder.path().string() + "' && ./rebuilt run --resume run --until 0.3 2>err.txt";
    const int status = std::system(command.c_str());
    return WEXITSTATUS(status);
  };
  EXPECT_EQ(resume(), 2);
  EXPECT_TRUE(mentions(read_text(in("err.txt")), "another build of the same version")) << read_text(in("err.txt"));
  demand("run --quiet --resume run --until 0.3");
}

TEST_F(Resume, AChangedInputFileIsRefused) {
  ASSERT_EQ(nilas("hull --generate icebreaker --length 3 --beam 0.6 --draught 0.2 --out ship").exit_code, 0);
  folder.write("ship.xml", R"(<scene version="1" name="ship">
  <time end="0.1"/>
  <water density="1000"/>
  <hydro><buoyancy/></hydro>
  <vessel name="ship" hull="ship" position="0 0"><mass draught="0.2"/></vessel>
</scene>
)");
  ASSERT_EQ(nilas("run ship.xml --quiet --checkpoint-every 0.05 --out run").exit_code, 0);
  fs::remove_all(in("ship"));
  fs::remove(in("run/summary.json"));
  ASSERT_EQ(nilas("run --quiet --resume run").exit_code, 0);
  fs::remove(in("run/summary.json"));
  std::ofstream(in("run/inputs/ship/fluid.stl"), std::ios::app) << " ";
  const auto changed = nilas("run --resume run");
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_TRUE(mentions(changed.err, "fluid.stl") || mentions(changed.err, "SHA-256")) << changed.err;
  fs::remove(in("run/inputs/ship/fluid.stl"));
  EXPECT_EQ(nilas("run --resume run").exit_code, 4);
}

TEST_F(Resume, NeitherSceneNorFolderIsAUsageError) {
  const auto result = nilas("run");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(mentions(result.err, "scene")) << result.err;
}

}  // namespace resume_test
