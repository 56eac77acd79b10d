/// Moored vessels in whole scenes: the start at rest, periods, accounts, bits over threads and a resumed run, breaks.
#include "core/sim/build/moored_vessel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/sim/build/build_world.h"
#include "core/sim/build/natural_periods.h"
#include "tests/core/sim/scene_rig.h"

namespace moored_vessel_test {

using namespace nilas;
using namespace nilas::sim;
using test::SceneRig;

const std::string k_water = "<water density='1000' level='0'/><hydro><buoyancy/><drag/></hydro>";

std::string line(const std::string& name, const Vec3& fairlead, const Vec3& anchor, const std::string& more) {
  const auto three = [](const Vec3& p) {
    return test::text(p.x()) + " " + test::text(p.y()) + " " + test::text(p.z());
  };
  return "<line name='" + name + "' fairlead='" + three(fairlead) + "' anchor='" + three(anchor) + "' " + more + "/>";
}

/// Four chains to the corners of a square in 20 m of water, around the hull box.stl (2 m x 1 m x 0.5 m, half afloat).
std::string spread(const std::string& attributes = "depth='20'", const std::string& of_third = "") {
  std::string lines;
  for (int k = 0; k < 4; ++k) {
    const Vec2 away = direction_of(k_pi / 4 + k * k_pi / 2);
    lines += line("m" + std::to_string(k + 1), {0.8 * away.x(), 0.4 * away.y(), 0}, {60 * away.x(), 60 * away.y(), -20},
                  "length='64.5' weight='1.5' stiffness='2e4' damping='20' " + (k == 2 ? of_third : ""));
  }
  return "<mooring " + attributes + ">" + lines + "</mooring>";
}
std::string scene(const std::string& integrator, const std::string& attributes, const std::string& mooring,
                  double step = 0.02) {
  return test::steps_of(step) + test::newton_contact(integrator, 0.2) + k_water +
         test::box_vessel(attributes, mooring, 500);
}

/// Vessel and lines stay where the search put them.
TEST(MooredVessel, StartsAtRest) {
  for (const std::string integrator : {"semi-implicit-euler", "moreau"}) {
    SceneRig rig(scene(integrator, "position='1.5 -0.7' heading_deg='8'", spread()));
    const Pose start{rig.bodies().q_GB[0], rig.bodies().p_GB[0]};
    // By symmetry the rest is in the middle, upright and along an axis of symmetry.
    EXPECT_NEAR(start.p.x(), 0, 1e-6);
    EXPECT_NEAR(start.p.y(), 0, 1e-6);
    EXPECT_LT(start.p.z(), 0);  // the lines' weight sinks the hull, which floats at z = 0 without them
    EXPECT_NEAR(start.q.angularDistance(Quat::Identity()), 0, 1e-6);
    for (int k = 0; k < 200; ++k) rig.simulation.step();
    EXPECT_LT((rig.bodies().p_GB[0] - start.p).norm(), 1e-5) << integrator;
    EXPECT_LT(rig.bodies().v_GB[0].norm(), 1e-5) << integrator;
  }
}

/// The weight of the hull and the vertical pull of all lines together displace water.
TEST(MooredVessel, SinksByThePullOfItsLines) {
  SceneRig rig(scene("moreau", "position='0 0'", spread()));
  WarningCounts& warnings = rig.warnings;
  const WorldParts parts = build_world(rig.scene, 1, warnings);
  const double pull = -mooring_at_start(parts).loads.on_hull.force.z();
  EXPECT_GT(pull, 50);  // four times what hangs of 1.5 N/m
  EXPECT_NEAR(parts.bodies.p_GB[0].z(), -pull / (1000 * 9.81 * 2), 1e-8);
}

/// A hull of mass m on lines of stiffness k swings with 2 pi sqrt(m/k). The period is measured between two passes of
/// the middle, without water and weight, at a small amplitude.
TEST(MooredVessel, SwingsWithTheNaturalPeriodOfItsReport) {
  const std::string start = "position='0 0 0' velocity='0.001 0 0'";
  SceneRig rig(test::steps_of(0.01) + test::k_no_weight + test::newton_contact("moreau", 0) +
               "<water density='1000' level='0'/>" +
               test::box_vessel(start,
                                "<mooring start='as-placed'><spring_line name='a' fairlead='1 0 0' anchor='30 0 0' "
                                "length='28' stiffness='300'/><spring_line name='b' fairlead='-1 0 0' anchor='-30 0 0' "
                                "length='28' stiffness='300'/></mooring>",
                                500));
  const WorldParts parts = build_world(rig.scene, 1, rig.warnings);
  double period = 0;
  for (const NaturalPeriod& mode : natural_periods(rig.scene, parts))
    if (mode.motion == "surge") {
      period = mode.period;
      EXPECT_EQ(mode.held_by(), "the mooring");
    }
  EXPECT_NEAR(period, 2 * k_pi * std::sqrt(500.0 / 600.0), 1e-9);
  double before = 0, first = -1, last = -1;
  int passes = 0;
  for (int k = 0; k < 3000; ++k) {
    rig.simulation.step();
    const double x = rig.bodies().p_GB[0].x(), t = rig.simulation.time();
    if (before < 0 && x >= 0) {
      last = t - 0.01 * x / (x - before);
      if (first < 0) first = last;
      ++passes;
    }
    before = x;
  }
  ASSERT_GT(passes, 3);
  // The scheme of second order has a relative error of about (h omega)^2 / 24.
  EXPECT_NEAR((last - first) / (passes - 1), period, 1e-5 * period);
}

/// Momenta and energy close with lines, drag and a body that drifts against the hull.
TEST(MooredVessel, KeepsItsAccounts) {
  for (const std::string integrator : {"semi-implicit-euler", "moreau"}) {
    SceneRig rig(scene(integrator, "position='0 0'", spread()) +
                 "<body name='ball' shape='sphere' radius='0.3' mass='60' position='-2 0.1 0' velocity='1 0 0'/>");
    double touched = 0;
    StepRecord record;
    for (int k = 0; k < 300; ++k) {
      record = rig.balanced_step(1e-9, 1e-9);
      touched += record.vessel->contact.force.norm();
    }
    EXPECT_GT(touched, 0);
    EXPECT_LT(std::abs(record.ledger.imbalance), 1e-9 * (std::abs(record.ledger.kinetic) + 500 * 9.81)) << integrator;
  }
}

TEST(MooredVessel, HasTheSameBitsWithThreadsAndAfterAResume) {
  const std::string text = scene("moreau", "position='0 0' velocity='1 0.5 0'", spread("depth='20'", "break_time='1'"));
  SceneRig one(text), three(text, 3);
  for (int k = 0; k < 40; ++k) one.simulation.step();
  State state;
  one.simulation.save(StateWriter(state));
  SceneRig resumed(text);
  resumed.simulation.restore(StateReader(state));
  for (int k = 0; k < 40; ++k) one.simulation.step();
  for (int k = 0; k < 40; ++k) resumed.simulation.step();
  for (int k = 0; k < 80; ++k) three.simulation.step();
  EXPECT_EQ(one.bodies().p_GB[0], three.bodies().p_GB[0]);
  EXPECT_EQ(one.bodies().q_GB[0].coeffs(), three.bodies().q_GB[0].coeffs());
  EXPECT_EQ(one.bodies().p_GB[0], resumed.bodies().p_GB[0]);
  EXPECT_EQ(one.bodies().q_GB[0].coeffs(), resumed.bodies().q_GB[0].coeffs());
}

/// After a line has broken the hull moves away from its anchor.
TEST(MooredVessel, LosesALine) {
  SceneRig rig(scene("moreau", "position='0 0'", spread("depth='20'", "break_time='0.5'")));
  StepRecord record;
  for (int k = 0; k < 250; ++k) record = rig.simulation.step();
  ASSERT_EQ(record.module_values.size(), 5u);  // four tensions and the number of broken lines
  EXPECT_EQ(record.module_values[2], 0);
  EXPECT_EQ(record.module_values[4], 1);
  EXPECT_GT(rig.bodies().p_GB[0].x(), 0.01);  // the third line led to -x, -y
  EXPECT_GT(rig.bodies().p_GB[0].y(), 0.01);
  EXPECT_EQ(rig.warnings.counts().count("mooring line 'm3' broke"), 1u);
}

std::string refusal(const std::string& text) {
  try {
    SceneRig rig(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// A chain of 50 m between ends that are more than 60 m apart: its strain would be 20 %.
TEST(MooredVessel, RefusesALineShorterThanItsSpan) {
  const auto with = [](const std::string& more) {
    return scene("moreau", "position='0 0 0'",
                 "\n<mooring depth='20' start='as-placed'>\n" +
                     line("short", {1, 0, 0}, {61, 0, -20}, "length='50' weight='1.5' stiffness='2e6' " + more) +
                     "</mooring>");
  };
  const std::string found = refusal(with(""));
  EXPECT_NE(found.find("<line name='short'>: its 50 m are shorter than the 63.2"), std::string::npos) << found;
  EXPECT_NE(found.find("allowed: at most 5 %"), std::string::npos) << found;
  EXPECT_NE(refusal(with("break_load='1e4'")).find("less than its break load of 1e+04 N"), std::string::npos);
  EXPECT_EQ(refusal(with("break_load='1e9'")), "");
}

/// Four springs hold a hull with trim, and a light line ends at a pole 19.9 m below it, 0.1 mm above the bed at rest.
/// From a level start Newton's steps lead through poses with that end below the bed, which cannot be computed. They are
/// too long, and the search finds the rest that it finds in deeper water.
TEST(MooredVessel, SeeksItsRestBesidePosesThatCannotBeComputed) {
  const auto moored = [](double depth, const std::string& start) {
    std::string lines;
    for (int k = 0; k < 4; ++k) {
      const Vec2 away = direction_of(k_pi / 4 + k * k_pi / 2);
      const std::string x = test::text(away.x()), y = test::text(away.y());
      lines += "<spring_line name='s" + std::to_string(k) + "' fairlead='" + x + " " + y + " 0' anchor='" +
               test::text(9 * away.x()) + " " + test::text(9 * away.y()) + " 0' length='7.5' stiffness='200'/>";
    }
    lines += line("pole", {0.9, 0, -19.9}, {60, 0, -19}, "length='60' weight='1e-5' stiffness='1e3'");
    return test::steps_of(0.02) + k_water + "<vessel name='hull' hull='box.stl' " + start +
           "><mass value='500' cog='0.1 0 0'/><mooring depth='" + test::text(depth) + "'>" + lines +
           "</mooring></vessel>";
  };
  SceneRig deep(moored(25, "position='0 0 0'"));
  const Pose rest{deep.bodies().q_GB[0], deep.bodies().p_GB[0]};
  const double pole = (rest.p + rest.q * Vec3(0.8, 0, -19.9)).z();
  for (const std::string start : {"position='0 0 0.1' heading_deg='20'", "position='0.5 0.3 0.24'"}) {
    SceneRig rig(moored(1e-4 - pole, start));
    EXPECT_LT((rig.bodies().p_GB[0] - rest.p).norm(), 1e-3) << start;
    EXPECT_LT(rig.bodies().q_GB[0].angularDistance(rest.q), 1e-3) << start;
  }
}

TEST(MooredVessel, RefusesAFairleadBelowTheBed) {
  const std::string found = refusal(
      scene("moreau", "position='0 0 0'",
            "<mooring depth='20'>" +
                line("deep", {1, 0, -30}, {61, 0, -20}, "length='65' weight='1.5' stiffness='2e6'") + "</mooring>"));
  EXPECT_NE(found.find("<line name='deep'>: the fairlead is at the height -30 m"), std::string::npos) << found;
}

/// All lines on a free turret: nothing holds the heading, so the search leaves it.
TEST(MooredVessel, KeepsItsHeadingOnATurret) {
  std::string lines;
  for (int k = 0; k < 3; ++k) {
    const Vec2 away = direction_of(0.3 + 2 * k * k_pi / 3);
    lines += line("m" + std::to_string(k), {0.5 + 0.2 * away.x(), 0.2 * away.y(), 0},
                  {60 * away.x(), 60 * away.y(), -20}, "length='64.5' weight='1.5' stiffness='2e4' turret='true'");
  }
  SceneRig rig(scene("moreau", "position='0 0' heading_deg='40'",
                     "<mooring depth='20'>" + lines + "<turret at='0.5 0 0'/></mooring>"));
  const Mat3& R = rig.bodies().R_GB[0];
  EXPECT_NEAR(std::atan2(R(1, 0), R(0, 0)), 40 * k_deg, 0.02);
  for (int k = 0; k < 100; ++k) rig.simulation.step();
  EXPECT_LT(rig.bodies().v_GB[0].norm(), 1e-4);
}

}  // namespace moored_vessel_test
