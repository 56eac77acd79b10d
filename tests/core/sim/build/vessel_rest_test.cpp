/// Tests of the vessel at rest on its carriage: its initial position and the readings of its balance there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/sim/simulation.h"
#include "core/vessel/model/cells.h"
#include "hydro/equilibrium.h"
#include "tests/core/sim/scene_rig.h"
#include "tests/support/refusal.h"

namespace vessel_rest_test {

using namespace nilas;
using namespace nilas::sim;

struct Rig : test::SceneRig {
  using SceneRig::SceneRig;
  std::size_t vessel() const { return static_cast<std::size_t>(simulation.vessel_index()); }
  Vec3 place() const { return simulation.bodies().p_GB[vessel()]; }
  Quat attitude() const { return simulation.bodies().q_GB[vessel()]; }
  double mass() const { return simulation.info().vessel_mass.mass; }
  const vessel::CarriageLoads& tare() const { return simulation.info().tare.value(); }
};

const std::string k_water = "<water density='1000' level='0'/><hydro><buoyancy/><drag/></hydro>";
const std::string k_six_cells = "<force_balance kind='six-cells' stiffness='1e7' damping='1e4'/>";

std::string integrator(const std::string& name) {
  return "<time step='0.01' end='1000'/><contact integrator='" + name + "'/>";
}

/// An icebreaker of 4 m, its centre of mass that of the whole hull: upright it is not in trim.
std::string ship(const std::string& carriage, const std::string& balance,
                 const std::string& mass = "<mass draught='0.3'/>", const std::string& position = "1 2") {
  return "<vessel name='ship' position='" + position +
         "' heading_deg='20'><hull generate='icebreaker' length='4' beam='1' draught='0.3' depth='0.6' "
         "triangles='600'/>" +
         mass + "<carriage joint='2 0.1 0.4' " + carriage + ">" + balance + "</carriage></vessel>";
}

/// A step's readings put together again: torque about the joint and force, in G.
Wrench reassembled(const vessel::CarriageLoads& loads, double length) {
  const Vec6 wrench =
      vessel::cell_wrenches(vessel::default_cells(0.25 * length)) * Eigen::Map<const Vec6>(loads.cells.data());
  const Quat R(Eigen::AngleAxisd(20 * k_deg, Vec3::UnitZ()));
  return {R * wrench.tail<3>(), R * wrench.head<3>()};
}

double largest_difference(const std::array<double, 6>& a, const std::array<double, 6>& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
  return most;
}

class VesselAtRest : public testing::TestWithParam<std::string> {};

TEST_P(VesselAtRest, ItsCellsReadTheStaticsWithoutRinging) {
  const auto deviation = [&](const std::string& start, double& largest) {
    Rig rig(integrator(GetParam()) + k_water + ship("free='heave'" + start, k_six_cells));
    const double weight = 9.81 * rig.mass();
    double most = 0;
    largest = 0;
    for (int k = 0; k < 100; ++k) {
      const StepRecord record = rig.simulation.step();
      const vessel::CarriageLoads& carried = *record.vessel->carriage;
      most = std::max(most, largest_difference(carried.cells, rig.tare().cells));
      for (const double reading : carried.cells) largest = std::max(largest, std::abs(reading));
      const Wrench sum = reassembled(carried, 4);
      EXPECT_NEAR((sum.force - carried.about_joint.force).norm(), 0, 1e-12 * weight);
      EXPECT_NEAR((sum.torque - carried.about_joint.torque).norm(), 0, 1e-12 * weight);
      if (!start.empty()) continue;
      // At rest the carriage holds the weight less the buoyancy.
      const Wrench& hydro = *record.vessel->hydro;
      EXPECT_NEAR((carried.about_com.force + hydro.force - Vec3(0, 0, weight)).norm(), 0, 1e-10 * weight);
      EXPECT_NEAR((carried.about_com.torque + hydro.torque).norm(), 0, 1e-10 * weight);
    }
    return most / weight;
  };
  double settled_peak = 0, placed_peak = 0;
  const double settled = deviation("", settled_peak), placed = deviation(" start='as-placed'", placed_peak);
  EXPECT_LT(settled, 1e-11) << "tared readings, over the weight: rounding of the buoyancy";
  EXPECT_GT(placed, 1e-2) << "what starting upright brings";
  EXPECT_GT(placed_peak, 1.5 * settled_peak);
}

TEST_P(VesselAtRest, AFreeHullStartsWhereItFloats) {
  Rig rig(integrator(GetParam()) + k_water + ship("free='heave roll pitch'", "<force_balance kind='rigid'/>"));
  const auto floating = hydro::floating_equilibrium(*rig.simulation.bodies().shape[rig.vessel()], rig.mass(),
                                                    Quat(Eigen::AngleAxisd(20 * k_deg, Vec3::UnitZ())), [] {
                                                      hydro::Water water;
                                                      water.density = 1000;
                                                      return water;
                                                    }());
  EXPECT_GT(std::abs(floating.trim), 1e-3);
  EXPECT_NEAR(rig.place().z(), floating.pose.p.z(), 1e-9);
  const Vec3 bow = rig.attitude() * Vec3::UnitX(), floating_bow = floating.pose.q * Vec3::UnitX();
  EXPECT_NEAR(bow.z(), floating_bow.z(), 1e-9);
  const Vec3 start = rig.place();
  for (int k = 0; k < 100; ++k) rig.simulation.step();
  EXPECT_NEAR((rig.place() - start).norm(), 0, 1e-11);
  EXPECT_NEAR(rig.simulation.bodies().w_GB[rig.vessel()].norm(), 0, 1e-11);
}

/// An arm that sags on its spring and a barge that floats at its hinge: hull, joints and cells start at rest.
TEST_P(VesselAtRest, SoAreItsParts) {
  const std::string parts =
      "<part name='arm' joint='hinge' axis='0 1 0' at='4 0 0.9' position='4.4 0 0.9' size='0.4 0.2 0.2' mass='20' "
      "stiffness='400' damping='20'/>"
      "<part name='barge' joint='hinge' axis='0 1 0' at='-0.2 0 0.4' position='-1.2 0 0.2' size='1.6 0.8 0.6' "
      "mass='300'/>";
  for (const std::string& balance : {k_six_cells, std::string("<force_balance kind='rigid'/>")}) {
    std::string vessel = ship("free='heave'", balance, "<mass value='600'/>", "1 2 -0.3");
    vessel.insert(vessel.find("</vessel>"), parts);
    Rig rig(integrator(GetParam()) + k_water + vessel);
    const double weight = 9.81 * (rig.mass() + 320);
    const Vec3 start = rig.place();
    for (int k = 0; k < 100; ++k) {
      const StepRecord record = rig.simulation.step();
      const vessel::CarriageLoads& carried = *record.vessel->carriage;
      ASSERT_LT(largest_difference(carried.cells, rig.tare().cells), 1e-10 * weight) << k;
      ASSERT_LT((carried.about_joint.force - rig.tare().about_joint.force).norm(), 1e-10 * weight) << k;
      ASSERT_LT((carried.about_joint.torque - rig.tare().about_joint.torque).norm(), 1e-10 * weight) << k;
      for (const PartRecord& part : record.vessel->parts) ASSERT_LT(part.rates.norm(), 1e-10) << k;
      // k a = m g l cos(a)
      const double a = record.vessel->parts[0].coordinates[0];
      ASSERT_NEAR(400 * a, 20 * 9.81 * 0.4 * std::cos(a), balance == k_six_cells ? 0.1 : 1e-8);
      ASSERT_GT(std::abs(record.vessel->parts[1].coordinates[0]), 1e-3);
    }
    EXPECT_LT((rig.place() - start).norm(), 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(BothIntegrators, VesselAtRest, testing::Values("semi-implicit-euler", "moreau"),
                         [](const auto& param) { return param.param == "moreau" ? "Moreau" : "Euler"; });

TEST(VesselRest, AHullPlacedAboveTheWaterStartsInIt) {
  Rig settled(integrator("moreau") + k_water + ship("free='heave'", k_six_cells, "<mass value='400'/>"));
  Rig above(integrator("moreau") + k_water + ship("free='heave'", k_six_cells, "<mass value='400'/>", "1 2 3"));
  EXPECT_NEAR(above.place().z(), settled.place().z(), 1e-9);
  EXPECT_LT(largest_difference(above.tare().cells, settled.tare().cells), 1e-6);
}

TEST(VesselRest, AsPlacedIsUprightAtThePosition) {
  const std::string mass = "<mass value='400' cog='2 0 0.3'/>";
  Rig placed(integrator("moreau") + k_water + ship("free='heave pitch' start='as-placed'", k_six_cells, mass, "1 2 3"));
  EXPECT_EQ(placed.place().z(), 3 + 0.3);
  EXPECT_NEAR((placed.attitude() * Vec3::UnitX()).z(), 0, 1e-15);
  Rig settled(integrator("moreau") + k_water + ship("free='heave pitch'", k_six_cells, mass, "1 2 3"));
  EXPECT_EQ(placed.tare().cells, settled.tare().cells) << "the tare is that of rest, wherever the run begins";
}

/// Weight alone, aslant: forces along the carriage's axes and their moment about the joint are those of statics.
TEST(VesselRest, TheTareIsThatOfStaticsUnderObliqueGravity) {
  Rig rig("<gravity value='3 -2 -9'/>" + integrator("moreau") +
          ship("", k_six_cells, "<mass value='400' cog='2.2 0.05 0.1'/>", "1 2 0"));
  const Wrench sum = reassembled(rig.tare(), 4);
  const Vec3 weight = 400 * Vec3(3, -2, -9);
  const Vec3 arm = Quat(Eigen::AngleAxisd(20 * k_deg, Vec3::UnitZ())) * Vec3(0.2, -0.05, -0.3);
  EXPECT_NEAR((sum.force + weight).norm(), 0, 1e-9 * weight.norm());
  // The cells deflect by a fraction of a millimetre.
  EXPECT_NEAR((sum.torque + arm.cross(weight)).norm(), 0, 2e-3 * weight.norm());
  const StepRecord record = rig.simulation.step();
  EXPECT_LT(largest_difference(record.vessel->carriage->cells, rig.tare().cells), 1e-10 * weight.norm());
}

TEST(VesselRest, WhatFallsHasNoTareAndWhatSinksIsRefused) {
  Rig falling(integrator("moreau") + ship("free='heave'", k_six_cells, "<mass value='400'/>", "1 2 0"));
  EXPECT_FALSE(falling.simulation.info().tare.has_value());
  EXPECT_NEAR((falling.attitude() * Vec3::UnitX()).z(), 0, 1e-15) << "as placed";
  const std::string heavy = "<mass value='1e5'/>";
  test::expect_refusal(
      [&] { Rig(integrator("moreau") + k_water + ship("free='heave'", k_six_cells, heavy, "1 2 0")); },
      {"scene.xml: <vessel name='ship'>: there is no static equilibrium", "would sink", "start=\"as-placed\""});
  Rig sinking(integrator("moreau") + k_water + ship("free='heave' start='as-placed'", k_six_cells, heavy, "1 2 0"));
  EXPECT_FALSE(sinking.simulation.info().tare.has_value());
}

TEST(VesselRest, APartThatNothingHoldsIsToldAndStartsAsPlaced) {
  for (const std::string start : {"", " start='as-placed'"}) {
    std::string vessel = ship("free='heave'" + start, k_six_cells, "<mass value='600'/>", "1 2 -0.3");
    vessel.insert(vessel.find("</vessel>"),
                  "<part name='arm' joint='hinge' axis='0 1 0' at='4 0 0.9' position='4.4 0 0.9' size='0.4 0.2 0.2' "
                  "mass='20'/>");
    Rig rig(integrator("moreau") + k_water + vessel);
    EXPECT_FALSE(rig.simulation.info().tare.has_value());
    EXPECT_NEAR(rig.place().z(), -0.3 + rig.simulation.info().vessel_mass.com.z(), 1e-15);
    long told = 0;
    for (const Fault& fault : rig.simulation.info().warnings)
      told += fault.message.find("part 'arm' finds no rest") != std::string::npos;
    EXPECT_EQ(told, start.empty() ? 1 : 0);
  }
}

/// The search for the rest of a part on a soft spring fails 50 m below. It must leave nothing behind.
TEST(VesselRest, ASearchThatFailsLeavesThePartWhereItIsPlaced) {
  for (const char* const scheme : {"moreau", "semi-implicit-euler"}) {
    Rig rig(integrator(scheme) +
            "<vessel><hull/><mass value='5e3'/><carriage start='as-placed'/>"
            "<part name='load' joint='slider' stiffness='198'/></vessel>");
    const auto part = static_cast<std::size_t>(rig.simulation.vessel_index()) + 1;
    const double before = rig.simulation.bodies().p_GB[part].z();
    const StepRecord record = rig.simulation.step();
    EXPECT_NEAR(rig.simulation.bodies().p_GB[part].z() - before, 0, 9.81 * 1e-4) << scheme;
    EXPECT_NEAR(record.ledger.imbalance, 0, 1e-8) << scheme;
  }
}

TEST(VesselRest, ThreadsAndCheckpointsKeepItsBits) {
  const std::string scene =
      integrator("moreau") + k_water + ship("free='heave pitch' speed='0.3' ramp='0.1'", k_six_cells);
  Rig one(scene), two(scene, 2), later(scene);
  EXPECT_EQ(one.tare().cells, two.tare().cells);
  for (int k = 0; k < 5; ++k) one.simulation.step();
  State state;
  one.simulation.save(StateWriter(state));
  later.simulation.restore(StateReader(state));
  EXPECT_EQ(one.tare().cells, later.tare().cells);
  for (int k = 0; k < 5; ++k) {
    const StepRecord a = one.simulation.step(), b = later.simulation.step();
    EXPECT_EQ(a.state_hash, b.state_hash);
    EXPECT_EQ(a.vessel->carriage->cells, b.vessel->carriage->cells);
  }
}

}  // namespace vessel_rest_test
