/// Tests of each stabilisation with a box that stands a millimetre deep in the ground, and with one that only rests.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "contact/step_motion.h"
#include "core/sim/simulation.h"
#include "tests/core/sim/scene_rig.h"

namespace stabilisation_test {

using namespace nilas;
using namespace nilas::sim;

constexpr double k_step = 0.01, k_gravity = 9.81, k_depth = 1e-3, k_mass = 3;

/// A box of 0.4 m on the fixed ground z = 0, `depth` deep.
struct BoxOnGround : test::SceneRig {
  BoxOnGround(const std::string& stabilisation, double depth)
      : SceneRig(test::steps_of(k_step) + "<contact law='coulomb' solver='newton' tolerance='1e-12' stabilisation='" +
                 stabilisation +
                 "'><friction between='* *' static='0.3' kinetic='0.3'/></contact>"
                 "<body name='ground' shape='box' size='4 4 1' mass='1' position='0 0 -0.5' fixed='true'/>"
                 "<body name='box' shape='box' size='0.4 0.4 0.4' mass='3' position='0 0 " +
                 std::to_string(0.2 - depth) + "'/>") {}

  StepRecord step() {
    const StepRecord record = simulation.step();
    EXPECT_LE(std::abs(record.ledger.imbalance), 1e-12);
    EXPECT_LE(record.momentum_imbalance, 1e-12 * record.momentum_scale + 1e-15);
    return record;
  }
  double depth() const { return 0.2 - simulation.bodies().p_GB[1].z(); }
  double speed() const { return simulation.bodies().v_GB[1].z(); }
};

TEST(Stabilisation, NoneLeavesTheDepth) {
  BoxOnGround box("none", k_depth);
  for (int k = 0; k < 20; ++k) box.step();
  EXPECT_NEAR(box.depth(), k_depth, 1e-12);
  EXPECT_NEAR(box.speed(), 0, 1e-12);
}

/// The depth falls by the share in every step, at the speed that takes; the ledger has the energy put in.
TEST(Stabilisation, BaumgarteTakesItsShareAtASpeed) {
  BoxOnGround box("baumgarte' integrator='semi-implicit-euler' erp='0.25", k_depth);
  double depth = k_depth, before = 0, put_in = 0;
  for (int k = 0; k < 20; ++k) {
    const StepRecord record = box.step();
    const double speed = 0.25 * depth / k_step;
    // r_N = m (u+ - u-) + m g h
    put_in += 0.5 * k_mass * (speed - before + k_gravity * k_step) * speed;
    depth *= 0.75;
    before = speed;
    EXPECT_NEAR(box.depth(), depth, 1e-12);
    EXPECT_NEAR(box.speed(), speed, 1e-10);
    EXPECT_NEAR(record.ledger.stabilisation, -put_in, 1e-12);
  }
}

/// The box leaves the ground in one step and keeps the speed of that motion; gravity brings it back.
TEST(Stabilisation, TasoraThrowsTheBoxOut) {
  BoxOnGround box("tasora' integrator='semi-implicit-euler", k_depth);
  box.step();
  EXPECT_NEAR(box.depth(), 0, 1e-12);
  EXPECT_NEAR(box.speed(), k_depth / k_step, 1e-10);
  BoxOnGround slow("tasora' integrator='semi-implicit-euler' max_speed='0.02", k_depth);
  slow.step();
  EXPECT_NEAR(slow.speed(), 0.02, 1e-10);
}

/// The box leaves the ground in one step and is at rest: the ledger books the work against weight and nothing else.
TEST(Stabilisation, ProjectionMovesTheBoxOutAtRest) {
  BoxOnGround box("projection", k_depth);
  const StepRecord record = box.step();
  EXPECT_NEAR(box.depth(), 0, 1e-12);
  EXPECT_NEAR(box.speed(), 0, 1e-12);
  EXPECT_NEAR(record.ledger.stabilisation, -k_mass * k_gravity * k_depth, 1e-12);
  EXPECT_NEAR(record.ledger.kinetic, 0, 1e-20);
  BoxOnGround shallow("projection' slop='4e-4", k_depth);
  shallow.step();
  EXPECT_NEAR(shallow.depth(), 4e-4, 1e-12);
}

TEST(Stabilisation, SplitImpulseTakesItsShareAtRest) {
  BoxOnGround box("split-impulse' erp='0.25", k_depth);
  for (int k = 0; k < 5; ++k) box.step();
  constexpr double k_tolerance = 1e-3;  // of its speeds [m/s]
  EXPECT_NEAR(box.depth(), k_depth * std::pow(0.75, 5), 5 * k_tolerance * k_step);
  EXPECT_NEAR(box.speed(), 0, 1e-12);
}

TEST(Stabilisation, ProjectionLetsNothingDriftAtRest) {
  BoxOnGround box("projection", 0);
  for (int k = 0; k < 100000; ++k) box.simulation.step();
  const bodies::Bodies& bodies = box.simulation.bodies();
  EXPECT_LE((bodies.p_GB[1] - Vec3(0, 0, 0.2)).norm(), 1e-9);
  EXPECT_LE(Quat::Identity().angularDistance(bodies.q_GB[1]), 1e-9);
}

/// A wall that tilts a box: the carried points are where the bodies' own points are.
TEST(Stabilisation, CarriedPointsFollowTheirBodies) {
  bodies::Bodies bodies;
  for (double x : {0.0, 1.0}) {
    bodies::BodySpec spec;
    spec.name = "b";
    spec.shape = std::make_shared<const geometry::Shape>(geometry::box_shape({1, 1, 1}));
    spec.mass = 1;
    spec.pose.p = Vec3(x, 0, 0);
    bodies.add(spec);
  }
  contact::StepMotion motion;
  motion.p = bodies.p_GB;
  motion.R = bodies.R_GB;
  detect::ContactPoint point;
  point.a = 0;
  point.b = 1;
  point.p = Vec3(0.5, 0.5, 0);
  point.n = Vec3::UnitX();
  point.gap = 0.01;
  motion.points = {point};
  // B moves away by 2 mm and both turn by a right angle about z, B about its own centre
  const Quat turn(Eigen::AngleAxisd(0.5 * k_pi, Vec3::UnitZ()));
  bodies.set_pose(0, Vec3::Zero(), turn);
  bodies.set_pose(1, turn * Vec3(1.002, 0, 0), turn);
  const detect::ContactPoint carried = contact::carried_points(motion, bodies).front();
  EXPECT_LE((carried.n - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_NEAR(carried.gap, 0.012, 1e-15);
  EXPECT_LE((carried.p - Vec3(-0.5, 0.501, 0)).norm(), 1e-15);
}

}  // namespace stabilisation_test
