/// The reference integrator against closed forms: events, free motion, water, friction.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/sim/simulation.h"
#include "tests/core/sim/scene_rig.h"
#include "tests/support/refusal.h"

namespace reference_test {

using namespace nilas;
using namespace nilas::sim;

struct Rig : test::SceneRig {
  using SceneRig::SceneRig;
  /// Steps until t, keeps all events, and sees to the accounts.
  StepRecord run(double t, double balance = 1e-10) {
    StepRecord record;
    while (simulation.time() < t - 1e-9) {
      record = simulation.step();
      events.insert(events.end(), record.events.begin(), record.events.end());
      EXPECT_LE(record.momentum_imbalance, balance * record.momentum_scale + 1e-13);
      EXPECT_LE(record.angular_momentum_imbalance, balance * record.angular_momentum_scale + 1e-13);
      EXPECT_FALSE(record.solver_short);
    }
    const double energy = std::abs(simulation.initial_ledger().kinetic) + std::abs(record.ledger.potential) +
                          std::abs(simulation.initial_ledger().potential);
    EXPECT_NEAR(record.ledger.imbalance, 0, balance * energy);
    return record;
  }
  std::vector<ContactEvent> of(ContactEventKind kind) const {
    std::vector<ContactEvent> found;
    for (const auto& event : events)
      if (event.kind == kind) found.push_back(event);
    return found;
  }

  std::vector<ContactEvent> events;
};

std::string contact(double mu = 0.3, double restitution = 0, const std::string& more = "") {
  return "<contact solver='newton' tolerance='1e-13' integrator='reference'><friction between='* *' kinetic='" +
         std::to_string(mu) + "' restitution='" + std::to_string(restitution) + "' " + more + "/></contact>";
}

const std::string k_ground = "<body name='ground' shape='plane' fixed='true'/>";
constexpr double g = 9.81;

TEST(Reference, AFreeThrowIsExact) {
  Rig rig(test::steps_of(0.1) + contact() +
          "<body shape='sphere' radius='0.1' mass='2' position='0 0 5' velocity='1 2 3'/>");
  rig.run(2);
  const Vec3 at(2, 4, 5 + 3 * 2 - 0.5 * g * 4);
  EXPECT_NEAR((rig.bodies().p_GB[0] - at).norm(), 0, 1e-12);
}

/// Falls h0, then bounces with speeds e^n v0 at t_n = t0 (1 + 2 (e + ... + e^n)); all is over at
/// T = t0 (1 + e)/(1 - e).
TEST(Reference, ABallBouncesAtItsInstantsAndComesToRest) {
  const double h0 = 1, radius = 0.1, t0 = std::sqrt(2 * h0 / g);
  for (const double e : {0.5, 0.8, 0.95}) {
    Rig rig(test::steps_of(0.05) + contact(0.3, e) + k_ground +
            "<body shape='sphere' radius='0.1' mass='2' position='0 0 1.1'/>");
    const double end = t0 * (1 + e) / (1 - e);
    rig.run(end + 0.3);
    const auto impacts = rig.of(ContactEventKind::impact);
    double t = t0, speed = g * t0;
    for (const auto& impact : impacts) {
      // slower ones feel the rounding of gaps that each bounce begins and ends with
      const double rounding = speed > 1e-3 ? 1e-9 : 1e-8;
      EXPECT_NEAR(impact.t, t, rounding);
      EXPECT_NEAR(impact.speed, speed, rounding);
      EXPECT_NEAR(impact.speed * impact.speed / (2 * g), h0 * std::pow(speed / (g * t0), 2), 1e-9) << "height";
      speed *= e;
      t += 2 * speed / g;
    }
    EXPECT_LT(speed, 2e-5) << "until bounces are slower than the threshold";
    const auto rest = rig.of(ContactEventKind::rest);
    ASSERT_EQ(rest.size(), 1u);
    // The tolerance is the remainder of the series that the threshold leaves out.
    EXPECT_NEAR(rest[0].t, end, 2 * 2e-5 / g / (1 - e));
    EXPECT_NEAR(rig.bodies().p_GB[1].z(), radius, 1e-9);
    EXPECT_NEAR(rig.bodies().v_GB[1].norm(), 0, 1e-9);
  }
}

TEST(Reference, AnElasticBallKeepsItsEnergyOverAThousandBounces) {
  Rig rig(test::steps_of(0.5) + contact(0, 1) + k_ground +
          "<body shape='sphere' radius='0.1' mass='1' position='0 0 0.3'/>");
  const double period = 2 * std::sqrt(2 * 0.2 / g);
  const StepRecord record = rig.run(1000.5 * period, 1e-8);
  EXPECT_GE(rig.of(ContactEventKind::impact).size(), 1000u);
  EXPECT_NEAR(record.ledger.kinetic + record.ledger.potential, g * 0.3, 1e-9 * g * 0.3);
  EXPECT_NEAR(rig.of(ContactEventKind::impact)[999].t, 999.5 * period, 1e-7);
}

/// Euler's equations in Jacobi's functions [Landau, Lifshitz, Mechanics, 37].
TEST(Reference, AFreeAsymmetricTop) {
  const double i1 = 1, i2 = 2, i3 = 3, w1 = 0.8, w3 = 1.3;
  Rig rig(test::steps_of(0.1) + contact() +
          "<gravity value='0 0 0'/><body shape='box' size='1 1 1' mass='1' "
          "inertia='1 2 3 0 0 0' angular_velocity='0.8 0 1.3'/>");
  const double twice_energy = i1 * w1 * w1 + i3 * w3 * w3, square = i1 * i1 * w1 * w1 + i3 * i3 * w3 * w3;
  ASSERT_GT(square, twice_energy * i2);
  const double rate = std::sqrt((i3 - i2) * (square - twice_energy * i1) / (i1 * i2 * i3));
  const double k = std::sqrt((i2 - i1) * (twice_energy * i3 - square) / ((i3 - i2) * (square - twice_energy * i1)));
  const double amplitude = std::sqrt((twice_energy * i3 - square) / (i2 * (i3 - i2)));
  for (const double t : {1.0, 5.0, 20.0}) {
    rig.run(t);
    double cn = 0, dn = 0;
    const double sn = boost::math::jacobi_elliptic(k, rate * t, &cn, &dn);
    const Vec3 w = rig.bodies().R_GB[0].transpose() * rig.bodies().w_GB[0];
    EXPECT_NEAR(w.x(), w1 * cn, 1e-9);
    EXPECT_NEAR(std::abs(w.y()), std::abs(amplitude * sn), 1e-9);
    EXPECT_NEAR(w.z(), w3 * dn, 1e-9);
    const Vec3 momentum = rig.bodies().inertia_G(0) * rig.bodies().w_GB[0];
    EXPECT_NEAR((momentum - Vec3(0.8, 0, 3.9)).norm(), 0, 1e-12);
  }
}

/// z'' = -omega^2 (z - z_0), omega = sqrt(rho g A/m), while the waterline stays on the sides.
TEST(Reference, AFloatingBoxHeaves) {
  Rig rig(test::steps_of(0.05) + contact() +
          "<water density='1000'/><hydro><buoyancy/></hydro>"
          "<body shape='box' size='2 1 0.5' mass='600' position='0 0 0.05'/>");
  const double level = 0.25 - 0.3, omega = std::sqrt(1000 * g * 2 / 600);
  for (const double t : {1.0, 4.0, 10.0}) {
    const StepRecord record = rig.run(t);
    EXPECT_NEAR(rig.bodies().p_GB[0].z(), level + 0.1 * std::cos(omega * t), 1e-9);
    EXPECT_NEAR(rig.bodies().v_GB[0].z(), -0.1 * omega * std::sin(omega * t), 1e-9);
    EXPECT_EQ(record.contacts, 0);
  }
}

/// v = v0/(1 + k v0 t), k = rho C A/(2 m); the work of drag is the kinetic energy that the motion lost.
TEST(Reference, QuadraticDrag) {
  Rig rig(test::steps_of(0.1) + contact() +
          "<gravity value='0 0 0'/><water density='1000'/><hydro><drag form='0.8' skin='0'/></hydro>"
          "<body shape='box' size='1 0.5 0.2' mass='100' position='0 0 -5' velocity='2 0 0'/>");
  const double k = 1000 * 0.8 * 0.1 / 200;
  for (const double t : {1.0, 10.0}) {
    const StepRecord record = rig.run(t);
    const double v = 2 / (1 + k * 2 * t);
    EXPECT_NEAR(rig.bodies().v_GB[0].x(), v, 1e-10);
    EXPECT_NEAR(rig.bodies().p_GB[0].x(), std::log(1 + k * 2 * t) / k, 1e-10);
    EXPECT_NEAR(record.ledger.works[0], 50 * (v * v - 4), 1e-8);
  }
}

TEST(Reference, ABlockSlidesToAStop) {
  Rig rig(test::steps_of(0.05) + contact(0.3) + k_ground +
          "<body shape='box' size='1 1 0.2' mass='5' position='0 0 0.1' velocity='2 1 0'/>");
  const double v0 = std::sqrt(5.0), stop = v0 / (0.3 * g), d = v0 * v0 / (2 * 0.3 * g);
  const StepRecord record = rig.run(stop + 0.5);
  EXPECT_NEAR(rig.bodies().p_GB[1].head<2>().norm(), d, 1e-8);
  EXPECT_NEAR(rig.bodies().p_GB[1].z(), 0.1, 1e-10);
  EXPECT_NEAR(rig.bodies().v_GB[1].norm(), 0, 1e-9);
  const auto sticks = rig.of(ContactEventKind::stick);
  ASSERT_FALSE(sticks.empty());
  EXPECT_NEAR(sticks[0].t, stop, 1e-9);
  EXPECT_NEAR(record.ledger.friction, 0.5 * 5 * 5, 1e-8);
}

/// A ball that slides without turning rolls after 2 v0/(7 mu g), with 5 v0/7.
TEST(Reference, ASlidingBallBeginsToRoll) {
  Rig rig(test::steps_of(0.05) + contact(0.2) + k_ground +
          "<body shape='sphere' radius='0.1' mass='5' position='0 0 0.1' velocity='2 0 0'/>");
  const double t = 2 * 2.0 / (7 * 0.2 * g);
  rig.run(t + 1);
  const auto sticks = rig.of(ContactEventKind::stick);
  ASSERT_EQ(sticks.size(), 1u);
  EXPECT_NEAR(sticks[0].t, t, 1e-8);
  EXPECT_NEAR(rig.bodies().v_GB[1].x(), 10.0 / 7, 1e-8);
  EXPECT_NEAR(rig.bodies().w_GB[1].y(), 100.0 / 7, 1e-7);
}

/// Two equal balls on a line, e = 1: the first stops, the second moves on. With a third at rest behind it, the third
/// moves.
TEST(Reference, ElasticBallsHandTheSpeedOn) {
  const std::string ball = "<body shape='sphere' radius='0.1' mass='1' position='";
  Rig rig(test::steps_of(0.1) + contact(0.3, 1) + "<gravity value='0 0 0'/>" + ball + "0 0 0' velocity='1 0 0'/>" +
          ball + "0.7 0 0'/>" + ball + "1.4 0 0'/>");
  rig.run(2);
  const auto impacts = rig.of(ContactEventKind::impact);
  ASSERT_EQ(impacts.size(), 2u);
  EXPECT_NEAR(impacts[0].t, 0.5, 1e-12);
  EXPECT_NEAR(impacts[1].t, 1.0, 1e-12);
  EXPECT_NEAR(rig.bodies().v_GB[2].x(), 1, 1e-11);
  EXPECT_NEAR(rig.bodies().v_GB[0].norm() + rig.bodies().v_GB[1].norm(), 0, 1e-11);
}

/// A ball on a slope of angle a rolls with 5/7 g sin a while mu > 2/7 tan a, else slips with g (sin a - mu cos a).
TEST(Reference, ABallOnASlope) {
  const double a = 0.5;
  const std::string gravity =
      "<gravity value='" + std::to_string(g * std::sin(a)) + " 0 " + std::to_string(-g * std::cos(a)) + "'/>";
  for (const double mu : {0.3, 0.1}) {
    Rig rig(test::steps_of(0.1) + contact(mu) + gravity + k_ground +
            "<body shape='sphere' radius='0.1' mass='2' position='0 0 0.1'/>");
    rig.run(1);
    const double expected =
        mu > 2.0 / 7 * std::tan(a) ? 5.0 / 7 * g * std::sin(a) : g * (std::sin(a) - mu * std::cos(a));
    EXPECT_NEAR(rig.bodies().p_GB[1].x(), 0.5 * expected, 2e-6) << "std::to_string keeps six digits";
    EXPECT_NEAR(rig.bodies().p_GB[1].z(), 0.1, 1e-10);
  }
}

/// A box dropped on a corner hits, rocks, and comes to rest on a face: every event keeps the accounts.
TEST(Reference, ATiltedBoxFallsAndComesToRest) {
  for (const double e : {0.0, 0.3}) {
    Rig rig(test::steps_of(0.05) + contact(0.5, e) + k_ground +
            "<body shape='box' size='1 0.8 0.6' mass='3' position='0 0 1' rotation_deg='20 10 30'/>");
    const StepRecord record = rig.run(4, 1e-9);
    EXPECT_NEAR(rig.bodies().p_GB[1].z(), 0.3, 1e-8);
    EXPECT_NEAR(rig.bodies().v_GB[1].norm() + rig.bodies().w_GB[1].norm(), 0, 1e-8);
    EXPECT_GT(record.ledger.impact, 0);
    EXPECT_GE(record.ledger.friction, 0);
  }
}

/// A ball that slides down a fixed one from rest at angle a without friction leaves it where cos = 2/3 cos a.
TEST(Reference, ABallLeavesASphereAtTwoThirds) {
  const double start = 0.2;
  Rig rig(test::steps_of(0.05) + contact(0) + "<body name='dome' shape='sphere' radius='1' fixed='true'/>" +
          fmt::format("<body shape='sphere' radius='0.1' mass='1' position='{:.17g} 0 {:.17g}'/>",
                      1.1 * std::sin(start), 1.1 * std::cos(start)));
  rig.run(1.2);
  const auto releases = rig.of(ContactEventKind::release);
  ASSERT_EQ(releases.size(), 1u);
  const double since = rig.simulation.time() - releases[0].t;  // in free fall
  const Vec3 left = rig.bodies().p_GB[1] - since * rig.bodies().v_GB[1] - 0.5 * since * since * g * Vec3::UnitZ();
  EXPECT_NEAR(left.z() / 1.1, 2.0 / 3 * std::cos(start), 1e-9);
  EXPECT_NEAR(left.norm(), 1.1, 1e-9);
}

/// A ball that slides off a table turns about its edge, without friction: at once the edge bears m (g cos - v^2/R).
TEST(Reference, ABallLeavesATableOverItsEdge) {
  const double radius = 0.1, v0 = 0.5, to_edge = 0.2;
  Rig rig(test::steps_of(0.05) + contact(0) +
          "<body name='table' shape='box' size='1 1 0.2' position='0 0 -0.1' fixed='true'/>"
          "<body shape='sphere' radius='0.1' mass='1' position='0.3 0 0.1' velocity='0.5 0 0'/>");
  rig.run(0.7, 1e-12);
  const double leaves = std::acos((v0 * v0 / (g * radius) + 2) / 3);
  const auto inverse_speed = [&](double angle) {
    return 1 / std::sqrt(v0 * v0 + 2 * g * radius * (1 - std::cos(angle)));
  };
  constexpr int k_intervals = 1000;  // Simpson's rule
  double sum = inverse_speed(0) + inverse_speed(leaves);
  for (int k = 1; k < k_intervals; ++k) sum += (k % 2 == 0 ? 2 : 4) * inverse_speed(k * leaves / k_intervals);
  const double t = to_edge / v0 + radius * sum * leaves / k_intervals / 3;
  const auto releases = rig.of(ContactEventKind::release);
  ASSERT_FALSE(releases.empty());
  EXPECT_NEAR(releases.back().t, t, 1e-8);
}

/// An overlap at the start is no store of energy: it stays, and the ledger closes.
TEST(Reference, BodiesThatOverlapAtTheStartGainNoEnergy) {
  Rig rig(test::steps_of(0.05) + contact(0) + k_ground +
          "<body shape='sphere' radius='0.1' mass='1' position='0 0 0.099' velocity='0.3 0 0'/>"
          "<body shape='box' size='0.3 0.3 0.2' mass='1' position='2 0 0.1'/>"
          "<body shape='box' size='0.2 0.2 0.2' mass='1' position='2.02 0.01 0.28' velocity='0.1 0 0'/>");
  rig.run(0.5, 1e-12);
  EXPECT_NEAR(rig.bodies().p_GB[1].z(), 0.099, 1e-9);
  EXPECT_NEAR(rig.bodies().p_GB[3].z(), 0.28, 1e-9);
}

/// The lowest point of a cap's rim races round where a box comes to lie on it almost flat.
TEST(Reference, ABoxFallsOnACap) {
  Rig rig(test::steps_of(0.01) + contact(0) +
          "<body name='pile' shape='cylinder' radius='0.2' height='1' fixed='true'/>"
          "<body shape='box' size='0.8 0.6 0.1' mass='2' position='0.01 0.005 0.5501' rotation_deg='0.0004 0.0001 0' "
          "velocity='0 0 -1'/>");
  rig.run(0.2, 1e-7);
}

/// Rolling, friction grows with the slope under the ball until it slips: the account of friction stays closed.
TEST(Reference, ABallRollsDownASphereThenSlipsThenLeaves) {
  Rig rig(test::steps_of(0.05) + contact(0.2, 0, "static='0.3'") +
          "<body name='dome' shape='sphere' radius='1' fixed='true'/>" +
          fmt::format("<body shape='sphere' radius='0.1' mass='1' position='{:.17g} 0 {:.17g}'/>", 1.1 * std::sin(0.2),
                      1.1 * std::cos(0.2)));
  const StepRecord record = rig.run(1.5, 1e-9);
  ASSERT_EQ(rig.of(ContactEventKind::slip).size(), 1u);
  ASSERT_EQ(rig.of(ContactEventKind::release).size(), 1u);
  EXPECT_LT(rig.of(ContactEventKind::slip)[0].t, rig.of(ContactEventKind::release)[0].t);
  EXPECT_GT(record.ledger.friction, 0);
}

TEST(Reference, ABoxFallsOnABoxAndBothComeToRest) {
  Rig rig(test::steps_of(0.05) + contact(0.3, 0.4) + k_ground +
          "<body shape='box' size='1 1 0.4' mass='5' position='0 0 0.2'/>"
          "<body shape='box' size='0.6 0.6 0.4' mass='2' position='0.1 0.05 0.9' rotation_deg='10 4 8'/>");
  const StepRecord record = rig.run(3, 1e-9);
  EXPECT_EQ(record.contacts, 8);
  EXPECT_NEAR(rig.bodies().p_GB[1].z(), 0.2, 1e-8);
  EXPECT_NEAR(rig.bodies().p_GB[2].z(), 0.6, 1e-8);
}

/// The points of contact change from corners of the box to crossings with the table's edge, and end.
TEST(Reference, ABoxSlidesOverAnEdge) {
  Rig rig(test::steps_of(0.05) + contact(0.3, 0.4) +
          "<body name='table' shape='box' size='2 2 1' fixed='true'/>"
          "<body shape='box' size='0.3 0.3 0.2' mass='5' position='0.5 0 0.6' velocity='3 0.4 0'/>");
  const StepRecord record = rig.run(1, 1e-9);
  EXPECT_EQ(record.contacts, 0);
  EXPECT_LT(rig.bodies().p_GB[1].z(), 0);
  EXPECT_GT(rig.bodies().w_GB[1].y(), 0.1) << "it tips forward";
  EXPECT_GT(record.ledger.friction, 1);
}

TEST(Reference, ASlabThatIsHitBreaksLooseSlidesAndStops) {
  Rig rig(test::steps_of(0.05) + contact(0.2, 0, "static='0.4'") + "<gravity value='0 0 -10'/>" + k_ground +
          "<body name='slab' shape='box' size='1 1 0.2' mass='5' position='0 0 0.1'/>"
          "<body name='ball' shape='sphere' radius='0.1' mass='5' position='-0.7 0 0.1' velocity='3 0 0'/>");
  rig.run(3, 1e-9);
  EXPECT_GT(rig.bodies().p_GB[1].x(), 0.1) << "hit, it slides";
  EXPECT_NEAR(rig.bodies().v_GB[1].norm(), 0, 1e-8) << "and stops";
}

/// A box that heaves, rolls and pitches freely: the time-stepping schemes come towards the reference with their orders.
TEST(Reference, TheSteppingSchemesConvergeToIt) {
  const auto end_pose = [](const std::string& integrator, double step) {
    Rig rig(test::steps_of(step) + "<contact integrator='" + integrator +
            "'/><water density='1000'/><hydro><buoyancy/></hydro>"
            "<body shape='box' size='2 1 0.5' mass='500' position='0 0 0.03' rotation_deg='0 3 5' "
            "angular_velocity='0.1 0 0.3'/>");
    while (rig.simulation.time() < 1 - 1e-9) rig.simulation.step();
    Vec6 pose;
    pose << rig.bodies().p_GB[0], 2 * rig.bodies().q_GB[0].vec();
    return pose;
  };
  const Vec6 truth = end_pose("reference", 0.05);
  EXPECT_NEAR((end_pose("reference", 0.2) - truth).norm(), 0, 1e-10) << "the output step has no part in it";
  const auto order = [&](const std::string& integrator) {
    const double coarse = (end_pose(integrator, 0.005) - truth).norm();
    const double fine = (end_pose(integrator, 0.00125) - truth).norm();
    EXPECT_LT(fine, 1e-2);
    return std::log(coarse / fine) / std::log(4.0);
  };
  EXPECT_NEAR(order("moreau"), 2, 0.1);
  EXPECT_NEAR(order("semi-implicit-euler"), 1, 0.1);
}

TEST(Reference, WhatItDoesNotTakeIsRefused) {
  const std::string ball = "<body shape='sphere' radius='0.1' mass='1'/>";
  const auto refusal = [](const std::string& body) {
    return test::refusal<SceneError>([&] { Rig rig(test::steps_of(0.1) + body); });
  };
  EXPECT_NE(refusal("<contact integrator='reference' law='ccp'/>" + ball).find("allowed: coulomb"), std::string::npos);
  EXPECT_NE(refusal("<contact integrator='reference' gyroscopic='false'/>" + ball).find("gyroscopic"),
            std::string::npos);
  EXPECT_NE(
      refusal("<contact integrator='reference'><friction between='* *' kinetic='0.1' rolling='0.01'/></contact>" + ball)
          .find("rolling"),
      std::string::npos);
  EXPECT_NE(refusal("<contact integrator='reference'/><body name='log' shape='cylinder' mass='1'/>").find("'log'"),
            std::string::npos);
  EXPECT_NE(refusal("<contact integrator='reference'/><fracture><crushing/></fracture>" + ball)
                .find("'reference' does not take <fracture>; allowed: ice that cannot break"),
            std::string::npos);
  EXPECT_NE(refusal("<contact integrator='reference'/><output checkpoint_every='1'/>" + ball).find("checkpoint"),
            std::string::npos);
}

/// Five boxes on the ground have twenty contacts at once.
TEST(Reference, TooManyContactsAtOnceAreSaidToBeSo) {
  const auto boxes = [](const std::string& z) {
    std::string text = k_ground;
    for (int k = 0; k < 5; ++k)
      text += "<body shape='box' size='1 1 1' mass='1' position='" + std::to_string(2 * k) + " 0 " + z + "'/>";
    return text;
  };
  EXPECT_THROW(Rig(test::steps_of(0.1) + contact() + boxes("0.5")), InputError);
  Rig falling(test::steps_of(1) + contact() + boxes("0.6"));
  EXPECT_THROW(falling.simulation.step(), SimulationError);
}

}  // namespace reference_test
