/// The theta scheme on impulses: order, energy, bounces, and the accounts.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/core/sim/scene_rig.h"

namespace moreau_test {

using namespace nilas;
using namespace nilas::sim;

struct Rig : test::SceneRig {
  using SceneRig::SceneRig;
  StepRecord step() { return balanced_step(1e-12, 1e-15); }
  double height() const { return bodies().p_GB.back().z(); }
};

std::string contact(const std::string& integrator, double restitution) {
  return "<contact law='coulomb' solver='newton' tolerance='1e-13' stabilisation='projection' integrator='" +
         integrator + "'><friction between='* *' static='0.3' kinetic='0.3' restitution='" +
         std::to_string(restitution) + "'/></contact>";
}

TEST(Moreau, FreeFallIsExact) {
  Rig rig(test::steps_of(0.01) + contact("moreau", 0) +
          "<body shape='sphere' radius='0.1' mass='1' position='0 0 5'/>");
  double start = 0;
  for (int k = 1; k <= 100; ++k) {
    const StepRecord record = rig.step();
    const double t = 0.01 * k;
    EXPECT_NEAR(rig.height(), 5 - 0.5 * 9.81 * t * t, 1e-13);
    const double energy = record.ledger.kinetic + record.ledger.potential;
    if (k == 1) start = energy;
    EXPECT_NEAR(energy, start, 1e-12);
    EXPECT_NEAR(record.ledger.imbalance, 0, 1e-12);
  }
}

/// A bounce with e = 1 is its own image in time, so no height is ever won or lost, wherever in a step it falls and
/// whatever takes penetration back.
TEST(Moreau, AnElasticBallKeepsItsHeight) {
  for (const double start : {0.25, 0.77, 0.93, 1.13}) {
    Rig rig(test::steps_of(0.01) + contact("moreau", 1) +
            "<body shape='box' size='4 4 1' mass='1' position='0 0 -0.5' fixed='true'/>"
            "<body shape='sphere' radius='0.1' mass='1' position='0 0 " +
            std::to_string(start) + "'/>");
    int bounces = 0;
    double highest = 0, before = 0, worst = 0;
    while (bounces < 300) {
      const StepRecord record = rig.simulation.step();
      EXPECT_EQ(record.ledger.stabilisation, 0);
      const double up = rig.simulation.bodies().v_GB[1].z();
      highest = std::max(highest, rig.height());
      if (up > 0 && before < 0) {
        // the highest of the steps' ends, where the ball stands still or nearly so; the first falls from the start
        if (++bounces > 1) worst = std::max(worst, std::abs(highest - start));
        highest = 0;
      }
      before = up;
    }
    EXPECT_LE(worst, 1e-10) << start;
  }
}

/// A ball that would cross a thin plate within a step hits it first.
TEST(Moreau, AFastBallDoesNotPassAThinPlate) {
  for (const double restitution : {0.5, 1.0}) {
    Rig rig(test::steps_of(0.01) + "<gravity value='0 0 0'/>" + contact("moreau", restitution) +
            "<body shape='box' size='1 1 0.02' mass='1' position='0 0 -0.01' fixed='true'/>"
            "<body shape='sphere' radius='0.02' mass='1' position='0 0 0.213' velocity='0 0 -12'/>");
    for (int k = 0; k < 10; ++k) rig.step();
    EXPECT_GT(rig.height(), 0);
    EXPECT_NEAR(rig.simulation.bodies().v_GB[1].z(), 12 * restitution, 1e-9);
  }
}

/// A box that bobs in water: the heave is of second order, its energy bounded; semi-implicit Euler is of first order.
TEST(Moreau, ABobbingBoxConvergesInSecondOrder) {
  const auto height = [](const std::string& integrator, double step) {
    Rig rig(test::steps_of(step) + contact(integrator, 0) +
            "<water density='1000' level='0'/><hydro><buoyancy/></hydro>"
            "<body shape='box' size='1 1 0.4' mass='200' position='0 0 0.05'/>");
    StepRecord record;
    for (int k = 0; k < static_cast<int>(std::lround(1.5 / step)); ++k) record = rig.step();
    EXPECT_NEAR(record.ledger.imbalance, 0, 1e-9);
    return rig.height();
  };
  // draught 0.2 m; heave about z = 0 with w^2 = g / 0.2 m while the waterplane is whole
  const double exact = 0.05 * std::cos(std::sqrt(9.81 / 0.2) * 1.5);
  double last = 0;
  for (const double step : {0.02, 0.01, 0.005, 0.0025}) {
    const double error = std::abs(height("moreau", step) - exact);
    if (last > 0) {
      EXPECT_NEAR(std::log2(last / error), 2, 0.1) << step;
    }
    last = error;
  }
  const double coarse = std::abs(height("semi-implicit-euler", 0.005) - exact);
  const double fine = std::abs(height("semi-implicit-euler", 0.0025) - exact);
  EXPECT_NEAR(std::log2(coarse / fine), 1, 0.2);
  EXPECT_LT(last, 0.02 * fine);
}

TEST(Moreau, ABoxAtRestStaysAtRest) {
  Rig rig(test::steps_of(0.01) + contact("moreau", 0.5) +
          "<body shape='box' size='4 4 1' mass='1' position='0 0 -0.5' fixed='true'/>"
          "<body shape='box' size='0.4 0.4 0.4' mass='3' position='0 0 0.2'/>");
  StepRecord record;
  for (int k = 0; k < 2000; ++k) record = rig.step();
  EXPECT_NEAR(rig.height(), 0.2, 1e-3 * 0.01);
  EXPECT_NEAR(record.ledger.imbalance, 0, 1e-11);
}

TEST(Moreau, ATopKeepsItsEnergy) {
  Rig rig(test::steps_of(0.01) + "<gravity value='0 0 0'/>" + contact("moreau", 0) +
          "<body shape='box' size='1 0.6 0.3' mass='2' position='0 0 0' angular_velocity='0.3 0.9 0.3'/>");
  const double start = rig.step().ledger.kinetic;
  StepRecord record;
  for (int k = 0; k < 20000; ++k) record = rig.simulation.step();
  EXPECT_NEAR(record.ledger.kinetic, start, 1e-12 * start);
}

/// Newton's law on all contacts of one instant: (-1/3, 2/3, 2/3) v.
TEST(Moreau, ImpactsAtOnceObeyNewtonsLawTogether) {
  const auto ball = [](const char* x, const char* v) {
    return std::string("<body shape='sphere' radius='0.1' mass='2' position='") + x + " 0 0' velocity='" + v +
           " 0 0'/>";
  };
  Rig rig(test::steps_of(0.01) + "<gravity value='0 0 0'/>" + contact("moreau", 1) + ball("-0.202", "1") +
          ball("0", "0") + ball("0.2", "0"));
  rig.step();
  const auto& v = rig.simulation.bodies().v_GB;
  EXPECT_NEAR(v[0].x(), -1.0 / 3, 1e-12);
  EXPECT_NEAR(v[1].x(), 2.0 / 3, 1e-12);
  EXPECT_NEAR(v[2].x(), 2.0 / 3, 1e-12);
}

}  // namespace moreau_test
