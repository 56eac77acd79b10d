/// The ice load of a step beside that of a second solution, on a row of floes whose pressure is known.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/core/sim/scene_rig.h"

namespace load_check_test {

using namespace nilas;

constexpr int k_floes = 40;
constexpr double k_side = 0.5, k_thickness = 0.1, k_density = 900, k_pull = 0.05, k_step = 0.01;  // [m, kg/m3, m/s2, s]
/// At rest the wall bears what pulls all floes [N].
constexpr double k_load = k_floes * k_side * k_side * k_thickness * k_density * k_pull;

/// Square floes in a row that a steady acceleration along x pulls against a wall, from rest.
std::string row(const std::string& contact, const std::string& output) {
  std::string floes;
  for (int k = 0; k < k_floes; ++k) {
    const std::string x0 = test::text(-(k + 1) * k_side), x1 = test::text(-k * k_side), y = test::text(0.5 * k_side);
    floes += "<floe outline='" + x0 + " -" + y + " " + x1 + " -" + y + " " + x1 + " " + y + " " + x0 + " " + y + "'/>";
  }
  return test::steps_of(k_step) + "<gravity value='" + test::text(k_pull) + " 0 0'/><contact law='coulomb' " + contact +
         " stabilisation='none' integrator='semi-implicit-euler'><friction between='* *' kinetic='0.3'/></contact>" +
         "<ice density='" + test::text(k_density) + "' thickness='" + test::text(k_thickness) + "'>" + floes +
         "</ice><body name='wall' shape='box' size='1 2 1' position='0.5 0 0' fixed='true'/><output " + output + "/>";
}

const std::string k_sweeps = "solver='nsgs' tolerance='0' max_iterations='10' warm_start='false'";
/// The scene ends after 100000 steps, so this checks each of them.
const std::string k_each = "load_checks='1000000'";

double error_of(const sim::LoadCheck& check) { return (check.load.at(0) - check.strict.at(0)).norm(); }

/// From no impulses a sweep carries pressure by about one floe, so that ten sweeps build a small part of it. The floes
/// have moved by at most k_pull k_step meanwhile, which bounds the residual.
TEST(LoadCheck, ShowsThePressureThatSweepsHaveNotBuilt) {
  test::SceneRig rig(row(k_sweeps, k_each));
  const sim::StepRecord record = rig.simulation.step();
  ASSERT_TRUE(record.load_check.has_value());
  ASSERT_EQ(record.load_check->strict.size(), 1u);
  EXPECT_TRUE(record.load_check->is_strict);
  EXPECT_LE(record.residuals.law_map_m_s, k_pull * k_step) << "the residual is small";
  EXPECT_LT((record.load_check->strict[0] - Vec3(k_load, 0, 0)).norm(), 1e-3 * k_load);
  EXPECT_GT(error_of(*record.load_check), 0.4 * k_load) << "and the load is not there";
  EXPECT_LT((record.load_check->load[0] - record.structures.at(0).ice).norm(), 1e-14 * k_load) << "of structures.csv";
}

TEST(LoadCheck, IsExactForAnExactSolution) {
  test::SceneRig rig(row("solver='auto' tolerance='1e-9'", k_each));
  for (int k = 0; k < 3; ++k) {
    const sim::StepRecord record = rig.simulation.step();
    ASSERT_TRUE(record.load_check.has_value());
    EXPECT_TRUE(record.load_check->is_strict);
    EXPECT_LT(error_of(*record.load_check), 1e-9 * k_load) << "the guess meets 1e-8 m/s, so that it stays";
    EXPECT_LT((record.load_check->load[0] - Vec3(k_load, 0, 0)).norm(), 1e-3 * k_load);
  }
}

/// One floe slides along the wall at equal speeds on both axes of its contact. The pyramid lets both bear the whole
/// friction, the cone only their resultant.
TEST(LoadCheck, ComparesAPyramidWithTheConeThatItStandsFor) {
  constexpr double friction = 0.1;
  test::SceneRig rig(
      "<time step='0.01' end='1000'/><gravity value='0.05 0 0'/>"
      "<contact law='pyramid' solver='auto' tolerance='1e-10' stabilisation='none' "
      "integrator='semi-implicit-euler'><friction between='* *' kinetic='0.1'/></contact>"
      "<ice density='900' thickness='0.1'>"
      "<floe outline='-0.5 -0.25 0 -0.25 0 0.25 -0.5 0.25' velocity='0 0.1 0.1'/></ice>"
      "<body name='wall' shape='box' size='1 2 1' position='0.5 0 0' fixed='true'/>"
      "<output load_checks='1000000'/>");
  const sim::LoadCheck check = rig.simulation.step().load_check.value();
  const double load = k_load / k_floes;
  EXPECT_TRUE(check.is_strict);
  EXPECT_NEAR(check.load[0].x(), load, 1e-3 * load);
  EXPECT_NEAR(check.strict[0].x(), load, 1e-3 * load);
  EXPECT_NEAR(error_of(check), friction * load * (std::sqrt(2) - 1), 1e-3 * load);
}

TEST(LoadCheck, LeavesTheMotionAsItIsForAnyNumberOfThreads) {
  test::SceneRig without(row(k_sweeps, "load_checks='0'")), with(row(k_sweeps, k_each)),
      on_threads(row(k_sweeps, k_each), 2);
  for (int k = 0; k < 5; ++k) {
    const sim::StepRecord plain = without.simulation.step(), checked = with.simulation.step(),
                          threaded = on_threads.simulation.step();
    EXPECT_FALSE(plain.load_check.has_value());
    EXPECT_EQ(plain.state_hash, checked.state_hash);
    EXPECT_EQ(plain.state_hash, threaded.state_hash);
    EXPECT_EQ(checked.load_check.value().strict, threaded.load_check.value().strict);
  }
}

TEST(LoadCheck, ComesByDefaultInOneStepOfAHundredWhereARigidContactHasFriction) {
  const auto checks = [](const std::string& from, const std::string& to, int steps) {
    std::string scene = row(k_sweeps, "");
    const auto place = scene.find(from);
    scene.replace(place, from.size(), to);
    test::SceneRig rig(scene);
    std::vector<int> checked;
    for (int k = 1; k <= steps; ++k)
      if (rig.simulation.step().load_check) checked.push_back(k);
    return std::pair(rig.simulation.info().check_every, checked);
  };
  const auto [every, checked] = checks("end='1000'", "end='5'", 160);
  EXPECT_EQ(every, 100);
  EXPECT_EQ(checked, (std::vector{50, 150}));
  EXPECT_EQ(checks("end='1000'", "end='100'", 1).first, 200) << "50 of 10000 steps";
  EXPECT_EQ(checks("kinetic='0.3'", "kinetic='0'", 1).first, 0);
  EXPECT_EQ(checks("kinetic='0.3'", "kinetic='0.3' elastic='true' stiffness='1e6'", 1).first, 0);
  EXPECT_EQ(checks("fixed='true'", "mass='10'", 1).first, 0) << "nothing bears a load";
}

}  // namespace load_check_test
