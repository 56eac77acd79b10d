/// Added mass in the time step: periods, contacts, momenta, energy, the flow, the vessel, checkpoints.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/sim/step/vessel_step.h"
#include "tests/core/sim/scene_rig.h"

namespace added_mass_test {

using namespace nilas;
using namespace nilas::sim;

using Rig = test::SceneRig;

std::string disc_floe(double radius, const std::string& attributes) {
  constexpr int k_corners = 360;
  std::string outline;
  for (int k = 0; k < k_corners; ++k) {
    const double angle = 2 * k_pi * k / k_corners;
    outline += test::text(radius * std::cos(angle)) + " " + test::text(radius * std::sin(angle)) + " ";
  }
  return "<ice density='920' thickness='1'><floe name='disc' outline='" + outline + "' " + attributes + "/></ice>";
}

/// The disc of 5 m radius and 1 m thickness heaves in 2 pi sqrt((m + 4/3 rho a^3)/(rho g A)) = 3.49 s.
TEST(AddedMass, ADiscHeavesInItsPeriod) {
  Rig rig(test::steps_of(0.01) + "<water density='1025'/><hydro><buoyancy/><added_mass/></hydro>" +
          disc_floe(5, "z='0.05'"));
  const double z0 = rig.bodies().p_GB[0].z() - 0.05;
  double before = 0.05, crossing = 0;
  int crossings = 0;
  for (int k = 1; k < 2000 && crossings < 2; ++k) {
    rig.simulation.step();
    const double now = rig.bodies().p_GB[0].z() - z0;
    if (before * now < 0) {
      if (++crossings == 1) crossing = 0.01 * (k - 1 + before / (before - now));
      if (crossings == 2) crossing = 0.01 * (k - 1 + before / (before - now)) - crossing;
    }
    before = now;
  }
  const double area = k_pi * 25, mass = 920 * area, added = 4.0 / 3 * 1025 * 125;
  const double period = 2 * k_pi * std::sqrt((mass + added) / (1025 * 9.81 * area));
  EXPECT_NEAR(period, 3.49, 0.01);
  EXPECT_NEAR(2 * crossing, period, 2e-3 * period);
}

const std::string k_two_plates =
    "<ice density='920' thickness='0.4'>"
    "<floe name='a' outline='0 0 3 0 3 1 0 1' velocity='0.8 0.1 0'/>"
    "<floe name='b' outline='3.2 0.3 5.2 0.3 5.2 1.6 3.2 1.6' velocity='-0.3 0 0'/></ice>";

/// Contacts feel the water's inertia: momenta balance and the energy account closes to rounding, in a current too.
TEST(AddedMass, CollidingPlatesKeepTheirAccounts) {
  for (const std::string integrator : {"moreau", "semi-implicit-euler"})
    for (const std::string current : {"0 0 0", "0.3 -0.2 0"}) {
      Rig rig(test::steps_of(0.01) + test::newton_contact(integrator, 0.3, 0.2) +
              "<water density='1000'><current velocity='" + current +
              "'/></water>"
              "<hydro><buoyancy/><drag/><added_mass floes='plate'/></hydro>" +
              k_two_plates);
      StepRecord record;
      int contacts = 0;
      for (int k = 0; k < 300; ++k) {
        record = rig.balanced_step(1e-12, 1e-12);
        contacts += record.contacts;
      }
      EXPECT_GT(contacts, 0);
      test::expect_energy_kept(record, 1e-10);
      EXPECT_GT(record.ledger.impact, 0);
    }
}

/// Without loads, a plate that drifts and turns keeps momentum, angular momentum and energy of body and water.
TEST(AddedMass, AFreePlateObeysKirchhoff) {
  Rig rig(test::k_no_weight + test::steps_of(0.02) +
          "<contact integrator='moreau'/><water density='1000'/><hydro><added_mass floes='plate'/></hydro>"
          "<ice density='920' thickness='0.4'><floe name='a' outline='0 0 4 0 4 1 0 1' velocity='0.7 0.4 0.1'/></ice>");
  const auto momenta = [&] {
    const bodies::Bodies& b = rig.bodies();
    Vec6 twist;
    twist << b.R_GB[0].transpose() * b.v_GB[0], b.R_GB[0].transpose() * b.w_GB[0];
    const Vec6 p = b.whole_mass_B(0) * twist;
    Vec6 in_G;
    in_G << b.R_GB[0] * p.head<3>(), b.R_GB[0] * p.tail<3>() + b.p_GB[0].cross(b.R_GB[0] * p.head<3>());
    return std::pair(in_G, 0.5 * twist.dot(p));
  };
  const auto [start, energy] = momenta();
  double spin = 0;
  for (int k = 0; k < 2000; ++k) {
    rig.simulation.step();
    spin = std::max(spin, rig.bodies().w_GB[0].norm());
  }
  const auto [end, energy_end] = momenta();
  EXPECT_GT(spin, 0.01) << "the Munk moment turns the plate";
  EXPECT_LT((end - start).norm(), 1e-10 * start.norm());
  EXPECT_NEAR(energy_end / energy, 1, 1e-11);
}

/// Seen from a flow, everything moves as in still water.
TEST(AddedMass, IsGalileiInvariant) {
  const auto end = [](const Vec3& flow) {
    const Vec3 v = Vec3(0.7, 0.4, 0) + flow;
    Rig rig(test::k_no_weight + test::steps_of(0.02) +
            "<contact integrator='moreau'/><water density='1000'><current velocity='" + test::text(flow.x()) + " " +
            test::text(flow.y()) +
            " 0'/></water><hydro><added_mass floes='plate'/></hydro>"
            "<ice density='920' thickness='0.4'><floe name='a' outline='0 0 4 0 4 1 0 1' velocity='" +
            test::text(v.x()) + " " + test::text(v.y()) + " 0'/></ice>");
    for (int k = 0; k < 500; ++k) rig.simulation.step();
    return std::pair(Vec3(rig.bodies().p_GB[0] - 10 * flow), Vec3(rig.bodies().w_GB[0]));
  };
  const auto [p, w] = end(Vec3::Zero());
  const auto [p_moved, w_moved] = end(Vec3(0.25, -0.5, 0));
  EXPECT_LT((p - p_moved).norm(), 1e-10);
  EXPECT_LT((w - w_moved).norm(), 1e-10);
}

/// A free vessel and a floe of the same box have the same motion under a load that acts for a while.
TEST(AddedMass, AFreeVesselMovesAsItsMassSays) {
  Rig rig(test::steps_of(0.01) +
          "<contact integrator='moreau'/><water density='1000'/>"
          "<hydro><buoyancy/><added_mass vessel='matrix' matrix='100 400 900 50 300 200'/></hydro>" +
          test::box_vessel("position='0 0' velocity='0 0 0.02'", "", 500));
  // omega^2 = rho g A / (m + a)
  const double omega = std::sqrt(1000 * 9.81 * 2 / 1400);
  const double z0 = rig.bodies().p_GB[0].z();
  for (int k = 0; k < 150; ++k) {
    const StepRecord record = rig.balanced_step(1e-11, 1e-11);
    test::expect_energy_kept(record, 1e-10);
  }
  EXPECT_NEAR(rig.bodies().p_GB[0].z() - z0, 0.02 / omega * std::sin(1.5 * omega), 1e-3 * 0.02 / omega);
}

/// The rig's force balance holds what accelerates vessel and water: the ramp of the carriage needs (m + a) dv/dt.
TEST(AddedMass, ATowedVesselIsHeldAgainstItsWater) {
  Rig rig(test::steps_of(0.01) +
          "<contact integrator='moreau'/><water density='1000'/>"
          "<hydro><buoyancy/><added_mass vessel='matrix' matrix='100 400 900 50 300 200'/></hydro>" +
          test::box_vessel("position='0 0'", "<carriage speed='1' ramp='2'/>", 500));
  StepRecord record;
  for (int k = 0; k < 100; ++k) {
    record = rig.balanced_step(1e-11, 1e-11);
    test::expect_energy_kept(record, 1e-10);
  }
  ASSERT_TRUE(record.vessel && record.vessel->carriage);
  EXPECT_NEAR(record.vessel->carriage->about_com.force.x(), 600 * 0.5, 1e-6);
  EXPECT_NEAR(record.vessel->hydro->force.x(), -100 * 0.5, 1e-6);
}

/// Towed obliquely at constant speed, the hull takes the Munk moment (A22 - A11) u v.
TEST(AddedMass, AnObliqueTowHasTheMunkMoment) {
  Rig rig(test::steps_of(0.01) +
          "<contact integrator='moreau'/><water density='1000'/>"
          "<hydro><added_mass vessel='matrix' matrix='100 400 900 50 300 200'/></hydro>" +
          test::k_no_weight +
          test::box_vessel("position='0 0 0' heading_deg='30'", "<carriage speed='1' heading_deg='0'/>", 500));
  StepRecord record;
  for (int k = 0; k < 20; ++k) record = rig.balanced_step(1e-11, 1e-11);
  const double u = std::cos(k_pi / 6), v = -std::sin(k_pi / 6);
  EXPECT_NEAR(record.vessel->hydro->torque.z(), -(400.0 - 100.0) * u * v, 1e-6);
}

TEST(AddedMass, ResumesWithTheSameBits) {
  const std::string inside = test::steps_of(0.01) + test::newton_contact("moreau", 0.3) +
                             "<water density='1000'/><hydro><buoyancy/><drag/><added_mass floes='auto' vessel='matrix' "
                             "matrix='100 400 900 50 300 200'/></hydro>" +
                             test::box_vessel("position='-3 0.4' velocity='0.9 0 0'", "", 500) + k_two_plates;
  Rig whole(inside), first(inside), rest(inside, 2);
  for (int k = 0; k < 150; ++k) first.simulation.step();
  State state;
  first.simulation.save(StateWriter(state));
  rest.simulation.restore(StateReader(state));
  StepRecord of_whole, of_rest;
  for (int k = 0; k < 300; ++k) of_whole = whole.simulation.step();
  for (int k = 150; k < 300; ++k) of_rest = rest.simulation.step();
  EXPECT_EQ(of_rest.state_hash, of_whole.state_hash);
}

/// A quarter turn of the scene turns its motion.
TEST(AddedMass, TurnsWithTheScene) {
  const auto end = [](const std::string& floes) {
    Rig rig(test::steps_of(0.01) + test::newton_contact("moreau", 0.3) +
            "<water density='1000'/><hydro><buoyancy/><added_mass floes='plate'/></hydro>" + floes);
    for (int k = 0; k < 200; ++k) rig.simulation.step();
    return std::pair(Vec3(rig.bodies().p_GB[1]), Vec3(rig.bodies().w_GB[1]));
  };
  const auto [p, w] = end(k_two_plates);
  const auto [q, u] =
      end("<ice density='920' thickness='0.4'>"
          "<floe name='a' outline='0 0 0 3 -1 3 -1 0' velocity='-0.1 0.8 0'/>"
          "<floe name='b' outline='-0.3 3.2 -0.3 5.2 -1.6 5.2 -1.6 3.2' velocity='0 -0.3 0'/></ice>");
  EXPECT_LT((Vec3(-p.y(), p.x(), p.z()) - q).norm(), 1e-8);
  EXPECT_LT((Vec3(-w.y(), w.x(), w.z()) - u).norm(), 1e-7);
}

}  // namespace added_mass_test
