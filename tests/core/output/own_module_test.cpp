/// A module of one's own takes part in every phase of a run without a change of the step: it pushes, keeps a state, has
/// a column, closes the energy account and continues from a checkpoint.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "core/output/tables/steps_csv.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/core/output/push_example.h"
#include "tests/support/scratch_folder.h"

namespace {

using namespace nilas;
using namespace nilas::output;

constexpr double k_push = 30, k_mass = 60, k_step = 0.01;
constexpr int k_steps = 10;

sim::ModuleList with_push() {
  sim::ModuleList modules = sim::scene_modules();
  modules.push_back({"push", true, [](const sim::ModuleSources&) -> sim::BuiltModule {
                       return {make_push(Vec3(k_push, 0, 0), k_steps), "the test"};
                     }});
  return modules;
}

class OwnModule : public testing::Test {
 protected:
  sim::Simulation simulation() { return {scene_, 1, warnings_, with_push()}; }

  test::ScratchFolder folder_;
  scene::Scene scene_ =
      scene::read_scene(folder_.write("scene.xml",
                                      "<scene version='1'><gravity value='0 0 0'/><time step='0.01' end='1'/>"
                                      "<body name='box' shape='box' size='1 1 1' mass='60'/></scene>"));
  WarningCounts warnings_{make_logger("off", "")};
};

/// 30 N over 10 steps of 0.01 s give 60 kg the speed 30 * 0.1 / 60 = 0.05 m/s and the energy 60 * 0.05^2 / 2 = 0.075 J.
/// The tolerances are rounding.
TEST_F(OwnModule, PushesAsNewtonSaysAndItsWorkIsBooked) {
  sim::Simulation run = simulation();
  EXPECT_EQ(run.info().modules.back(), (std::pair<std::string, std::string>{"push", "the test"}));
  ASSERT_EQ(run.info().work_names, std::vector<std::string>{"push"});
  sim::StepRecord record;
  for (int k = 0; k < 20; ++k) record = run.step();
  const double speed = k_push / k_mass * k_steps * k_step;
  EXPECT_NEAR(run.bodies().v_GB[0].x(), speed, 1e-14);
  EXPECT_NEAR(record.ledger.works[0], 0.5 * k_mass * speed * speed, 1e-13);
  EXPECT_NEAR(record.ledger.imbalance, 0, 1e-13);
  EXPECT_EQ(record.module_values, std::vector<double>{0});
  EXPECT_EQ(run.total("no such sum"), 0);
}

TEST_F(OwnModule, HasAColumnInTheTableOfSteps) {
  sim::Simulation run = simulation();
  StepsCsv table(folder_ / "steps.csv", run.info());
  for (int k = 0; k < 3; ++k) table.row(run.step());
  EXPECT_EQ(run.total("push_steps_left"), k_steps - 3);
  table.finish();
  std::ifstream in(folder_ / "steps.csv");
  std::string header, row;
  std::getline(in, header);
  std::getline(in, row);
  const auto place = static_cast<std::size_t>(
      std::count(header.begin(), header.begin() + static_cast<std::ptrdiff_t>(header.find("push_steps_left_1")), ','));
  std::size_t start = 0;
  for (std::size_t k = 0; k < place; ++k) start = row.find(',', start) + 1;
  EXPECT_EQ(std::stod(row.substr(start)), k_steps - 1);
  EXPECT_NE(header.find("work_push_J"), std::string::npos);
}

TEST_F(OwnModule, ContinuesFromACheckpoint) {
  sim::Simulation whole = simulation(), first = simulation(), rest = simulation();
  for (int k = 0; k < 5; ++k) first.step();
  State state;
  first.save(StateWriter(state));
  rest.restore(StateReader(state));
  sim::StepRecord of_whole, of_rest;
  for (int k = 0; k < 20; ++k) of_whole = whole.step();
  for (int k = 5; k < 20; ++k) of_rest = rest.step();
  EXPECT_EQ(of_rest.state_hash, of_whole.state_hash);
  EXPECT_EQ(of_rest.module_values, of_whole.module_values);
}

TEST_F(OwnModule, IsNotThereWhereNobodyListsIt) {
  sim::Simulation plain(scene_, 1, warnings_);
  EXPECT_TRUE(plain.info().module_columns.empty());
  EXPECT_TRUE(plain.info().work_names.empty());
}

}  // namespace
