/// A module of one's own takes part in every phase of a run without a change of the step: it pushes, keeps a state, has
/// a column, closes the energy account and continues from a checkpoint.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>

#include "core/base/error.h"
#include "core/output/loads/ice_load_json.h"
#include "core/output/loads/run_statistics.h"
#include "core/output/tables/steps_csv.h"
#include "core/output/tables/vessel_channels.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/core/output/push_example.h"
#include "tests/core/sim/scene_rig.h"
#include "tests/support/scratch_folder.h"

namespace own_module_test {

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
  EXPECT_EQ(run.total(bodies::k_brash_mass), 0) << "a sum of modules that this scene has not";
  EXPECT_THROW(run.total("brash_mas"), ContractError);
  EXPECT_EQ(run.of_body(bodies::k_damage, run.bodies().id[0]), 0);
  EXPECT_THROW(run.of_body("damages", run.bodies().id[0]), ContractError);
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

/// A tug pulls every body, the vessel too, 2 m above its centre of mass.
class Tug : public bodies::ForceModule {
 public:
  std::string name() const override { return "tug"; }
  std::optional<Vec3> drift() const override { return Vec3::Zero(); }
  void add_forces(const bodies::Bodies& /*bodies*/, double /*t*/, bodies::Wrenches& out) override {
    for (auto& load : out) load += {Vec3(k_push, 0, 0), Vec3(0, 2 * k_push, 0)};
  }
};

sim::ModuleList with_tug() {
  sim::ModuleList modules = sim::scene_modules();
  modules.push_back({"tug", true, [](const sim::ModuleSources&) -> sim::BuiltModule {
                       return {std::make_unique<Tug>(), "the test"};
                     }});
  return modules;
}

/// The pull is a load of its own in vessel.csv, with time steps and between events. It is no load of the water: within
/// a step the hull's fore end reaches 2e-3 m/s, where the drag on about 1 m^2 stays below 0.01 N. The
/// other tolerance is the rounding of the integrator's mean over a step.
TEST(OwnModuleOnAVessel, HasColumnsBesideThoseOfTheWater) {
  for (const std::string integrator : {"semi-implicit-euler", "moreau", "reference"}) {
    const test::SceneRig rig(test::steps_of(0.01) + test::k_no_weight + "<contact integrator='" + integrator + "'/>" +
                             "<water density='1000' level='5'/><hydro><drag form='1'/></hydro>" +
                             test::box_vessel("position='0 0 0'", ""));
    WarningCounts warnings(make_logger("off", ""));
    sim::Simulation run(rig.scene, 1, warnings, with_tug());
    ASSERT_EQ(run.info().vessel_loads, std::vector<std::string>{"tug"}) << integrator;
    const sim::StepRecord record = run.step();
    const VesselChannels channels(run.info());
    std::vector<double> values;
    channels.read(*record.vessel, values);
    const auto value = [&](const std::string& name) {
      const auto& names = channels.names();
      const auto found = std::find(names.begin(), names.end(), name);
      return found == names.end() ? std::nan("") : values[static_cast<std::size_t>(found - names.begin())];
    };
    EXPECT_NEAR(value("tug_fx_N"), k_push, 1e-10) << integrator;
    EXPECT_NEAR(value("tug_my_Nm"), 2 * k_push, 1e-10) << integrator;
    EXPECT_NEAR(value("hydro_fx_N"), 0, 0.01) << integrator;
    const std::vector<std::string> loads = channels.load_names();
    EXPECT_EQ(std::count(loads.begin(), loads.end(), "tug_fz_N"), 1) << integrator;
  }
}

/// The tug pulls forward, so its share of the resistance is negative, and the carriage holds the hull back as strongly.
/// At a constant speed nothing is left for inertia. The statistics that a checkpoint holds are the same.
TEST(OwnModuleOnAVessel, HasItsShareOfTheTowForce) {
  const test::SceneRig rig(test::steps_of(0.01) + test::k_no_weight +
                           test::box_vessel("position='0 0 0'", "<carriage speed='0.2'/>"));
  WarningCounts warnings(make_logger("off", ""));
  sim::Simulation run(rig.scene, 1, warnings, with_tug());
  RunStatistics statistics(run.info()), restored(run.info());
  const VesselChannels channels(run.info());
  statistics.start(run.time(), run.initial_ledger());
  for (int k = 0; k < 20; ++k) {
    const sim::StepRecord record = run.step();
    std::vector<double> values;
    channels.read(*record.vessel, values);
    statistics.add(record, values);
  }
  State state;
  statistics.save(StateWriter(state));
  restored.restore(StateReader(state));
  for (const RunStatistics* each : {&statistics, &restored}) {
    const auto load = each->ice_load(nullptr);
    ASSERT_TRUE(load && load->tow);
    ASSERT_EQ(load->tow->modules.size(), 1);
    EXPECT_EQ(load->tow->modules.front().first, "tug");
    EXPECT_NEAR(load->tow->modules.front().second, -k_push, 1e-10);
    EXPECT_NEAR(load->tow->mean, -k_push, 1e-9);
    EXPECT_NEAR(load->tow->inertia, 0, 1e-9);
    EXPECT_NEAR(tow_force_json(*load->tow).at("modules_N").at("tug").get<double>(), -k_push, 1e-10);
  }
}

/// A floe and a vessel at rest, without a current: only the module drives them.
TEST(OwnModuleOnAVessel, DrivesTheIceInTheChecksOfAScene) {
  const test::SceneRig rig(test::steps_of(0.01) + test::k_no_weight + test::box_vessel("position='0 0 0'", "") +
                           "<ice thickness='0.1'><floe outline='5 0 6 0 6 1 5 1'/></ice>");
  const auto doubts = [&](const sim::ModuleList& modules) {
    WarningCounts warnings(make_logger("off", ""));
    const sim::Simulation run(rig.scene, 1, warnings, modules);
    return std::count_if(run.info().warnings.begin(), run.info().warnings.end(),
                         [](const auto& fault) { return fault.message.find("nothing drives") != std::string::npos; });
  };
  EXPECT_EQ(doubts(sim::scene_modules()), 1);
  EXPECT_EQ(doubts(with_tug()), 0);
}

}  // namespace own_module_test
