/// Tests of nilas run --twins, and of the errors that a run states for its mean loads.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/apps/small_scenes.h"
#include "tests/support/mentions.h"
#include "tests/support/program.h"

namespace twins_test {

using namespace nilas_test;
using Json = nlohmann::json;

const std::string k_presawn =
    std::string("'") + NILAS_SOURCE_DIR + "/apps/scenes/presawn-a.xml' --set output/@trajectory_every=0 ";

TEST(Twins, OfAChaoticScenePartAndLeaveTheRunItselfAsItIs) {
  const ScratchFolder folder;
  const std::string run = "run " + k_presawn + "--set contact/@tolerance=1e-2 --until 5 --quiet --out ";
  ASSERT_EQ(run_nilas(run + "alone", folder.path()).exit_code, 0);
  ASSERT_EQ(run_nilas(run + "one --twins 2", folder.path()).exit_code, 0);
  ASSERT_EQ(run_nilas(run + "two --twins 2 --threads 2", folder.path()).exit_code, 0);
  const std::string alone = read_text(folder / "alone/vessel.csv");
  EXPECT_EQ(read_text(folder / "one/vessel.csv"), alone);
  EXPECT_EQ(read_text(folder / "two/vessel.csv"), alone);

  const Json summary = Json::parse(read_text(folder / "one/summary.json"));
  const Json& twins = summary["twins"];
  EXPECT_EQ(twins, Json::parse(read_text(folder / "two/summary.json"))["twins"]) << "whatever the threads";
  EXPECT_EQ(twins["count"], 2);
  EXPECT_EQ(twins["failed"].size(), 0u);
  ASSERT_TRUE(twins["horizon_s"].is_number());
  EXPECT_GT(twins["horizon_s"], 2.0) << "before ice meets the hull nothing grows";
  EXPECT_LT(twins["horizon_s"], 5.0);
  EXPECT_GT(twins["loads"]["contact_fx_N"]["standard_error"], 0.0);
  EXPECT_EQ(summary["load_error"]["runs"], 3);
  EXPECT_EQ(summary["load_error"]["mean_N"], twins["loads"]["ice_resistance_N"]["mean"]);
  const Json own = Json::parse(read_text(folder / "alone/summary.json"));
  EXPECT_EQ(own["loads"], summary["loads"]);
  EXPECT_FALSE(own.contains("twins"));
}

TEST(Twins, OfASceneWithoutChaosStayTogether) {
  const ScratchFolder folder;
  folder.write("box.xml", k_box);
  const auto result = run_nilas("run box.xml --out run --json --twins 2", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json summary = Json::parse(result.out);
  EXPECT_TRUE(summary["twins"]["horizon_s"].is_null());
  EXPECT_NEAR(summary["twins"]["threshold_m"].get<double>(), 1e-4 * std::sqrt(3.0), 1e-12);
  EXPECT_FALSE(summary.contains("load_error")) << "no vessel, no load";
}

/// Perturbed runs stay together until the ice has moved far, and so does the mean load.
TEST(Twins, BeforeTheHorizonTheyShareTheMeanLoad) {
  const ScratchFolder folder;
  const auto result = run_nilas("run " + k_presawn + "--until 2.5 --json --out run --twins 2", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json summary = Json::parse(result.out);
  EXPECT_TRUE(summary["twins"]["horizon_s"].is_null());
  EXPECT_GT(summary["load_error"]["mean_N"], 0) << "the ice pushes astern";
  EXPECT_LT(summary["twins"]["loads"]["contact_fx_N"]["standard_error"].get<double>(), 1e-6);
}

TEST(Twins, TheConsoleSaysWhatTheForceIsWorthAndWhenTwinsPart) {
  const ScratchFolder folder;
  const auto result = run_nilas("run " + k_presawn + "--until 2.5 --out run --twins 1", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(mentions(result.out, "ice load ")) << result.out;
  EXPECT_TRUE(mentions(result.out, "The effect of the time step")) << result.out;
  EXPECT_TRUE(mentions(result.out, "perturbed runs        1, predictable to the end")) << result.out;
}

TEST(Twins, WrongUseIsRefusedPlainly) {
  const ScratchFolder folder;
  folder.write("box.xml", k_box);
  EXPECT_EQ(run_nilas("run box.xml --out run --twins -1", folder.path()).exit_code, 2);
  ASSERT_EQ(run_nilas("run box.xml --out run --quiet --checkpoint-every 0.1 --twins 0", folder.path()).exit_code, 0);
  EXPECT_FALSE(Json::parse(read_text(folder / "run/summary.json")).contains("twins"));
  const auto resumed = run_nilas("run --resume run --until 0.4 --twins 2", folder.path());
  EXPECT_EQ(resumed.exit_code, 2);
  EXPECT_TRUE(mentions(resumed.err, "remove --twins")) << resumed.err;
}

/// Within the predictable time, solvers and tolerances agree within the errors that they state.
TEST(LoadError, CoversWhatSolversDifferFromATightOne) {
  const ScratchFolder folder;
  const auto summary_of = [&](const std::string& flags) {
    const auto result = run_nilas("run " + k_presawn + "--until 3 --json --force --out run " + flags, folder.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(result.out)["load_error"];
  };
  const double exact = summary_of("--solver newton --set contact/@tolerance=1e-10")["mean_N"];
  for (const char* solver : {"auto", "nsgs"})
    for (const char* tolerance : {"1e-2", "1e-3", "1e-4", "1e-5"}) {
      const Json error = summary_of(std::string("--solver ") + solver + " --set contact/@tolerance=" + tolerance);
      const double measured = std::abs(error["mean_N"].get<double>() - exact);
      EXPECT_LE(measured, error["solver_N"]) << solver << " " << tolerance;
      EXPECT_EQ(error["law_N"], 0);
    }
}

}  // namespace twins_test
