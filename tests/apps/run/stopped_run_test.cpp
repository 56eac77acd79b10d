/// Runs that stop and go on: which steps have their load checked, and what a run says that cannot go on.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <thread>

#include "tests/apps/small_scenes.h"
#include "tests/support/mentions.h"
#include "tests/support/started_program.h"

namespace stopped_run_test {

using namespace nilas_test;

nlohmann::json summary_of(const fs::path& run) { return nlohmann::json::parse(read_text(run / "summary.json")); }

/// A run of 90 steps with nine checks has one in 10 steps, and goes on so when it is resumed to 100 steps. So does a
/// run of 100 steps from the start with ten checks. With nine it would have one in 12. Ice touches from step 70 on.
TEST(StoppedRun, WithALaterEndKeepsTheStepsWhoseLoadIsChecked) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  const auto demand = [&](const std::string& arguments) {
    const ProgramResult result = run_nilas("run --quiet --checkpoint-every 0.1 " + arguments, folder.path());
    ASSERT_EQ(result.exit_code, 0) << result.err;
  };
  demand("ship.xml --out whole --set output/@load_checks=10");
  demand("ship.xml --out short --until 0.9 --set output/@load_checks=9");
  const auto early = summary_of(folder.path() / "short")["step_load_error"];
  EXPECT_EQ(early["every_steps"], 10) << early;
  demand("--resume short --until 1");
  const auto whole = summary_of(folder.path() / "whole")["step_load_error"],
             resumed = summary_of(folder.path() / "short")["step_load_error"];
  EXPECT_EQ(resumed["every_steps"], 10) << resumed;
  EXPECT_GT(early["checked_steps"].get<int>(), 0) << "both parts are to have checks";
  EXPECT_GT(resumed["checked_steps"].get<int>(), early["checked_steps"].get<int>());
  EXPECT_EQ(resumed, whole);
  EXPECT_EQ(Table(folder.path() / "short/steps.csv").text("state_hash"),
            Table(folder.path() / "whole/steps.csv").text("state_hash"));
}

/// Stops the run by Ctrl-C once `begun` holds, and returns its summary.
nlohmann::json stopped(const ScratchFolder& folder, const std::function<bool()>& begun) {
  Started run("run scene.xml --out run", folder.path());
  while (run.runs() && !begun()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  EXPECT_EQ(run.stop(SIGINT), 130) << read_text(folder.path() / "err.txt");
  EXPECT_FALSE(fs::exists(folder.path() / "run/checkpoint.h5"));
  const auto summary = summary_of(folder.path() / "run");
  EXPECT_EQ(summary["status"], "interrupted");
  return summary;
}

/// The account breaks its lines.
std::string on_one_line(const std::string& text) { return std::regex_replace(text, std::regex("\\s+"), " "); }

void expect_cannot_go_on(const ScratchFolder& folder, const std::string& why) {
  const std::string said = read_text(folder.path() / "err.txt"),
                    account = on_one_line(read_text(folder.path() / "out.txt"));
  const std::string sentence = "The run cannot be resumed: " + why;
  EXPECT_TRUE(mentions(said, sentence)) << said;
  EXPECT_TRUE(mentions(account, sentence)) << account;
  const ProgramResult again = run_nilas("run --resume run", folder.path());
  EXPECT_EQ(again.exit_code, 4);
  EXPECT_TRUE(mentions(again.err, "checkpoint.h5: not found")) << again.err;
}

TEST(StoppedRun, OfTheReferenceIntegratorSaysThatItHasNoCheckpoints) {
  const ScratchFolder folder;
  folder.write("scene.xml", R"(<scene version="1" name="ball">
  <time step="0.001" end="10000"/>
  <contact solver="newton" tolerance="1e-9" integrator="reference"><friction between="* *" kinetic="0.3"/></contact>
  <body name="ground" shape="plane" fixed="true"/>
  <body name="ball" shape="sphere" radius="0.1" mass="2" position="0 0 0.1" velocity="1 0 0"/>
</scene>
)");
  const fs::path steps = folder.path() / "run/steps.csv";
  EXPECT_GT(stopped(folder, [&] { return lines_of(steps).size() >= 5; })["steps"].get<long>(), 0);
  expect_cannot_go_on(folder, "the reference integrator has no checkpoints.");
}

/// It stops within its first step, which no checkpoint may hold.
TEST(StoppedRun, ThatWaitsForAControllerSaysThatItHasNoCheckpoint) {
  const ScratchFolder folder;
  std::string scene = k_ship;
  const std::string carriage = "<carriage speed=\"0.5\" ramp=\"0.05\"/>";
  scene.replace(scene.find(carriage), carriage.size(),
                "<remote_control socket=\"ship.socket\" timeout=\"600\" force=\"true\"/>");
  folder.write("scene.xml", scene);
  const fs::path socket = folder.path() / "ship.socket";
  EXPECT_EQ(stopped(folder, [&] { return fs::exists(socket); })["steps"].get<long>(), 0);
  expect_cannot_go_on(folder, "it has no checkpoint; --checkpoint-every SECONDS writes some on the way.");
}

}  // namespace stopped_run_test
