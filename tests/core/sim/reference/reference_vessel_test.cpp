/// The reference integrator with a vessel: of one body and of several, against closed forms and the stepping schemes.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/numerics/event_ode.h"
#include "tests/core/sim/scene_rig.h"
#include "tests/support/refusal.h"

namespace reference_vessel_test {

using namespace nilas;
using namespace nilas::sim;

struct Rig : test::SceneRig {
  using SceneRig::SceneRig;
  StepRecord run(double t) {
    StepRecord record;
    while (simulation.time() < t - 1e-9) {
      record = simulation.step();
      test::expect_energy_kept(record, 1e-8);
    }
    return record;
  }
};

std::string settings(const std::string& integrator, double step, double friction = 0.3, double restitution = 0) {
  return "<time step='" + std::to_string(step) + "' end='1000'/><contact law='coulomb' solver='newton' " +
         "tolerance='1e-12' detection='speculative' stabilisation='" +
         std::string(integrator == "reference" ? "none" : "baumgarte") + "' integrator='" + integrator +
         "'><friction between='* *' static='" + std::to_string(friction) + "' kinetic='" + std::to_string(friction) +
         "' restitution='" + std::to_string(restitution) + "'/></contact>";
}

/// Two bars under a fixed hull: lengths 0.8 m and 0.6 m, masses 3 kg and 2 kg.
const std::string k_pendulum =
    "<vessel name='hull' hull='box.stl' position='0 0 3' heading_deg='30'><mass value='100'/><fixed/>"
    "<part name='one' joint='hinge' axis='0 1 0' at='0 2 0' position='0 2 -0.4' size='0.1 0.1 0.8' mass='3' "
    "angle_deg='50' rate_deg='-30'/>"
    "<part name='two' joint='hinge' to='one' axis='0 1 0' at='0 2 -0.8' position='0 2 -1.1' size='0.1 0.1 0.6' "
    "mass='2' angle_deg='-25' rate_deg='80'/></vessel>";

/// Angles to the vertical and their rates after `t`, by CVODE from Lagrange's equations.
VecX exact_pendulum(double t) {
  const double m1 = 3, m2 = 2, c1 = 0.4, c2 = 0.3, l = 0.8, g = 9.81;
  const double I1 = m1 / 12 * (0.8 * 0.8 + 0.1 * 0.1), I2 = m2 / 12 * (0.6 * 0.6 + 0.1 * 0.1);
  numerics::EventOde ode;
  ode.derivative = [=](double, const VecX& y, VecX& dy) {
    const double s = std::sin(y[0] - y[1]), c = std::cos(y[0] - y[1]), k = m2 * l * c2;
    Eigen::Matrix2d mass;
    mass << I1 + m1 * c1 * c1 + m2 * l * l, k * c, k * c, I2 + m2 * c2 * c2;
    const Vec2 force(-k * s * y[3] * y[3] - (m1 * c1 + m2 * l) * g * std::sin(y[0]),
                     k * s * y[2] * y[2] - m2 * c2 * g * std::sin(y[1]));
    dy.resize(4);
    dy << y.tail<2>(), mass.inverse() * force;
  };
  numerics::OdeSettings settings;
  settings.relative = 1e-13;
  settings.absolute = VecX::Constant(4, 1e-13);
  VecX y(4);
  y << 50 * k_deg, 25 * k_deg, -30 * k_deg, 50 * k_deg;
  numerics::OdeSolution solution(std::move(ode), settings, 0, y);
  solution.follow(t, y);
  return y;
}

TEST(ReferenceVessel, FollowsADoublePendulum) {
  Rig rig(settings("reference", 0.1) + k_pendulum);
  for (const double t : {0.5, 1.5, 3.0}) {
    const StepRecord record = rig.run(t);
    const VecX y = exact_pendulum(t);
    const auto& parts = record.vessel->parts;
    EXPECT_NEAR(parts[0].coordinates[0], y[0], 1e-9) << t;
    EXPECT_NEAR(parts[1].coordinates[0], y[1] - y[0], 1e-9) << t;
    EXPECT_NEAR(parts[0].rates[0], y[2], 1e-9) << t;
    EXPECT_NEAR(parts[1].rates[0], y[3] - y[2], 1e-9) << t;
    // Simbody's reactions are those of Newton's law on each part
    EXPECT_LT(parts[0].unbalanced_force + parts[0].unbalanced_torque, 1e-9);
  }
}

TEST(ReferenceVessel, AFreeHullIsTheFreeBodyThatItIs) {
  // the same box as a <body>: falls, lands on a corner, settles
  const std::string ground = "<body name='ground' shape='plane' fixed='true'/>", start = "0 0 0.9";
  const std::string inertia = "'8 20 25 0 0 0'";
  Rig vessel(settings("reference", 0.05) + ground + "<vessel name='box' hull='box.stl' position='" + start +
             "' angular_velocity='0.8 0.5 0.1'><mass value='60' inertia=" + inertia + "/></vessel>");
  Rig body(settings("reference", 0.05) + ground +
           "<body name='box' shape='mesh' mesh='box.stl' material='hull' position='" + start +
           "' angular_velocity='0.8 0.5 0.1' mass='60' inertia=" + inertia + "/>");
  double impulse = 0;
  for (int k = 0; k < 20; ++k) {
    impulse += 0.05 * vessel.simulation.step().vessel->contact.force.z();
    body.simulation.step();
    ASSERT_LT((vessel.bodies().p_GB[0] - body.bodies().p_GB[1]).norm(), 1e-8) << k;
    ASSERT_LT(vessel.bodies().q_GB[0].angularDistance(body.bodies().q_GB[1]), 1e-7) << k;
  }
  // contact has taken the momentum that weight gave
  EXPECT_NEAR(impulse, 60 * (9.81 * 1 + vessel.bodies().v_GB[0].z()), 1e-6);
}

TEST(ReferenceVessel, SchemesApproachABargeChainThatSlides) {
  // without friction, whose share among the corners is not unique
  const std::string scene =
      "<vessel name='hull' hull='box.stl' position='0 0 0.25' velocity='1.2 0 0'><mass value='800'/>"
      "<part name='barge' joint='hinge' axis='0 0 1' at='1.05 0 0' position='2.1 0 0' size='2 1 0.5' mass='500' "
      "stiffness='200' damping='50' rate_deg='20'/></vessel>"
      "<body name='ground' shape='plane' fixed='true'/>";
  Rig exact(settings("reference", 0.1, 0) + scene);
  exact.run(0.3);
  for (const auto& [integrator, order] : {std::pair("semi-implicit-euler", 1.0), std::pair("moreau", 2.0)}) {
    double last = 0;
    for (const double step : {0.01, 0.005}) {
      Rig rig(settings(integrator, step, 0) + scene);
      rig.run(0.3);
      const double error = (rig.bodies().p_GB[1] - exact.bodies().p_GB[1]).norm() +
                           (rig.bodies().v_GB[1] - exact.bodies().v_GB[1]).norm();
      if (last > 0) {
        EXPECT_NEAR(std::log2(last / error), order, 0.35) << integrator << " " << last << " " << error;
      }
      last = error;
    }
    EXPECT_LT(last, 0.01);
  }
}

TEST(ReferenceVessel, BouncesOnAPartKeepEnergyAndMomenta) {
  Rig rig("<gravity value='0 0 0'/>" + settings("reference", 0.1, 0, 1) +
          "<vessel name='hull' hull='box.stl'><mass value='100'/>"
          "<part name='arm' joint='ball' at='1.2 0 0' position='1.9 0 0' size='1.2 0.3 0.3' mass='10'/></vessel>"
          "<body name='ball' shape='sphere' radius='0.2' mass='5' position='2.3 0 0.8' velocity='0 0 -1'/>");
  const StepRecord record = rig.run(1);
  EXPECT_NEAR(record.ledger.kinetic, 2.5, 1e-9);
  EXPECT_LT(record.momentum_imbalance, 1e-9);
  EXPECT_GT(rig.bodies().v_GB[2].z(), -0.5);
}

TEST(ReferenceVessel, RefusesWhatItDoesNotTakeByName) {
  const auto refused = [](const std::string& vessel, const std::string& expected) {
    test::expect_refusal<SceneError>([&] { Rig(settings("reference", 0.1) + vessel); }, {expected});
  };
  refused(
      "<vessel name='v' hull='box.stl' position='0 0 1'><mass value='5'/><part name='post' joint='weld' "
      "shape='cylinder'/></vessel>",
      "the cylinder 'post' as a part of the vessel");
}

}  // namespace reference_vessel_test
