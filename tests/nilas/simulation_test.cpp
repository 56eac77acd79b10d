/// The library's simulations.
#include "nilas/simulation.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

double hold_a_floe();

namespace simulation_test {

using nilas::Error;
using nilas::ErrorKind;
using nilas::Scene;
using nilas::Simulation;
using nilas::Step;

constexpr const char* k_balls = R"(
<scene version="1" name="balls">
  <time step="0.01" end="0.5"/>
  <contact law="coulomb" solver="auto" tolerance="1e-8" integrator="semi-implicit-euler"/>
  <body name="ground" shape="plane" fixed="true"/>
  <body name="one" shape="sphere" radius="0.1" mass="2" position="0 0 0.3"/>
  <body name="two" shape="sphere" radius="0.1" mass="1" position="1 0 0.5" velocity="-1 0 0"/>
</scene>)";

Scene balls() { return Scene::parse(k_balls, "balls.xml"); }

std::uint64_t hash_after(Simulation& simulation, int steps) {
  Step last;
  for (int k = 0; k < steps; ++k) last = simulation.step();
  return last.state_hash;
}

template <class Call>
void expect_refused(const Call& call, const std::string& part) {
  try {
    call();
    ADD_FAILURE() << "nothing was thrown for " << part;
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
}

TEST(LibrarySimulation, TheExampleHoldsItsFloe) { EXPECT_LT(std::abs(hold_a_floe()), 0.1); }

TEST(LibrarySimulation, ScenesKnowTheirTimesAndFaults) {
  const Scene scene = Scene::parse(k_balls, "balls.xml", {{"time/@end", "2"}});
  EXPECT_EQ(scene.name(), "balls");
  EXPECT_EQ(scene.end(), 2);
  EXPECT_NE(scene.xml().find("gyroscopic"), std::string::npos) << "defaults are written out";
  expect_refused([] { Scene::parse("<scene version=\"1\"><tme/></scene>", "a.xml"); }, "a.xml:1");
}

TEST(LibrarySimulation, AppliedForceAccelerates) {
  Simulation simulation(balls(), {.applied_loads = true});
  simulation.apply(1, {3, 0, 0});
  const Step step = simulation.step();
  EXPECT_NEAR(simulation.bodies().velocity[3], 3 / 2.0 * 0.01, 1e-15);
  simulation.step();
  EXPECT_NEAR(simulation.bodies().velocity[3], 3 / 2.0 * 0.01, 1e-15) << "a load acts in one step";
  const auto columns = simulation.step_columns();
  ASSERT_EQ(columns.size(), step.numbers.size());
  const auto work = std::find(columns.begin(), columns.end(), "work_applied_J") - columns.begin();
  EXPECT_NEAR(step.numbers.at(static_cast<std::size_t>(work)), 0.5 * 2 * std::pow(3 / 2.0 * 0.01, 2), 1e-15);
}

TEST(LibrarySimulation, AForceAtAPointTurns) {
  Simulation simulation(balls(), {.applied_loads = true});
  simulation.apply(1, {0, 1, 0}, {0, 0, 0}, nilas::Vector3{0.1, 0, 0.3});
  simulation.step();
  const double inertia = 0.4 * 2 * 0.01;
  EXPECT_NEAR(simulation.bodies().angular_velocity[5], 0.1 * 0.01 / inertia, 1e-14);
}

TEST(LibrarySimulation, LoadsOfNothingKeepTheBits) {
  Simulation plain(balls()), loaded(balls(), {.applied_loads = true});
  std::uint64_t last = 0;
  for (int k = 0; k < 40; ++k) {
    loaded.apply(1, {0, 0, 0});
    last = loaded.step().state_hash;
  }
  EXPECT_EQ(hash_after(plain, 40), last);
}

TEST(LibrarySimulation, SnapshotsReturnToTheSameBits) {
  Simulation simulation(balls());
  hash_after(simulation, 10);
  const nilas::Snapshot now = simulation.snapshot();
  const std::uint64_t first = hash_after(simulation, 20);
  simulation.restore(now);
  EXPECT_EQ(simulation.steps(), 10);
  EXPECT_EQ(hash_after(simulation, 20), first);
  Simulation other(Scene::parse(k_balls, "balls.xml", {{"time/@step", "0.005"}}));
  expect_refused([&] { other.restore(now); }, "another scene");
}

TEST(LibrarySimulation, EndsWhereTheSceneEnds) {
  Simulation simulation(balls());
  while (!simulation.is_done()) simulation.step();
  EXPECT_NEAR(simulation.time(), 0.5, 1e-12);
  EXPECT_EQ(simulation.steps(), 50);
}

TEST(LibrarySimulation, LastProblemIsSolvedByItsImpulses) {
  Simulation simulation(balls());
  while (simulation.step().contacts == 0) {
  }
  const nilas::Problem problem = simulation.last_problem();
  ASSERT_GT(problem.num_contacts(), 0);
  EXPECT_EQ(problem.solution(), simulation.last_impulses());
}

TEST(LibrarySimulation, FaultsSayWhatIsAllowed) {
  Simulation simulation(balls());
  expect_refused([&] { simulation.apply(1, {1, 0, 0}); }, "applied_loads");
  expect_refused([&] { simulation.set_command("rudder", 1); }, "nothing to command");
  Simulation loaded(balls(), {.applied_loads = true});
  expect_refused([&] { loaded.apply(3, {1, 0, 0}); }, "allowed: 0 to 2");
  expect_refused([&] { loaded.apply(1, {NAN, 0, 0}); }, "not finite");
}

TEST(LibrarySimulation, AForkedProcessMustBuildItsOwn) {
  Simulation simulation(balls(), {.threads = 2});
  simulation.step();
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    int code = 1;
    try {
      simulation.step();
    } catch (const Error& e) {
      code = std::string(e.what()).find("forked") != std::string::npos ? 0 : 2;
    }
    if (code == 0) {
      Simulation own(balls(), {.threads = 2});
      code = hash_after(own, 5) != 0 ? 0 : 3;
    }
    ::_exit(code);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(LibrarySimulation, WritesARunFolder) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "nilas_library_run";
  std::filesystem::remove_all(folder);
  {
    Simulation simulation(balls());
    nilas::RunWriter writer(simulation, folder);
    while (!simulation.is_done()) {
      simulation.step();
      writer.record();
    }
    expect_refused([&] { writer.record(); }, "once after each step");
    writer.finish();
    expect_refused([&] { nilas::RunWriter(simulation, folder, true); }, "before the first step");
  }
  std::ifstream in(folder / "steps.csv");
  int lines = 0;
  for (std::string line; std::getline(in, line);) ++lines;
  EXPECT_EQ(lines, 51);
  EXPECT_TRUE(std::filesystem::exists(folder / "summary.json"));
  std::filesystem::remove_all(folder);
}

}  // namespace simulation_test
