/// `nilas compare` on scenes whose errors are known.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/compare_scenes.h"

namespace compare_known_test {

using namespace nilas_test;

TEST(Compare, ShowsTheKnownErrorOfThePyramid) {
  const ScratchFolder folder;
  // 2 m/s at 30 degrees to the tangents, mu 0.3
  const auto result = run_nilas(block("--laws coulomb,pyramid --integrators moreau "
                                      "--set \"body[@name='block']/@velocity=1.7320508075688772 1 0\""),
                                folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Table runs(folder.path() / "out/compare.csv");
  std::map<std::string, std::size_t> row;
  for (std::size_t k = 0; k < runs.rows(); ++k)
    if (runs.text("kind")[k] == "grid" && runs.text("integrator")[k] == "moreau") row[runs.text("law")[k]] = k;
  ASSERT_EQ(row.size(), 2U);
  // Two boxes stop each axis by itself: v_x^2 and v_y^2 over 2 mu g instead of the distance along the velocity.
  const double way = 2 * 2 / (2 * 0.3 * 9.81);
  EXPECT_NEAR(runs["motion_x_m"][row["pyramid"]], way * (std::sqrt(0.75) - 0.75), 1e-3 * way);
  EXPECT_NEAR(runs["motion_y_m"][row["pyramid"]], way * (0.5 - 0.25), 1e-3 * way);
  EXPECT_LT(runs["motion_largest_m"][row["coulomb"]], 1e-4);
}

TEST(Compare, ShowsTheKnownGapOfTheConvexCone) {
  const ScratchFolder folder;
  // slow enough that gravity brings the block back within a step: mu v < g h
  const double speed = 0.3;
  const auto result = run_nilas(block("--laws coulomb,ccp --until 0.3 --set contact/@integrator=semi-implicit-euler "
                                      "--set \"body[@name='block']/@velocity=0.3 0 0\""),
                                folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Table runs(folder.path() / "out/compare.csv");
  double gap = 0;
  for (std::size_t k = 0; k < runs.rows(); ++k)
    if (runs.text("law")[k] == "ccp") gap = runs["motion_z_m"][k];
  // h mu v, v being the speed after the first step, whose friction takes mu (g h + mu v) of it
  const double h = 0.01, mu = 0.3, after = (speed - mu * 9.81 * h) / (1 + mu * mu);
  EXPECT_NEAR(gap, h * mu * after, 1e-9);
}

TEST(Compare, FindsFirstOrderOfABlockThatSlides) {
  const ScratchFolder folder;
  const auto result =
      run_nilas(block("--dt 0.02,0.01,0.005,0.0025 --set contact/@integrator=semi-implicit-euler"), folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = json_of(folder.path() / "out/compare.json");
  ASSERT_EQ(json["orders"].size(), 1U);
  EXPECT_NEAR(json["orders"][0]["order"].get<double>(), 1, 0.05);
  EXPECT_EQ(json["measure"], "distance");
}

/// Orders and errors of the settings and of the rows of `nilas verify`, by integrator; errors at the finest step.
struct Agreement {
  std::map<std::string, double> compared, verified, compared_error, verified_error;
  double ratio(std::map<std::string, double> Agreement::*errors) const {
    return (this->*errors).at("semi-implicit-euler") / (this->*errors).at("moreau");
  }
};

Agreement orders_of(const std::string& scene, const std::string& flags, const std::string& verify_case) {
  const ScratchFolder folder;
  const auto result = run_nilas("compare '" + shipped_scene("verify/" + scene).string() +
                                    "' --integrators semi-implicit-euler,moreau --seeds 1 --out out --quiet " + flags,
                                folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  Agreement found;
  const auto json = json_of(folder.path() / "out/compare.json");
  for (const auto& order : json["orders"]) {
    const std::string label = order["of"];
    found.compared[label == "own setting" ? "moreau" : label] = order["order"];
  }
  const Table settings(folder.path() / "out/settings.csv");
  double finest = 1;
  for (std::size_t k = 0; k < settings.rows(); ++k) finest = std::min(finest, settings["step_s"][k]);
  const std::string error = json["unit"] == "rad" ? "error_rad" : "error_m";
  for (std::size_t k = 0; k < settings.rows(); ++k)
    if (settings["step_s"][k] == finest) found.compared_error[settings.text("integrator")[k]] = settings[error][k];
  const auto verified = run_nilas("verify --case " + verify_case + " --json", folder.path());
  EXPECT_EQ(verified.exit_code, 0) << verified.err;
  const auto table = nlohmann::json::parse(verified.out);
  for (const auto& row : table["rows"])
    if (row["order"].is_number() && row["input"] == "as given") {
      found.verified[row["integrator"]] = row["order"];
      found.verified_error[row["integrator"]] = row["error"];
    }
  return found;
}

TEST(Compare, FindsTheOrdersAndRanksThatVerifyHolds) {
  const Agreement top = orders_of("top.xml", "--dt 0.08,0.04,0.02,0.01", "C27");
  const Agreement pendulum = orders_of("pendulum.xml", "--dt 0.02,0.01,0.005,0.0025 --until 1", "C31");
  for (const Agreement& found : {top, pendulum}) {
    ASSERT_EQ(found.compared.size(), 2U);
    for (const auto& [integrator, order] : found.compared)
      EXPECT_NEAR(order, found.verified.at(integrator), 0.1) << integrator;
    EXPECT_GT(found.ratio(&Agreement::compared_error), 1);
    EXPECT_GT(found.ratio(&Agreement::verified_error), 1);
  }
  // errors of the attitude grow as those of the spin, whatever the step
  EXPECT_NEAR(top.ratio(&Agreement::compared_error) / top.ratio(&Agreement::verified_error), 1, 0.02);
}

TEST(Compare, ShowsTheEnergyThatTheSplitImpulseLiftsWith) {
  const ScratchFolder folder;
  const double depth = 1e-3, mass = 2, erp = 0.2, h = 0.01, weight = mass * 9.81;
  const auto result = run_nilas(block("--stabilisations none,split-impulse,projection --until 0.1 "
                                      "--set \"body[@name='block']/@velocity=0 0 0\" "
                                      "--set \"body[@name='block']/@position=0 0 0.099\""),
                                folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Table runs(folder.path() / "out/compare.csv");
  std::map<std::string, double> lifted;
  for (std::size_t k = 0; k < runs.rows(); ++k)
    if (runs.text("kind")[k] == "grid") lifted[runs.text("stabilisation")[k]] = runs["stabilisation_J"][k];
  const double left = depth * std::pow(1 - erp, std::round(0.1 / h));
  EXPECT_EQ(lifted.at("none"), 0);
  // pseudo velocities are solved to 1e-3 m/s
  EXPECT_NEAR(std::abs(lifted.at("split-impulse")), weight * (depth - left), weight * 1e-3 * h);
  EXPECT_NEAR(std::abs(lifted.at("projection")), weight * depth, 1e-9);
}

TEST(Compare, AblationShowsTheMissingGyroscopicTorqueAndNothingElseOfAFreeTop) {
  const ScratchFolder folder;
  const auto result = run_nilas(
      "compare '" + shipped_scene("verify/top.xml").string() + "' --ablate --until 2 --seeds 1 --out out --quiet",
      folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Table settings(folder.path() / "out/settings.csv");
  auto row = rows_by(settings, "label");
  ASSERT_TRUE(row.count("no gyroscopic torque"));
  EXPECT_GT(settings["turn_rad"][row["no gyroscopic torque"]], 0.1);
  for (const char* other : {"pyramid", "split impulse", "discrete detection", "FCL's contacts", "50 sweeps"})
    EXPECT_EQ(settings["turn_rad"][row[other]], 0) << other;
  EXPECT_FALSE(row.count("prismatic joint"));
  EXPECT_GT(fs::file_size(folder.path() / "out/ablation.svg"), 1000U);
}

TEST(Compare, OfATowedShipTurnsOnEverySimplification) {
  const ScratchFolder folder;
  folder.write("ship.xml", k_ship);
  const auto result = run_nilas("compare ship.xml --ablate --seeds 2 --out out --quiet", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Table settings(folder.path() / "out/settings.csv");
  EXPECT_EQ(settings.rows(), 10U);
  for (std::size_t k = 0; k < settings.rows(); ++k) EXPECT_EQ(settings["done"][k], 2) << settings.text("label")[k];
  auto row = rows_by(settings, "label");
  const std::size_t together = settings.rows() - 1;
  for (const std::size_t changed : {row.at("pyramid"), together})
    EXPECT_NE(settings["load_difference_N"][changed], 0) << settings.text("label")[changed];
}

}  // namespace compare_known_test
