/// The vessel under the theta scheme in whole steps: order, contacts at the middle pose, and the accounts.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/core/sim/scene_rig.h"

namespace moreau_vessel_test {

using namespace nilas;
using namespace nilas::sim;

struct Rig : test::SceneRig {
  using SceneRig::SceneRig;
  StepRecord step() { return balanced_step(1e-12, 1e-15); }
  StepRecord run(int steps) {
    StepRecord record;
    for (int k = 0; k < steps; ++k) record = step();
    return record;
  }
  std::size_t vessel() const { return static_cast<std::size_t>(simulation.vessel_index()); }
  Vec3 place() const { return bodies().p_GB[vessel()]; }
  Quat attitude() const { return bodies().q_GB[vessel()]; }
  Vec3 velocity() const { return bodies().v_GB[vessel()]; }
  Vec3 spin() const { return bodies().w_GB[vessel()]; }
};

std::string contact(const std::string& integrator, const std::string& stabilisation = "projection",
                    double restitution = 0) {
  return test::newton_contact(integrator, 0.2, restitution, stabilisation);
}

const std::string k_water = "<water density='1000' level='0'/><hydro><buoyancy/></hydro>";

std::string hull(const std::string& attributes, const std::string& inside) {
  return "<vessel name='ship' " + attributes +
         "><hull generate='wedge' length='4' beam='1' draught='0.3' depth='0.6' bow_length='1'/>" + inside +
         "</vessel>";
}

const std::string k_mass = "<mass draught='0.3'/>";

/// Heave, roll and pitch of a floating vessel that was set in motion: differences of successive halvings of the step.
TEST(MoreauVessel, AFloatingVesselConvergesInSecondOrder) {
  const auto end = [](const std::string& integrator, double step) {
    Rig rig(test::steps_of(step) + contact(integrator) + k_water +
            hull("position='0 0' velocity='0.1 0.05 0.1' angular_velocity='0.1 0.05 0.02'", k_mass));
    const StepRecord record = rig.run(static_cast<int>(std::lround(1 / step)));
    EXPECT_NEAR(record.ledger.imbalance, 0, 1e-9);
    Eigen::Matrix<double, 13, 1> state;
    state << rig.place(), rig.attitude().coeffs(), rig.velocity(), rig.spin();
    return state;
  };
  for (const std::string& integrator : {std::string("moreau"), std::string("semi-implicit-euler")}) {
    const auto a = end(integrator, 0.02), b = end(integrator, 0.01), c = end(integrator, 0.005);
    EXPECT_NEAR(std::log2((a - b).norm() / (b - c).norm()), integrator == "moreau" ? 2 : 1, 0.1) << integrator;
  }
}

/// Vertical sides: heave about the draught T with omega^2 = g / T; and its energy over many periods.
TEST(MoreauVessel, SmallHeaveIsTheOscillator) {
  const double omega = std::sqrt(9.81 / 0.3);
  const auto error = [&](double step) {
    Rig rig(test::steps_of(step) + contact("moreau") + k_water + hull("position='0 0' velocity='0 0 0.05'", k_mass));
    const double z0 = rig.place().z();
    rig.run(static_cast<int>(std::lround(1.5 / step)));
    return std::abs(rig.place().z() - z0 - 0.05 / omega * std::sin(1.5 * omega));
  };
  const double coarse = error(0.02), half = error(0.01), fine = error(0.005);
  EXPECT_LT(fine, 1e-3 * 0.05 / omega);
  EXPECT_NEAR(std::log2(coarse / half), 2, 0.1);
  EXPECT_NEAR(std::log2(half / fine), 2, 0.1);

  Rig rig(test::steps_of(0.01) + contact("moreau") + k_water + hull("position='0 0' velocity='0 0 0.05'", k_mass));
  const double start = rig.simulation.initial_ledger().kinetic + rig.simulation.initial_ledger().potential;
  double early = 0, late = 0;
  for (int k = 0; k < 10000; ++k) {
    const StepRecord record = rig.simulation.step();
    const double now = std::abs(record.ledger.kinetic + record.ledger.potential - start);
    if (k < 1000) early = std::max(early, now);
    if (k >= 9000) late = std::max(late, now);
  }
  EXPECT_LT(early, 2e-3 * rig.simulation.initial_ledger().kinetic);
  EXPECT_NEAR(late / early, 1, 0.1);
}

/// Every stabilisation, every kind of balance and a free vessel that is struck: the ledger closes to rounding.
TEST(MoreauVessel, ClosesItsAccounts) {
  const auto carriage = [](const std::string& kind, const std::string& free) {
    return "<carriage speed='0.5' ramp='0.5' joint='2 0 0.5'" + free + "><force_balance kind='" + kind +
           "'/></carriage>";
  };
  const std::vector<std::string> ways{"", carriage("rigid", ""), carriage("rigid", " free='heave roll pitch'"),
                                      carriage("prismatic", ""), carriage("six-cells", " free='heave pitch'")};
  for (const std::string stabilisation : {"none", "baumgarte", "split-impulse", "tasora", "projection"})
    for (const std::string& way : ways)
      for (const std::string theta : {"0.5", "1", "0.7"}) {
        Rig rig(
            test::steps_of(0.01) + contact("moreau' theta='" + theta, stabilisation, 0.4) +
            "<water density='1000' level='0'/><hydro><buoyancy/><drag form='1' skin='0.01'/></hydro>" +
            hull(way.empty() ? "position='0 0' velocity='0.5 0 0' angular_velocity='0.1 0.1 0.05'" : "position='0 0'",
                 k_mass + way) +
            "<body name='a' shape='box' size='0.6 0.6 0.2' mass='60' position='4.4 0.15 0'/>"
            "<body name='b' shape='box' size='0.6 0.6 0.2' mass='60' position='5.05 0.1 0'/>");
        double put_in = rig.simulation.initial_ledger().kinetic;
        double touching = 0;
        StepRecord record;
        for (int k = 0; k < 150; ++k) {
          record = rig.step();
          touching = std::max(touching, rig.simulation.last_problem().solution.r.norm());
        }
        for (const double work : record.ledger.works) put_in += std::abs(work);
        EXPECT_GT(touching, 0.1);
        EXPECT_LE(std::abs(record.ledger.imbalance), 1e-12 * put_in + 1e-10) << stabilisation << way << theta;
      }
}

/// A floe in front of a hull that runs up on its ramp goes as fast as the hull, which enters it by no more than its way
/// before the first impulses, h^2 a / 8: from then on the contact meets the hull where it will be at the next middle
/// pose.
TEST(MoreauVessel, AnAcceleratingHullDoesNotEnterTheFloe) {
  Rig rig(test::steps_of(0.01) + contact("moreau", "none") + "<gravity value='0 0 0'/>" +
          hull("position='0 0 0'",
               "<mass value='800'/><carriage speed='1' ramp='2'><force_balance kind='rigid'/>"
               "</carriage>") +
          "<body name='floe' shape='box' size='0.5 0.5 0.2' mass='20' position='4.25 0 0.3'/>");
  for (int k = 0; k < 150; ++k) {
    const StepRecord record = rig.step();
    EXPECT_LT(record.penetration_max, 0.5 * 1e-4 / 8 + 1e-9) << k;
  }
  EXPECT_NEAR(rig.simulation.bodies().v_GB[1].x(), 0.75, 1e-6);
  EXPECT_NEAR(rig.velocity().x(), 0.75, 1e-12);
}

/// A free vessel strikes a wall with e = 1: it leaves as fast as it came, to rounding, by every stabilisation.
TEST(MoreauVessel, AFreeVesselBounces) {
  for (const std::string stabilisation : {"none", "split-impulse", "projection"}) {
    Rig rig(test::steps_of(0.01) + contact("moreau", stabilisation, 1) + "<gravity value='0 0 0'/>" +
            hull("position='0 0 0' velocity='-0.5 0 0'", "<mass value='800' cog='2 0 0.3'/>") +
            "<body name='wall' shape='box' size='1 8 8' mass='1' position='-0.633 0 0' fixed='true'/>");
    const double start = rig.simulation.initial_ledger().kinetic;
    const StepRecord record = rig.run(100);
    EXPECT_GT(rig.velocity().x(), 0.1) << stabilisation;
    EXPECT_NEAR(record.ledger.kinetic, start, 1e-9 * start) << stabilisation;
    EXPECT_NEAR(record.ledger.imbalance, 0, 1e-11 * start) << stabilisation;
  }
}

/// A towed vessel with theta 1 moves as with semi-implicit Euler where no axis of its joint turns.
TEST(MoreauVessel, ThetaOneIsSemiImplicitEuler) {
  const auto towed = [](const std::string& integrator) {
    Rig rig(test::steps_of(0.01) + contact(integrator) + k_water +
            hull("position='0 0'",
                 k_mass + "<carriage speed='0.5' ramp='0.5' free='heave'><force_balance kind='rigid'/></carriage>") +
            "<body name='floe' shape='box' size='0.6 0.6 0.2' mass='60' position='4.4 0.15 0'/>");
    const StepRecord record = rig.run(150);
    EXPECT_GT(record.contacts, 0);
    return std::pair(rig.simulation.bodies().p_GB, record.vessel->carriage->about_com.force);
  };
  const auto a = towed("moreau' theta='1"), b = towed("semi-implicit-euler");
  for (std::size_t k = 0; k < a.first.size(); ++k) EXPECT_LT((a.first[k] - b.first[k]).norm(), 1e-8) << k;
  EXPECT_LT((a.second - b.second).norm(), 1e-5 * b.second.norm());
}

}  // namespace moreau_vessel_test
