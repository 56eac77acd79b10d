/// Vessels on rods in whole scenes: blows, loads at rest, accounts, bits over threads, refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/base/error.h"
#include "tests/core/sim/scene_rig.h"
#include "tests/support/refusal.h"

namespace vessel_rods_test {

using namespace nilas;
using namespace nilas::sim;

using Rig = test::JointedSceneRig;

constexpr double k_friction = 0.2;

TEST(VesselRods, HitByASphereAHullOnARodTakesTheImpulseOfTheClosedForm) {
  // an upright rod at the fore end: a sphere of 50 kg at 2 m/s that falls on the aft end turns the hull about that end
  for (const std::string integrator : {"semi-implicit-euler", "moreau"}) {
    const double h = 0.001, m = 1000, I = m / 12 * (2 * 2 + 0.5 * 0.5), a = 1, b = 0.9;
    Rig rig(test::steps_of(h) + test::k_no_weight + test::newton_contact(integrator, 0) +
            test::box_vessel("position='0 0 0'", "<rod name='tie' at='1 0 0' to='1 0 5'/>") +
            "<body name='ball' shape='sphere' radius='0.2' mass='50' position='-0.9 0 0.45' velocity='0 0 -2'/>");
    const StepRecord record = rig.step();
    const double compliance = (a + b) * (a + b) / (I + m * a * a);
    const double blow = 2 / (1 / 50.0 + compliance);
    EXPECT_NEAR(-h * record.vessel->contact.force.z(), blow, 1e-9 * blow) << integrator;
    const double turn = -blow * (a + b) / (I + m * a * a);  // about y
    EXPECT_NEAR(rig.bodies().w_GB[0].y(), turn, 1e-6) << integrator;
    // the hull's momentum comes from the blow and from the rod, which pushes
    const double rod = m * a * turn + blow;
    EXPECT_NEAR(h * record.vessel->rods[0], rod, 1e-4 * std::abs(rod)) << integrator;
  }
}

TEST(VesselRods, HoldAHullAgainstACurrent) {
  // under water in a stream and without weight: the rod bears the drag
  for (const std::string integrator : {"semi-implicit-euler", "moreau"}) {
    Rig rig(test::steps_of(0.02) + test::k_no_weight + test::newton_contact(integrator, k_friction) +
            "<water density='1000' level='5'><current velocity='-1 0 0'/></water><hydro><drag form='1'/></hydro>" +
            test::box_vessel("position='0 0 0'", "<rod name='tie' at='1 0 0' to='6 0 0'/>", 500));
    StepRecord record;
    for (int k = 0; k < 50; ++k) record = rig.step();
    const double drag = record.vessel->hydro->force.x();
    EXPECT_LT(drag, -100);
    EXPECT_NEAR(record.vessel->rods[0], -drag, 1e-6 * -drag) << integrator;
    EXPECT_NEAR(rig.bodies().p_GB[0].x(), 0, 1e-9) << integrator;
  }
}

/// A barge that pitches on its hinge, its fore end on a strut to the quay, and a ball that drifts against it.
std::string moored(const std::string& integrator, double step) {
  return test::steps_of(step) + test::newton_contact(integrator, k_friction) +
         "<water density='1000' level='0'/><hydro><buoyancy/><drag/></hydro>" +
         test::box_vessel(
             "position='0 0 0'",
             "<part name='barge' joint='hinge' axis='0 1 0' at='1.05 0 0' position='2.1 0 0' shape='box' "
             "size='2 1 0.5' mass='600' stiffness='100'/>"
             "<rod name='strut' on='barge' at='3.1 0.2 0.1' to='5 2 0.6'/><rod name='tie' at='-1 -0.4 0' to='-2 -3 1'"
             " length='2.957'/>",
             600) +
         "<body name='ball' shape='sphere' radius='0.3' density='500' position='1.5 -0.9 0' velocity='0 1.5 0'/>";
}

TEST(VesselRods, KeepTheirAccountsAndBitsAfloatAndInContact) {
  for (const std::string integrator : {"semi-implicit-euler", "moreau"}) {
    Rig one(moored(integrator, 0.01), 1), two(moored(integrator, 0.01), 2);
    double touched = 0, lost = 0;
    for (int k = 0; k < 80; ++k) {
      const StepRecord record = one.step();
      ASSERT_EQ(record.state_hash, two.step().state_hash);
      touched = std::max(touched, record.vessel->contact.force.norm());
      lost = std::max(lost, std::abs(record.ledger.integrator));
      const bodies::Bodies& bodies = one.bodies();
      const Vec3 on_barge = bodies.p_GB[1] + bodies.R_GB[1] * Vec3(1, 0.2, 0.1);
      const Vec3 on_hull = bodies.p_GB[0] + bodies.R_GB[0] * Vec3(-1, -0.4, 0);
      ASSERT_NEAR((on_barge - Vec3(5, 2, 0.6)).norm(), Vec3(1.9, 1.8, 0.5).norm(), 1e-13);
      ASSERT_NEAR((on_hull - Vec3(-2, -3, 1)).norm(), 2.957, 1e-13);
      EXPECT_LT(record.vessel->parts[0].unbalanced_force, 1e-2);
    }
    EXPECT_GT(touched, 100);
    EXPECT_LT(std::abs(lost), integrator == "moreau" ? 1 : 10);
  }
}

TEST(VesselRods, SwingATowedHullAndBookTheWorkOfTheCarriage) {
  for (const std::string integrator : {"semi-implicit-euler", "moreau"}) {
    Rig rig(test::steps_of(0.01) + test::k_no_weight + test::newton_contact(integrator, k_friction) +
            test::box_vessel("position='0 0 0'",
                             "<carriage speed='0.5' free='sway'/><rod name='tie' at='0 0 0' to='0 4 0'/>"));
    StepRecord record;
    for (int k = 0; k < 300; ++k) record = rig.step();
    const double x = 1.5, across = std::sqrt(16 - x * x), sway = 0.5 * x / across;
    EXPECT_NEAR(rig.bodies().v_GB[0].y(), sway, 1e-7);
    // The work of the carriage is the energy of the sway.
    EXPECT_NEAR(record.ledger.works[0], 0.5 * 1000 * sway * sway, 1e-3);
  }
}

TEST(VesselRods, WhatCannotBeIsNamedWithItsLine) {
  const auto refused = [](const std::string& inside, const std::string& expected, const std::string& more = "") {
    const std::string vessel =
        "\n<vessel name='hull' hull='box.stl' position='0 0 0'><mass value='100'/>\n" + inside + "</vessel>";
    test::expect_refusal<std::exception>([&] { Rig(test::steps_of(0.01) + more + vessel); }, {expected});
  };
  const std::string rod = "<rod name='a' at='0 0 0' to='3 0 0'/>";
  refused("<rod at='0 0 0' to='3 0 0'/>", "name");
  refused("<rod name='a' to='3 0 0'/>", "at");
  refused("<rod name='a' at='0 0 0'/>", "to");
  refused("<rod name='a' at='0 0' to='3 0 0'/>", "scene.xml:3");
  refused("<rod name='a' at='0 0 0' to='3 0 0' length='0'/>", "> 0");
  refused("<rod name='a' on='pod' at='0 0 0' to='3 0 0'/>", "allowed: the vessel or one of its parts: hull");
  refused("<rod name='hull' at='0 0 0' to='3 0 0'/>", "the name 'hull' is taken by the element of line 2");
  refused(rod + "\n" + rod, "the name 'a' is taken by the element of line 3");
  refused("<fixed/>" + rod, "<fixed> holds the hull fast");
  refused("<carriage speed='1'/>" + rod, "no free axis holds the hull fast");
  refused(rod, "a vessel with <rod> allows: true", "<contact gyroscopic='false'/>");
  refused(rod, "'reference', which knows no rods", "<contact integrator='reference'/>");
  refused("<rod name='a' at='0 0 0' to='0 0 0'/>", "scene.xml:3: <rod name='a'>: both its ends are at one point");
  refused("<rod name='a' at='0 0 0' to='3 0 0' length='3.02'/>",
          "scene.xml:3: <rod name='a'>: its length is 3.02 m, but its ends are placed 3 m apart");
  refused(rod + "\n<rod name='b' at='0 0 0' to='3 0 0'/>", "scene.xml:4: <rod name='b'>: it holds nothing");
  refused(
      "<part name='pod' joint='weld' size='0.1 0.1 0.1' mass='1'/><fixed/>"
      "<rod name='a' on='pod' at='0 0 0' to='3 0 0'/>",
      "<rod name='a'>: it holds nothing");
  // the carriage moves along it, and the only free axis across
  refused("<carriage speed='1' free='heave'/>" + rod, "<rod name='a'>: it holds nothing");
}

TEST(VesselRods, AStartSpeedAlongThemIsRefused) {
  EXPECT_THROW(Rig(test::steps_of(0.01) +
                   test::box_vessel("position='0 0 0' velocity='1 0 0'", "<rod name='a' at='0 0 0' to='3 0 0'/>")),
               InputError);
}

}  // namespace vessel_rods_test
