/// Runs every shipped scene briefly through the program: no NaN, momentum, penetration, same bits on every run.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace shipped_scenes_test {

using namespace nilas_test;

struct Case {
  const char* scene;
  double until;      ///< End of the run [s].
  double thickness;  ///< Thickness of the ice [m].
  double deepest;    ///< Largest penetration over the thickness [-].
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.scene; }

class ShippedScene : public ::testing::TestWithParam<Case> {};

/// Runs the scene and checks each of its steps. The residual of the energy ledger is rounding compared with the
/// exchanged energy.
void expect_invariants(const Case& c, const std::string& words, double until) {
  const ScratchFolder folder;
  const auto result = run_nilas(
      "run '" + shipped_scene(c.scene).string() + "' --quiet --out run " + words + "--until " + std::to_string(until),
      folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Table steps(folder.path() / "run" / "steps.csv");
  ASSERT_GT(steps.rows(), 10u);
  double touching = 0;
  for (std::size_t i = 0; i < steps.rows(); ++i) {
    for (const auto& name : steps.header()) {
      const bool text = name == "status" || name == "state_hash";
      ASSERT_TRUE(text || std::isfinite(steps[name][i])) << name << " row " << i;
    }
    EXPECT_LE(steps["momentum_imbalance_Ns"][i], 1e-9 * steps["momentum_scale_Ns"][i]) << "row " << i;
    EXPECT_LE(steps["angular_momentum_imbalance_Nms"][i], 1e-9 * steps["angular_momentum_scale_Nms"][i]) << "row " << i;
    EXPECT_LT(steps["penetration_max_m"][i], c.deepest * c.thickness) << "row " << i;
    EXPECT_LT(steps["penetration_mean_m"][i], 0.005 * c.thickness) << "row " << i;
    touching = std::max(touching, steps["contacts"][i]);
  }
  EXPECT_GT(touching, 0) << "the scene never made a contact, so it tests nothing";
  const std::size_t last = steps.rows() - 1;
  double scale = std::abs(steps["kinetic_J"][0]) + std::abs(steps["potential_J"][0]);
  for (const auto& name : steps.header())
    if (name.rfind("work_", 0) == 0) scale += std::abs(steps[name][last]);
  EXPECT_LE(std::abs(steps["imbalance_J"][last]), 1e-10 * scale);
}

TEST_P(ShippedScene, KeepsItsInvariants) { expect_invariants(GetParam(), "", GetParam().until); }

INSTANTIATE_TEST_SUITE_P(
    All, ShippedScene,
    ::testing::Values(Case{"towing.xml", 4, 0.04, 0.05}, Case{"metrikin-2014.xml", 4, 0.04, 0.05},
                      Case{"presawn-a.xml", 4, 0.04, 0.01}, Case{"presawn-b.xml", 4, 0.04, 0.01},
                      Case{"presawn-c.xml", 3, 0.04, 0.01}, Case{"mirror-25.xml", 3, 0.05, 0.05},
                      Case{"oblique-towing.xml", 4, 0.04, 0.05}, Case{"dense-95.xml", 2, 0.04, 0.005},
                      Case{"level-ice.xml", 4.5, 0.04, 0.05}, Case{"ship-100m.xml", 30, 1, 0.05},
                      Case{"propeller-wash.xml", 3, 0.04, 0.01}, Case{"free-running.xml", 20, 0.8, 0.05},
                      Case{"waves-at-the-edge.xml", 6, 0.6, 0.05}, Case{"moored.xml", 10, 1, 0.05},
                      Case{"dp-drift.xml", 60, 0.8, 0.05}, Case{"dp-large-floes.xml", 60, 2, 0.05}),
    [](const auto& instance) {
      std::string name = instance.param.scene;
      for (auto& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
      return name;
    });

/// All shipped scenes but this one have Moreau's scheme, and one with the other shows that it holds too.
TEST(ShippedSceneOfTheOtherIntegrator, KeepsItsInvariants) {
  expect_invariants({"metrikin-2014.xml", 3, 0.04, 0.05}, "--set contact/@integrator=moreau ", 3);
  expect_invariants({"towing.xml", 3, 0.04, 0.05}, "--set contact/@integrator=semi-implicit-euler ", 3);
}

class SameBitsOf : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(SameBitsOf, OneAndTwoThreadsAndTwice) {
  const ScratchFolder folder;
  const auto& [file, integrator] = GetParam();
  const std::string scene =
      "run '" + shipped_scene(file).string() + "' --quiet --until 3 --set contact/@integrator=" + integrator + " ";
  ASSERT_EQ(run_nilas(scene + "--out one --threads 1", folder.path()).exit_code, 0);
  ASSERT_EQ(run_nilas(scene + "--out two --threads 2", folder.path()).exit_code, 0);
  ASSERT_EQ(run_nilas(scene + "--out again --threads 2", folder.path()).exit_code, 0);
  const Table one(folder.path() / "one/steps.csv"), two(folder.path() / "two/steps.csv"),
      again(folder.path() / "again/steps.csv");
  EXPECT_EQ(one.text("state_hash"), two.text("state_hash"));
  EXPECT_EQ(two.text("state_hash"), again.text("state_hash"));
  EXPECT_EQ(read_text(folder.path() / "one/vessel.csv"), read_text(folder.path() / "two/vessel.csv"));
}

INSTANTIATE_TEST_SUITE_P(Integrators, SameBitsOf,
                         ::testing::Values(std::pair("towing.xml", "semi-implicit-euler"),
                                           std::pair("oblique-towing.xml", "moreau")));

TEST(SameBits, TheSceneAsRunRunsAgainToTheSameBits) {
  const ScratchFolder folder;
  const std::string scene = shipped_scene("mirror-25.xml").string();
  ASSERT_EQ(run_nilas("run '" + scene + "' --quiet --until 1 --out one", folder.path()).exit_code, 0);
  const auto again = run_nilas("run one/scene.xml --quiet --out two", folder.path());
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(Table(folder.path() / "one/steps.csv").text("state_hash"),
            Table(folder.path() / "two/steps.csv").text("state_hash"));
}

}  // namespace shipped_scenes_test
