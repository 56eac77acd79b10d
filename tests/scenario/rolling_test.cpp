/// A ball that rolls and one that spins on the ground: from the scene file to the energy ledger.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace rolling_test {

using namespace nilas_test;

TEST(Rolling, ABallSlowsDownAndTheLedgerCloses) {
  const ScratchFolder folder;
  folder.write("ball.xml", R"(<scene version="1" name="ball">
  <time step="0.01" end="1"/>
  <contact law="coulomb" solver="auto" tolerance="1e-12">
    <friction between="structure structure" static="0.4" kinetic="0.4" rolling="0.02" spinning="0.03"/>
  </contact>
  <body name="ground" shape="plane" fixed="true"/>
  <body name="ball" shape="sphere" radius="0.5" mass="2" position="0 0 0.5" velocity="2 0 0" angular_velocity="0 4 7"/>
  <output bodies="true" trajectory_every="0.01"/>
</scene>
)");
  const auto result = run_nilas("run ball.xml --out run --json", folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Table bodies(folder.path() / "run/bodies.csv");
  const double rolled = 5.0 / 7 * 0.02 / 0.5 * 9.81, spun = 0.03 * 2 * 9.81 / (0.4 * 2 * 0.25);
  const std::size_t last = bodies.rows() - 1;
  EXPECT_NEAR(bodies["time_s"][last], 1, 1e-12);
  EXPECT_NEAR(bodies["vx_m_s"][last], 2 - rolled, 1e-9);
  EXPECT_NEAR(bodies["wy_rad_s"][last], (2 - rolled) / 0.5, 1e-9);
  EXPECT_NEAR(bodies["wz_rad_s"][last], 7 - spun, 1e-9);
  const auto worst = nlohmann::json::parse(result.out)["worst"];
  EXPECT_LE(std::abs(worst["imbalance_J"]["value"].get<double>()), 1e-12);
  EXPECT_LE(worst["angular_momentum_imbalance_relative"]["value"].get<double>(), 1e-12);
  // The two frictions dissipate the energy that the ball loses.
  const Table steps(folder.path() / "run/steps.csv");
  const double inertia = 0.4 * 2 * 0.25;
  const double before = 0.5 * 2 * 4 + 0.5 * inertia * (16 + 49);
  EXPECT_NEAR(steps["friction_J"].back(), before - steps["kinetic_J"].back(), 1e-10);
  EXPECT_EQ(steps["contacts"].back(), 1);
}

TEST(Rolling, SolversAndOutputsThatCannotTakeItAreRefused) {
  const ScratchFolder folder;
  folder.write("ball.xml", R"(<scene version="1" name="ball">
  <contact law="coulomb" solver="newton">
    <friction between="structure structure" static="0.4" kinetic="0.4" spinning="0.02"/>
  </contact>
  <body name="ground" shape="plane" fixed="true"/>
  <body name="ball" shape="sphere" radius="0.5" mass="2" position="0 0 0.5"/>
</scene>
)");
  const auto solver = run_nilas("check ball.xml", folder.path());
  EXPECT_EQ(solver.exit_code, 2);
  EXPECT_NE(solver.err.find("nsgs"), std::string::npos) << solver.err;
  EXPECT_EQ(run_nilas("check ball.xml --solver auto", folder.path()).exit_code, 0);
  EXPECT_EQ(run_nilas("check ball.xml --solver auto --law ccp", folder.path()).exit_code, 2);
  EXPECT_EQ(run_nilas("check ball.xml --solver auto --set output/@problems=worst", folder.path()).exit_code, 2);
}

}  // namespace rolling_test
