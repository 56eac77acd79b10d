/// A vessel of several bodies in whole scenes: accounts, contacts on parts and between them, water, refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/base/error.h"
#include "tests/core/sim/scene_rig.h"
#include "tests/support/refusal.h"

namespace vessel_parts_test {

using namespace nilas;
using namespace nilas::sim;

using Rig = test::JointedSceneRig;

constexpr double k_friction = 0.2;

/// The same box as the hull, joined to its fore end by a hinge across.
std::string barge(const std::string& more = "") {
  return "<part name='barge' joint='hinge' axis='0 1 0' at='1.05 0 0' position='2.1 0 0' shape='box' size='2 1 0.5' "
         "mass='1000' " +
         more + "/>";
}

TEST(VesselParts, HitByASphereTheChainTakesTheImpulseOfTheClosedForm) {
  // a sphere of 50 kg at 2 m/s hits the far end of the second of two hinged boxes across their length
  for (const std::string integrator : {"semi-implicit-euler", "moreau"}) {
    Rig rig(test::steps_of(0.001) + test::k_no_weight + test::newton_contact(integrator, 0) +
            test::box_vessel("position='0 0 0'", barge()) +
            "<body name='ball' shape='sphere' radius='0.2' mass='50' position='3.0 0 0.45' velocity='0 0 -2'/>");
    const double impulse = -0.001 * rig.step().vessel->contact.force.z();
    // compliance of the struck point: both boxes in plane motion about y, one hinge 1.05 m off both centres, struck 0.9
    // m beyond the second centre: a hinge impulse X makes both hinge points move alike
    const double m = 1000, I = m / 12 * (2 * 2 + 0.5 * 0.5), a = 1.05, b = 0.9;
    const double X = (1 / m - a * b / I) / (2 / m + 2 * a * a / I);  // per unit of impulse, on the hull
    const double compliance = (1 - X) / m + b * (b + a * X) / I;
    const double expected = 2 / (1 / 50.0 + compliance);
    EXPECT_NEAR(impulse, expected, 1e-9 * expected) << integrator;
    EXPECT_NEAR(rig.bodies().v_GB[0].z(), -expected * X / m, 1e-9) << integrator;
    EXPECT_NEAR(rig.bodies().v_GB[1].z(), -expected * (1 - X) / m, 1e-9) << integrator;
  }
}

/// Gravity on a plane that leans by `slope` towards -x.
std::string ramp(double slope, double g) {
  return "<gravity value='" + std::to_string(-g * std::sin(slope)) + " 0 " + std::to_string(-g * std::cos(slope)) +
         "'/><body name='ramp' shape='plane' fixed='true'/>";
}

TEST(VesselParts, SlideDownARampTogetherAndPullOnTheirJoint) {
  // friction 0.1 under the hull and 0.3 under the barge: both accelerate alike, the joint pulls. A slider across the
  // ramp passes no force across, so that each box bears its own weight
  const double slope = 0.3, g = 9.81, of_hull = 0.1, of_barge = 0.3;
  const std::string rough =
      "<contact law='coulomb' solver='newton' tolerance='1e-12' stabilisation='baumgarte' erp='0.2'>"
      "<friction between='hull structure' static='0.1' kinetic='0.1'/>"
      "<friction between='rough structure' static='0.3' kinetic='0.3'/></contact>";
  Rig rig(
      test::steps_of(0.01) + ramp(slope, g) + rough +
      test::box_vessel("position='0 0 0.25' velocity='-1 0 0'",
                       "<part name='barge' joint='slider' axis='0 0 1' at='1.05 0 0' position='2.1 0 0' size='2 1 0.5' "
                       "mass='1000' material='rough'/>"));
  const StepRecord record = rig.run(50);
  const double a = g * (std::sin(slope) - 0.5 * (of_hull + of_barge) * std::cos(slope));
  EXPECT_NEAR(rig.bodies().v_GB[0].x(), -1 - 0.5 * a, 1e-6);
  EXPECT_NEAR(rig.bodies().v_GB[1].x(), -1 - 0.5 * a, 1e-6);
  // on the barge downhill: weight along the slope less its friction, and the joint, make m a
  const double downhill = 1000 * (a - g * std::sin(slope) + of_barge * g * std::cos(slope));
  EXPECT_NEAR(record.vessel->parts[0].joint.force.x(), -downhill, 1e-4 * downhill);
  EXPECT_NEAR(record.vessel->parts[0].joint.force.z(), 0, 1e-6 * downhill);
  EXPECT_NEAR(record.vessel->contact.force.z(), 2000 * g * std::cos(slope), 2e-2);
}

TEST(VesselParts, HingedBargesSlideDownARampAsOneBox) {
  for (const std::string integrator : {"semi-implicit-euler", "moreau"}) {
    const double slope = 0.3, g = 9.81;
    Rig rig(test::steps_of(0.01) + ramp(slope, g) + test::newton_contact(integrator, 0.2) +
            test::box_vessel("position='0 0 0.25' velocity='-1 0 0'", barge()));
    const StepRecord record = rig.run(50);
    const double a = g * (std::sin(slope) - 0.2 * std::cos(slope));
    EXPECT_NEAR(rig.bodies().v_GB[1].x(), -1 - 0.5 * a, 1e-6) << integrator;
    EXPECT_NEAR(record.vessel->parts[0].coordinates[0], 0, 1e-7) << integrator;
  }
}

TEST(VesselParts, HingedBargesPitchWithThePeriodOfTheClosedForm) {
  // afloat at 0.25 m, hinged at the height of their centres of mass: pitching against each other, each turns as a box
  // afloat alone, since the hinge passes no vertical force then
  const double rho = 1000, g = 9.81, m = rho * 2 * 1 * 0.25, I = m / 12 * (2 * 2 + 0.5 * 0.5);
  const double stiffness = rho * g * (2.0 * 2 * 2 / 12 - 2 * 0.25 * 0.125), omega = std::sqrt(stiffness / I);
  const double rate = 0.01;
  for (const std::string integrator : {"semi-implicit-euler", "moreau"}) {
    const std::string part =
        "<part name='barge' joint='hinge' axis='0 1 0' at='1.05 0 0' position='2.1 0 0' shape='box' size='2 1 0.5' "
        "mass='" +
        std::to_string(m) + "' rate_deg='" + std::to_string(-2 * rate / k_deg) + "'/>";
    // both centres stand still at the start
    Rig rig(test::steps_of(0.002) + test::newton_contact(integrator, k_friction) +
            "<water density='1000' level='0'/><hydro><buoyancy/></hydro>" +
            test::box_vessel("position='0 0 0' angular_velocity='0 " + std::to_string(rate) + " 0'", part, m));
    const double quarter = 0.5 * k_pi / omega;
    const int steps = static_cast<int>(std::lround(quarter / 0.002));
    StepRecord record;
    double largest = 0, mean_vertical = 0;
    for (int k = 0; k < steps; ++k) {
      record = rig.step();
      largest = std::max(largest, std::abs(record.vessel->parts[0].joint.force.z()));
      mean_vertical = std::max(mean_vertical, std::abs(rig.bodies().p_GB[0].z()));
    }
    EXPECT_NEAR(record.vessel->parts[0].coordinates[0], -2 * rate / omega, 0.005 * 2 * rate / omega) << integrator;
    EXPECT_NEAR(record.vessel->parts[0].rates[0], 0, 0.01 * 2 * rate) << integrator;
    EXPECT_LT(largest, 1e-2 * m * g * rate);
    EXPECT_LT(mean_vertical, 1e-3);
  }
}

TEST(VesselParts, NeighboursPassThroughEachOtherAndOthersDoNot) {
  // two arms that stand in the fixed hull, which they are joined to, swing against each other
  const std::string arm = "joint='hinge' axis='0 0 1' shape='box' size='0.8 0.1 0.2' mass='10' ";
  Rig rig(
      test::steps_of(0.005) + test::k_no_weight + test::newton_contact("semi-implicit-euler", 0) +
      test::box_vessel("position='0 0 0'", "<fixed/><part name='one' " + arm +
                                               "at='0 0 0.2' position='0.4 0 0.2' rate_deg='60'/><part name='two' " +
                                               arm + "at='0 1 0.2' position='0.4 1 0.2' rate_deg='-60'/>"));
  double touched = 0;
  StepRecord record;
  for (int k = 0; k < 400; ++k) {
    record = rig.step();
    touched = std::max(touched, record.vessel->parts[0].contact.force.norm());
    // Forces between the parts are no load on the vessel.
    EXPECT_LT(record.vessel->contact.force.norm(), 1e-9 * (1 + touched));
  }
  EXPECT_GT(touched, 1);
  // equal arms that meet without friction and bounce stop each other
  EXPECT_LT(record.ledger.kinetic, 1e-6 * record.ledger.impact);
}

TEST(VesselParts, BringTheirBitsThroughThreads) {
  const std::string scene =
      test::steps_of(0.01) + test::newton_contact("moreau", k_friction) +
      "<water density='1000' level='0'/><hydro><buoyancy/><drag/></hydro>" +
      test::box_vessel("position='0 0 0' velocity='0.5 0 0'", barge("rate_deg='20' stiffness='100'"), 600) +
      "<body name='ball' shape='sphere' radius='0.3' density='500' position='3.6 0.1 0'/>";
  Rig one(scene, 1), two(scene, 2);
  for (int k = 0; k < 100; ++k) ASSERT_EQ(one.step().state_hash, two.step().state_hash);
}

TEST(VesselParts, AreTowedByARigidCarriage) {
  // the second box hangs as a pendulum while the first is pulled up to speed: energy and momenta close
  for (const std::string integrator : {"semi-implicit-euler", "moreau"}) {
    Rig rig(test::steps_of(0.005) + test::newton_contact(integrator, k_friction) +
            test::box_vessel("position='0 0 3'",
                             "<carriage speed='1.5' ramp='0.5' joint='0 0 0'/>" + barge("stiffness='5000' "
                                                                                        "damping='300'")) +
            "<body name='pier' shape='box' size='1 1 1' position='6 0 2.4' fixed='true'/>");
    double lost = 0;
    for (int k = 0; k < 300; ++k) {
      const StepRecord record = rig.step();
      lost = record.ledger.integrator;
      EXPECT_LT(record.vessel->parts[0].unbalanced_force, 1e-2);
    }
    EXPECT_NEAR(rig.bodies().v_GB[0].x(), 1.5, 1e-9);
    EXPECT_LT(std::abs(lost), integrator == "moreau" ? 20 : 200);
  }
}

TEST(VesselParts, AreTowedOnSixCells) {
  // The same vessel on load cells and afloat, heave free, hits a pier; the cells read the force of the carriage.
  for (const std::string integrator : {"semi-implicit-euler", "moreau"}) {
    const std::string scene =
        test::steps_of(0.005) + test::newton_contact(integrator, k_friction) +
        "<water density='1000' level='0'/><hydro><buoyancy/><drag/></hydro>" +
        test::box_vessel("position='0 0 0'",
                         "<carriage speed='1' ramp='0.5' joint='0 0 0' free='heave'><force_balance kind='six-cells' "
                         "stiffness='1e7' damping='1e4'/></carriage>" +
                             barge("stiffness='5000' damping='300'"),
                         500) +
        "<body name='floe' shape='box' size='1 1 0.5' density='500' position='4 0.2 0.1'/>";
    Rig rig(scene), other(scene, 2);
    double touched = 0, pulled = 0;
    for (int k = 0; k < 300; ++k) {
      const StepRecord record = rig.step();
      ASSERT_EQ(record.state_hash, other.step().state_hash);
      const vessel::CarriageLoads& carriage = record.vessel->carriage.value();
      EXPECT_NEAR(carriage.cells[0], carriage.about_joint.force.x(), 1e-8);
      const Wrench& apart = carriage.disagreement.value();
      EXPECT_LT(apart.force.norm() + apart.torque.norm(), 1e-2);
      touched = std::max(touched, record.vessel->contact.force.norm());
      pulled = std::max(pulled, carriage.cells[0]);
    }
    EXPECT_GT(touched, 100);
    EXPECT_GT(pulled, 100);
    EXPECT_NEAR(rig.bodies().v_GB[0].x(), 1, 0.01);
  }
}

TEST(VesselParts, WhatDoesNotGoTogetherIsNamed) {
  const auto refused = [](const std::string& inside, const std::string& attributes, const std::string& expected,
                          const std::string& more = "") {
    test::expect_refusal<SceneError>(
        [&] {
          Rig(test::steps_of(0.01) + more + "<vessel name='hull' hull='box.stl' " + attributes + ">" + inside +
              "</vessel>");
        },
        {expected});
  };
  const std::string mass = "<mass value='100'/>", part = "<part name='p' joint='weld'/>", at = "position='0 0 5'";
  refused(part + "<mass draught='0.2'/>", at, "with parts the mass of the hull cannot follow from the water",
          "<water/>");
  refused(mass + part, "position='0 0'", "with <part> allowed: 3 numbers", "<water/>");
  refused(mass + part, at, "a vessel with <part> allows: true", "<contact gyroscopic='false'/>");
  refused(mass + "<part name='p' joint='hinge' axis='0 0 0'/>", at, "an axis without length");
  refused(mass + "<part name='p' joint='hinge' to='q'/>", at, "allowed: the vessel or a part before this one: hull");
  refused(mass + "<part name='hull' joint='weld'/>", at, "the name 'hull' is taken");
  refused(mass + "<part name='p' joint='weld' stiffness='3'/>", at, "allowed with: hinge, slider, ball");
  refused(mass + "<part name='p' joint='slider' angle_deg='3'/>", at, "no effect with joint 'slider'");
  refused(mass + "<part name='p'/>", at, "joint");
}

}  // namespace vessel_parts_test
