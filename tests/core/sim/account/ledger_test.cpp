/// The energy ledger: closed with all of its terms, open without any one of them.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/support/scratch_folder.h"

namespace ledger_test {

using namespace nilas;
using namespace nilas::sim;

/// Floes that drag slows and drives, a wall that is rough and bounces, a ball that falls, and a box that starts deep in
/// a slab.
const std::string k_world =
    "<water density='1000'/><hydro><buoyancy/><drag/><virtual_drag coefficient='20' velocity='0.5 0 0'/></hydro>"
    "<ice density='900' thickness='0.2'><floe name='one' outline='0 0 1 0 1 1 0 1' velocity='1 0.4 0'/>"
    "<floe name='two' outline='1.02 0.1 2 0.1 2 1.1 1.02 1.1' velocity='-1 0 0'/></ice>"
    "<body name='wall' shape='box' size='1 8 4' position='2.55 0 0' fixed='true'/>"
    "<body name='ball' shape='sphere' radius='0.1' density='400' position='0.5 0.5 0.6'/>"
    "<body name='slab' shape='box' size='1 1 1' position='10 0 2' fixed='true'/>"
    "<body name='deep' shape='box' size='0.2 0.2 0.2' density='400' position='10 0 2.59'/>";

scene::Scene scene_of(const test::ScratchFolder& folder, const std::string& integrator,
                      const std::string& stabilisation) {
  return scene::read_scene(folder.write(
      "scene.xml", "<scene version='1'><time step='0.01'/><contact solver='newton' tolerance='1e-12' integrator='" +
                       integrator + "' stabilisation='" + stabilisation +
                       "'><friction between='* *' static='0.3' kinetic='0.3' restitution='0.4'/></contact>" + k_world +
                       "</scene>"));
}

/// kinetic + potential + losses - works - start, the definition of imbalance_J written out.
double recomputed(const Ledger& now, const Ledger& start) {
  double works = 0;
  for (const double work : now.works) works += work;
  return now.kinetic + now.potential + now.friction + now.impact + now.stabilisation + now.fracture + now.crushing +
         now.integrator - works - (start.kinetic + start.potential);
}

TEST(Ledger, EachTermDeletedOpensIt) {
  const test::ScratchFolder folder;
  for (const std::string integrator : {"semi-implicit-euler", "moreau"}) {
    WarningCounts warnings{make_logger("off", "")};
    Simulation simulation(scene_of(folder, integrator, "baumgarte"), 1, warnings);
    const Ledger start = simulation.initial_ledger();
    Ledger now;
    for (int k = 0; k < 60; ++k) now = simulation.step().ledger;
    double put_in = start.kinetic;
    for (const double work : now.works) put_in += std::abs(work);
    EXPECT_LE(std::abs(now.imbalance), 1e-12 * put_in);
    EXPECT_NEAR(recomputed(now, start), now.imbalance, 1e-12 * put_in);

    const std::vector<std::pair<std::string, std::function<void(Ledger&)>>> deletions{
        {"kinetic", [](Ledger& l) { l.kinetic = 0; }},
        {"potential", [](Ledger& l) { l.potential = 0; }},
        {"drag", [](Ledger& l) { l.works.at(0) = 0; }},
        {"virtual drag", [](Ledger& l) { l.works.at(1) = 0; }},
        {"friction", [](Ledger& l) { l.friction = 0; }},
        {"impact", [](Ledger& l) { l.impact = 0; }},
        {"stabilisation", [](Ledger& l) { l.stabilisation = 0; }},
        {"integrator", [](Ledger& l) { l.integrator = 0; }}};
    ASSERT_EQ(now.works.size(), 2u);
    for (const auto& [name, remove] : deletions) {
      Ledger without = now;
      remove(without);
      EXPECT_GE(std::abs(recomputed(without, start)), 1e-9 * put_in) << integrator << " without " << name;
    }
  }
}

TEST(Ledger, ClosesWithEveryStabilisation) {
  const test::ScratchFolder folder;
  for (const std::string integrator : {"semi-implicit-euler", "moreau"})
    for (const std::string stabilisation : {"none", "baumgarte", "tasora", "split-impulse", "projection"}) {
      WarningCounts warnings{make_logger("off", "")};
      Simulation simulation(scene_of(folder, integrator, stabilisation), 1, warnings);
      double put_in = simulation.initial_ledger().kinetic;
      StepRecord record;
      for (int k = 0; k < 60; ++k) record = simulation.step();
      for (const double work : record.ledger.works) put_in += std::abs(work);
      EXPECT_LE(std::abs(record.ledger.imbalance), 1e-12 * put_in) << integrator << " " << stabilisation;
    }
}

/// Two bodies that nothing acts on: their momenta change by rounding alone, which is no imbalance. Rounding is at most
/// a few 1e-16 of the momenta themselves.
TEST(MomentumBalance, OfBodiesThatNothingActsOnIsRounding) {
  const test::ScratchFolder folder;
  for (const std::string integrator : {"semi-implicit-euler", "moreau", "reference"}) {
    WarningCounts warnings{make_logger("off", "")};
    Simulation simulation(
        scene::read_scene(folder.write(
            "scene.xml", "<scene version='1'><time step='0.01'/><gravity value='0 0 0'/><contact integrator='" +
                             integrator +
                             "'/><body shape='box' size='0.3 0.2 0.1' angular_velocity='4 3 -2'/>"
                             "<body shape='box' size='0.1 0.2 0.3' position='5 0 0' angular_velocity='1 -5 2' "
                             "velocity='0.3 0.1 0.2'/></scene>")),
        1, warnings);
    for (int k = 0; k < 20; ++k) {
      const StepRecord record = simulation.step();
      EXPECT_GT(record.momentum_scale, 0) << integrator;
      EXPECT_LE(record.momentum_imbalance, 1e-12 * record.momentum_scale) << integrator;
      EXPECT_LE(record.angular_momentum_imbalance, 1e-12 * record.angular_momentum_scale) << integrator;
    }
  }
}

/// A ball rolls on a floor of springs with rolling and spinning friction, whose couples take energy as well. Of a scene
/// of random campaigns.
TEST(Ledger, ClosesWithRollingFrictionOfElasticContacts) {
  const test::ScratchFolder folder;
  for (const std::string integrator : {"semi-implicit-euler", "moreau"}) {
    WarningCounts warnings{make_logger("off", "")};
    Simulation simulation(
        scene::read_scene(folder.write(
            "scene.xml",
            "<scene version='1'><time step='0.01'/><contact solver='nsgs' tolerance='1e-12' integrator='" + integrator +
                "'><friction between='* *' static='0.3' rolling='0.05' spinning='0.02' elastic='true' "
                "stiffness='1e5'/></contact><body shape='plane'/><body shape='sphere' radius='0.5' mass='10' "
                "position='0 0 0.499' velocity='1 0 0' angular_velocity='0 2 3'/></scene>")),
        1, warnings);
    const double start = simulation.initial_ledger().kinetic;
    Ledger now;
    for (int k = 0; k < 50; ++k) now = simulation.step().ledger;
    EXPECT_GT(now.friction, 0.01 * start) << integrator;
    EXPECT_LE(std::abs(now.imbalance), 1e-12 * start) << integrator;
  }
}

/// Only modules that a scene names are built: a body in free flight has no force module, no water, no vessel.
TEST(Modules, AreBuiltForWhatASceneNamesOnly) {
  const test::ScratchFolder folder;
  const auto built = [&](const std::string& content) {
    WarningCounts warnings{make_logger("off", "")};
    const Simulation simulation(
        scene::read_scene(folder.write("scene.xml", "<scene version='1'>" + content + "</scene>")), 1, warnings);
    std::vector<std::string> names;
    for (const auto& [name, why] : simulation.info().modules) names.push_back(name);
    return names;
  };
  const std::string flight = "<gravity value='0 0 0'/><body shape='sphere' mass='1'/>";
  EXPECT_EQ(built(flight), (std::vector<std::string>{"contact"}));
  const std::string floe = "<ice><floe outline='0 0 1 0 1 1 0 1'/></ice>";
  EXPECT_EQ(built(floe + "<hydro><drag/></hydro>").size(), built(floe).size() + 1);
  EXPECT_EQ(built(floe + "<hydro><drag/><buoyancy/></hydro>").size(), built(floe).size() + 2);
}

}  // namespace ledger_test
