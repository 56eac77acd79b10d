/// Whole steps on small scenes with closed-form answers, and the accounts of energy and momentum.
#include "core/sim/simulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "core/base/error.h"
#include "tests/core/sim/scene_rig.h"
#include "tests/support/refusal.h"

namespace simulation_test {

using namespace nilas;
using namespace nilas::sim;

struct Rig : test::SceneRig {
  using SceneRig::SceneRig;
  StepRecord run(int steps) {
    StepRecord record;
    for (int k = 0; k < steps; ++k) record = balanced_step(1e-12, 1e-15);
    return record;
  }
};

const char* const k_contact =
    "<contact law='coulomb' solver='pgs' tolerance='1e-10' max_iterations='5000'>"
    "<friction between='structure structure' static='0.3' kinetic='0.3'/>"
    "<friction between='ice ice' static='0.3' kinetic='0.3'/></contact>";

TEST(Simulation, FreeFallIsSemiImplicitEuler) {
  Rig rig(
      "<time step='0.01' end='1'/><contact integrator='semi-implicit-euler'/>"
      "<body name='b' shape='sphere' radius='0.1' mass='1' position='0 0 5'/>");
  rig.run(100);
  // v_n = -g h n; z_n = z_0 - g h^2 n (n + 1)/2
  EXPECT_NEAR(rig.simulation.bodies().v_GB[0].z(), -9.81, 1e-12);
  EXPECT_NEAR(rig.simulation.bodies().p_GB[0].z(), 5 - 9.81 * 1e-4 * 100 * 101 / 2, 1e-12);
}

TEST(Simulation, ABoxAtRestStaysAtRest) {
  Rig rig(std::string("<time step='0.01' end='5'/>") + k_contact +
          "<body name='ground' shape='plane' fixed='true'/>"
          "<body name='box' shape='box' size='1 1 1' mass='2' position='0 0 0.5'/>");
  const auto record = rig.run(300);
  EXPECT_EQ(record.contacts, 4);
  EXPECT_LT(rig.simulation.bodies().v_GB[1].norm(), 1e-8);
  EXPECT_NEAR(rig.simulation.bodies().p_GB[1].z(), 0.5, 1e-8);
}

/// A box on a 20 degree slope sticks for mu > tan 20, else slides with g (sin a - mu cos a).
TEST(Simulation, ASlopeHoldsBelowTheFrictionAngle) {
  for (const double mu : {0.40, 0.30}) {
    Rig rig(
        "<time step='0.01' end='5'/>"
        "<contact law='coulomb' solver='pgs' tolerance='1e-10' max_iterations='5000'>"
        "<friction between='structure structure' static='" +
        std::to_string(mu) + "' kinetic='" + std::to_string(mu) +
        "'/></contact>"
        "<gravity value='3.355217606 0 -9.218384585'/>"
        "<body name='ground' shape='plane' fixed='true'/>"
        "<body name='box' shape='box' size='1 1 0.2' mass='2' position='0 0 0.1'/>");
    rig.run(50);
    const double expected = mu > std::tan(20 * k_deg) ? 0 : 0.5 * (3.355217606 - mu * 9.218384585);
    EXPECT_NEAR(rig.simulation.bodies().v_GB[1].x(), expected, 1e-7) << "mu " << mu;
  }
}

/// A slope of 20 degrees with mu_s 0.4 and mu_k 0.3: a box at rest stays, and one that slides accelerates.
TEST(Simulation, ASlopeBetweenTheTwoCoefficientsHoldsWhatRestsAndNotWhatSlides) {
  for (const double start : {0.0, 0.02}) {
    Rig rig(
        "<time step='0.01' end='5'/>"
        "<contact law='coulomb' solver='auto' tolerance='1e-10'>"
        "<friction between='structure structure' static='0.4' kinetic='0.3'/></contact>"
        "<gravity value='3.355217606 0 -9.218384585'/>"
        "<body name='ground' shape='plane' fixed='true'/>"
        "<body name='box' shape='box' size='1 1 0.2' mass='2' position='0 0 0.1' velocity='" +
        std::to_string(start) + " 0 0'/>");
    const auto record = rig.run(50);
    EXPECT_EQ(record.status, contact::SolveStatus::converged);
    const double expected = start > 0 ? start + 0.5 * (3.355217606 - 0.3 * 9.218384585) : 0;
    EXPECT_NEAR(rig.simulation.bodies().v_GB[1].x(), expected, 1e-7) << "from " << start;
  }
}

TEST(Simulation, TwoFloesCollideWithoutLossOfMomentum) {
  Rig rig(std::string("<time step='0.01' end='2'/><gravity value='0 0 0'/>") + k_contact +
          "<ice thickness='0.1'>"
          "<floe name='a' outline='0 0 1 0 1 1 0 1' velocity='0.5 0 0'/>"
          "<floe name='b' outline='1.05 0.3 2 0.3 2 1.3 1.05 1.3'/></ice>");
  rig.run(100);
  const bodies::Bodies& bodies = rig.simulation.bodies();
  const Vec3 momentum = bodies.mass[0] * bodies.v_GB[0] + bodies.mass[1] * bodies.v_GB[1];
  EXPECT_NEAR(momentum.x(), bodies.mass[0] * 0.5, 1e-12);
  EXPECT_NEAR(momentum.y(), 0, 1e-12);
  EXPECT_GT(bodies.v_GB[1].x(), 0.1);
}

/// Impact, friction, weight and buoyancy together: the ledger closes to rounding.
TEST(Simulation, TheLedgerCloses) {
  Rig rig(std::string("<time step='0.01' end='5'/>") + k_contact +
          "<water density='1000'/><hydro><buoyancy/><drag form='1' skin='0.005'/></hydro>"
          "<ice thickness='0.1'>"
          "<floe name='a' outline='0 0 1 0 1 1 0 1' velocity='0.5 0.1 0' z='0.02'/>"
          "<floe name='b' outline='1.05 0.3 2 0.3 2 1.3 1.05 1.3' z='-0.03'/></ice>");
  const Ledger start = rig.simulation.initial_ledger();
  const auto record = rig.run(300);
  const double scale = std::abs(start.kinetic) + std::abs(start.potential);
  EXPECT_LT(std::abs(record.ledger.imbalance), 1e-12 * scale);
  EXPECT_GT(record.ledger.impact, 0);
  EXPECT_LT(record.ledger.works.at(0), 0) << "drag takes energy";
}

/// A scene without water, vessel and ice builds no module but contact, and reports that.
TEST(Simulation, OnlyWhatTheSceneNamesIsBuilt) {
  Rig rig("<time step='0.01' end='1'/><body name='b' shape='sphere' radius='0.1' mass='1'/>");
  EXPECT_EQ(rig.simulation.info().modules.size(), 1u);
  EXPECT_TRUE(rig.simulation.info().work_names.empty());
  EXPECT_FALSE(rig.simulation.info().has_vessel);
}

TEST(Simulation, AFloeStartsAtItsFloatingHeight) {
  Rig rig(
      "<time step='0.01' end='1'/><water density='1000'/><hydro><buoyancy/></hydro>"
      "<ice thickness='0.1' density='900'><floe outline='0 0 1 0 1 1 0 1'/></ice>");
  const double z = rig.simulation.bodies().p_GB[0].z();
  EXPECT_NEAR(z, 0.1 * (0.5 - 0.9), 1e-15);
  rig.run(100);
  EXPECT_NEAR(rig.simulation.bodies().p_GB[0].z(), z, 1e-12);
}

TEST(Simulation, NonFiniteMotionStopsTheRunWithTheBodysName) {
  Rig rig(
      "<time step='1e200' end='1e203'/><body name='lost' shape='sphere' radius='0.1' mass='1' velocity='1e200 0 0'/>");
  test::expect_refusal<SimulationError>([&] { rig.run(10); }, {"lost"});
}

TEST(Simulation, FloesOverlappingAtTheStartAreRefused) {
  EXPECT_THROW(Rig("<time end='1'/><ice thickness='0.1'><floe outline='0 0 1 0 1 1 0 1'/>"
                   "<floe outline='0.9 0 2 0 2 1 0.9 1'/></ice>"),
               InputError);
}

TEST(Simulation, TwinsStartNextToNothingAsideAndAlikeForTheSameNumber) {
  const auto start = [](const std::string& twin) {
    Rig rig("<time end='1'/><seed value='1' twin='" + twin +
            "'/><ice thickness='0.1'>"
            "<floe outline='0 0 1 0 1 1 0 1'/><floe outline='2 0 3 0 3 1 2 1' fixed='true'/></ice>"
            "<body name='ball' shape='sphere' radius='0.1' mass='1' position='0 0 5'/>"
            "<body name='post' shape='sphere' radius='0.1' fixed='true' position='9 0 5'/>");
    return rig.simulation.bodies().p_GB;
  };
  const auto itself = start("0"), one = start("1"), two = start("2");
  ASSERT_EQ(itself.size(), 4U);
  EXPECT_EQ(start("1"), one);
  for (const std::size_t b : {0, 1, 2}) {
    for (const auto& twin : {one, two}) {
      EXPECT_GT((twin[b] - itself[b]).norm(), 0) << b;
      EXPECT_LE((twin[b] - itself[b]).cwiseAbs().maxCoeff(), 1.001e-12) << b;
      EXPECT_EQ(twin[b].z(), itself[b].z()) << b;
    }
    EXPECT_NE(one[b], two[b]) << b;
  }
  EXPECT_EQ(one[3], itself[3]);
}

}  // namespace simulation_test
