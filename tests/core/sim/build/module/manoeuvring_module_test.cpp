/// Scenes with <manoeuvring> and <manoeuvre> in the time step, with the added mass in the vessel's mass.
#include "core/sim/build/module/manoeuvring_module.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "tests/core/sim/scene_rig.h"
#include "tests/support/refusal.h"

namespace nilas::sim {
namespace manoeuvring_module_test {

using Rig = test::SceneRig;

/// A box of the length of KVLCC2, amidships at its origin, with her mass, inertia and centre of mass; it needs no
/// weight.
std::string tanker(const std::string& inside, const std::string& velocity = "7.974 0 0") {
  return "<vessel hull='tanker.stl' position='0 0 0' velocity='" + velocity +
         "'><mass value='3.20415e8' cog='11.2 0 0' inertia='1e12 2e12 2.050656e12 0 0 0'/>" + inside + "</vessel>";
}

const Rig::Files& files() {
  static const Rig::Files all = [] {
    const test::ScratchFolder folder;
    geometry::write_stl(geometry::box_shape(Vec3(320, 58, 30)).surface, folder / "tanker.stl");
    std::ifstream in(folder / "tanker.stl", std::ios::binary);
    return Rig::Files{{"tanker.stl", std::string(std::istreambuf_iterator<char>(in), {})}};
  }();
  return all;
}

std::string open_sea(const std::string& inside, const std::string& contact = "", double step = 0.2) {
  return test::steps_of(step) + test::k_no_weight + contact + "<water density='1025'/>" + inside;
}

double figure(const Simulation& simulation, const std::string& name) {
  for (const auto& [module, figures] : simulation.figures())
    for (const bodies::RunFigure& f : figures)
      if (f.name == name) return f.value;
  return std::nan("");
}

const std::string k_circle = tanker("<manoeuvring preset='kvlcc2'/><manoeuvre kind='turning-circle'/>");

/// A mass of 3e8 kg at 8 m/s: the last digit of its momentum and of its angular momentum [N s, N m s].
constexpr double k_rounding = 1e-4;

/// The figures of an independent integration of the equations; the steps of 0.2 s begin the rudder one step late, 1.6 m
/// or 0.005 L, and are of first order.
TEST(ManoeuvringModule, TurnsAsTheEquationsSay) {
  for (const std::string integrator : {"moreau", "semi-implicit-euler"}) {
    Rig rig(open_sea(k_circle, "<contact integrator='" + integrator + "'/>"), 1, files());
    StepRecord record;
    for (int k = 0; k < 2000; ++k) record = rig.balanced_step(1e-11, k_rounding);
    EXPECT_NEAR(figure(rig.simulation, "advance_m") / 320, 2.974, 0.02) << integrator;
    EXPECT_NEAR(figure(rig.simulation, "tactical_diameter_m") / 320, 3.001, 0.02) << integrator;
    EXPECT_LT(std::abs(record.ledger.imbalance), 1e-9 * record.ledger.kinetic) << integrator;
    EXPECT_LT(std::abs(rig.bodies().p_GB[0].z()), 1e-6);
    EXPECT_LT(rig.bodies().p_GB[0].y(), 0) << "to starboard";
  }
}

/// At the rate that the builder found, a straight course keeps its speed to rounding.
TEST(ManoeuvringModule, HoldsItsSpeed) {
  Rig rig(open_sea(tanker("<manoeuvring preset='kvlcc2'/><manoeuvre kind='straight'/>")), 1, files());
  for (int k = 0; k < 500; ++k) rig.simulation.step();
  EXPECT_NEAR(rig.bodies().v_GB[0].x(), 7.974, 1e-10);
  EXPECT_EQ(rig.bodies().v_GB[0].y(), 0);
  EXPECT_NEAR(figure(rig.simulation, "mean_speed_m_s"), 7.974, 1e-10);
}

/// A current carries the ship along and changes nothing else.
TEST(ManoeuvringModule, ACurrentCarriesTheShip) {
  const auto run = [&](const std::string& water, const std::string& velocity) {
    Rig rig(test::steps_of(0.2) + test::k_no_weight + water +
                tanker("<manoeuvring preset='kvlcc2'/><manoeuvre kind='turning-circle'/>", velocity),
            1, files());
    for (int k = 0; k < 1000; ++k) rig.simulation.step();
    return rig.bodies().p_GB[0];
  };
  const Vec3 still = run("<water density='1025'/>", "7.974 0 0");
  const Vec3 carried = run("<water density='1025'><current velocity='0.5 -0.3 0'/></water>", "8.474 -0.3 0");
  EXPECT_LT((carried - still - 200 * Vec3(0.5, -0.3, 0)).norm(), 1e-5);
}

/// A resumed run and the run that went on have the same bits.
TEST(ManoeuvringModule, ContinuesFromACheckpoint) {
  for (const std::string manoeuvre :
       {"kind='turning-circle'", "kind='zigzag' angle_deg='20'", "kind='course' heading_deg='30'"}) {
    const std::string scene = open_sea(tanker("<manoeuvring preset='kvlcc2'/><manoeuvre " + manoeuvre + "/>"));
    Rig whole(scene, 1, files()), resumed(scene, 1, files());
    for (int k = 0; k < 300; ++k) whole.simulation.step();
    State state;
    whole.simulation.save(StateWriter(state));
    resumed.simulation.restore(StateReader(state));
    StepRecord a, b;
    for (int k = 0; k < 300; ++k) {
      a = whole.simulation.step();
      b = resumed.simulation.step();
    }
    EXPECT_EQ(a.state_hash, b.state_hash) << manoeuvre;
    EXPECT_EQ(a.module_values, b.module_values) << manoeuvre;
  }
}

/// The floe far away does not drift, the ship hits nothing: only the log tells that drag leaves the plane out.
TEST(ManoeuvringModule, TellsWhatItDoes) {
  Rig rig(test::steps_of(0.2) + "<water density='1025'/><hydro><buoyancy/><drag/></hydro>" + k_circle, 1, files());
  std::string all;
  for (const auto& [name, reason] : rig.simulation.info().modules) all += name + ": " + reason + "\n";
  EXPECT_NE(all.find("manoeuvring: <manoeuvring>: model mmg, kvlcc2, propeller at 1.778 1/s; <drag> leaves"),
            std::string::npos)
      << all;
  EXPECT_NE(all.find("on the vessel in heave, roll and pitch only"), std::string::npos) << all;
  EXPECT_NE(all.find("manoeuvre: <manoeuvre>: turning-circle from 0 s"), std::string::npos) << all;
}

/// The supply vessel of the preset has no rudder: it sails straight on, and cannot be steered.
TEST(ManoeuvringModule, RefusesToSteerAShipWithoutRudder) {
  const auto supply = [](const std::string& kind) {
    return open_sea(
        tanker("<manoeuvring model='derivatives' preset='supply' length='320'/><manoeuvre kind='" + kind + "'/>"));
  };
  for (const std::string kind : {"turning-circle", "zigzag", "course"})
    test::expect_refusal<InputError>([&] { Rig(supply(kind), 1, files()); },
                                     {"scene.xml", "<manoeuvre kind>", "found '" + kind + "'",
                                      "preset 'supply' has no rudder", "allowed: kind=\"straight\""});
  Rig straight(supply("straight"), 1, files());
  straight.simulation.step();
}

TEST(ManoeuvringModule, RefusesSpeedsBeyondThePropeller) {
  test::expect_refusal<InputError>(
      [] { Rig(open_sea(tanker("<manoeuvring preset='kvlcc2'/>", "9.5 0 0")), 1, files()); },
      {"<vessel velocity>", "8.97", "found 9.5 m/s"});
  test::expect_refusal<InputError>(
      [] { Rig(open_sea(tanker("<manoeuvring preset='kvlcc2' propeller='3'/>")), 1, files()); },
      {"<vessel><manoeuvring propeller>", "found 3 1/s", "at most 2 1/s"});
}

}  // namespace manoeuvring_module_test
}  // namespace nilas::sim
