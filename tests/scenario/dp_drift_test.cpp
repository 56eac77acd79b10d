/// The shipped supply vessel in drifting ice, through the whole program: as shipped, after a blackout, with a drift
/// that turns, and over threads.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace dp_drift_test {

using namespace nilas_test;

/// The shipped scene with one text in place of another.
std::string changed_scene(const std::string& old_text, const std::string& new_text) {
  std::string text = read_text(shipped_scene("dp-drift.xml"));
  const auto at = text.find(old_text);
  EXPECT_NE(at, std::string::npos) << old_text;
  return at == std::string::npos ? text : text.replace(at, old_text.size(), new_text);
}

class DpDrift : public ::testing::Test {
 protected:
  /// Runs a scene and returns the figures of positioning.
  nlohmann::json figures_of(const std::string& scene) const {
    folder_.write("scene.xml", scene);
    const auto result = run_nilas("run scene.xml --quiet --threads 1 --out run --force", folder_.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return nlohmann::json::parse(read_text(folder_.path() / "run/summary.json")).at("figures").at("control");
  }
  ScratchFolder folder_;
};

/// Noise of 0.1 m and the ice move the vessel by centimetres: 0.043 m rms and 0.12 m at most were measured.
void expect_station_kept(const nlohmann::json& figures) {
  EXPECT_EQ(figures.at("alarms").get<double>(), 0);
  EXPECT_LT(figures.at("offset_max_m").get<double>(), 0.5);
  EXPECT_LT(figures.at("offset_rms_m").get<double>(), 0.1);
  EXPECT_LT(figures.at("heading_error_max_deg").get<double>(), 0.5);
  EXPECT_GT(figures.at("thrust_use_1").get<double>(), 0.001);
  EXPECT_LT(figures.at("saturation_share_1").get<double>(), 0.01);
}

TEST_F(DpDrift, KeepsItsStation) {
  const auto figures = figures_of(read_text(shipped_scene("dp-drift.xml")));
  expect_station_kept(figures);
  EXPECT_NEAR(figures.at("time_s").get<double>(), 300, 1e-6);
  const Table steps(folder_.path() / "run/steps.csv");
  double touching = 0;
  for (std::size_t i = 0; i < steps.rows(); ++i) touching = std::max(touching, steps["contacts"][i]);
  EXPECT_GT(touching, 3);
}

/// The foremost tunnel fails at 60 s: ten time constants later nothing is left of its thrust, and the others hold on.
TEST_F(DpDrift, KeepsItsStationAfterABlackout) {
  const auto figures = figures_of(changed_scene("<thruster name=\"bow1\"", "<thruster name=\"bow1\" fails_at=\"60\""));
  expect_station_kept(figures);
  const Table steps(folder_.path() / "run/steps.csv");
  double before = 0, after = 0;
  for (std::size_t i = 0; i < steps.rows(); ++i) {
    const double thrust = std::abs(steps["thruster_bow1_N"][i]);
    if (steps["time_s"][i] < 60) before = std::max(before, thrust);
    if (steps["time_s"][i] > 70) after = std::max(after, thrust);
  }
  EXPECT_GT(before, 1e3);
  EXPECT_LT(after, 1e-4 * before);
}

/// The current, and with it the ice, turns from 0.2 m/s astern to 0.22 m/s ahead and to port within a minute.
TEST_F(DpDrift, KeepsItsStationWhereTheDriftTurns) {
  folder_.write("drift.csv", "t_s,u_m_s,v_m_s\n0,-0.2,0\n120,-0.2,0\n180,0.2,0.1\n");
  expect_station_kept(figures_of(changed_scene("<current velocity=\"-0.2 0 0\"/>", "<current series=\"drift.csv\"/>")));
}

TEST_F(DpDrift, GivesTheSameBitsForOneAndTwoThreads) {
  const std::string run = "run '" + shipped_scene("dp-drift.xml").string() + "' --quiet --until 40 ";
  ASSERT_EQ(run_nilas(run + "--out one --threads 1", folder_.path()).exit_code, 0);
  ASSERT_EQ(run_nilas(run + "--out two --threads 2", folder_.path()).exit_code, 0);
  EXPECT_EQ(Table(folder_.path() / "one/steps.csv").text("state_hash"),
            Table(folder_.path() / "two/steps.csv").text("state_hash"));
}

}  // namespace dp_drift_test
