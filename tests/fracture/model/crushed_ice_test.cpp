/// Tests of crushed ice that is cut out of its floe: which ice is removed, which stays, and that the loads do not
/// change.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/geometry/mass_properties.h"
#include "tests/core/sim/crushing_rig.h"

namespace crushed_ice_test {

using namespace nilas;
using namespace nilas::fracture;
using namespace nilas::test;

constexpr double k_clear = 2e-3, k_density = 920, k_speed = 0.5;
/// Width of the ice that stays along a hull of width 0.4: an eighth of it, which is less than T/4.
constexpr double k_strip = 0.05;

std::string clearing(const std::string& model, const std::string& more = "") {
  return "<fracture compressive_strength='" + text(k_strength) + "' min_area='0.01' " + more + "><crushing " + model +
         " clear_volume='" + text(k_clear) + "'/></fracture>";
}

/// A box of this width that nothing stops. Its front is at x = -0.005, and it moves along x.
std::string box(double width, double y = 0) {
  return "<body name='box' shape='box' size='1 " + text(width) + " 2' mass='1e9' position='-0.505 " + text(y) +
         " 0' velocity='" + text(k_speed) + " 0 0'/>";
}

std::string sheet(const std::string& more, const std::string& corners = "0 -3 4 -3 4 3 0 3") {
  return "<ice thickness='" + text(k_thickness) + "'><floe breakable='true' " + more + " outline='" + corners +
         "'/></ice>";
}

double ice_area(const bodies::Bodies& bodies) {
  double area = 0;
  for (std::size_t b = 0; b < bodies.id.size(); ++b)
    if (bodies.kind[b] == bodies::BodyKind::floe) area += geometry::polygon_moments(bodies.shape[b]->outline).area;
  return area;
}

/// The channel is as wide as the box less the strips, up to a strip behind the front of the last cut.
TEST(CrushedIceCut, LeavesAChannelOfTheHullsWidth) {
  Rig rig(box(0.4) + sheet("fixed='true'") + clearing(k_seed), 0.01);
  double front = 0, crushing_energy = 0, extruded = 0;
  int cuts = 0;
  for (int k = 0; k < 150; ++k) {
    const sim::StepRecord record = rig.step();
    crushing_energy = record.ledger.crushing;
    for (const FractureEvent& event : record.broken) {
      EXPECT_EQ(event.kind, "crushing");
      EXPECT_GT(event.ratio, 1);
      EXPECT_EQ(event.pieces.size(), 1u);
      EXPECT_EQ(event.brash, 0);
      EXPECT_NEAR(event.extruded, event.ratio * k_clear * k_density, 1e-9 * event.extruded);
      extruded += event.extruded;
      front = rig.front(rig.hull());
      ++cuts;
    }
    if (front == 0) continue;
    const double channel = (0.4 - 2 * k_strip) * (front - k_strip);
    ASSERT_NEAR(ice_area(rig.bodies()), 24 - channel, 1e-9);
    ASSERT_NEAR(rig.simulation.total("extruded_mass"), channel * k_thickness * k_density, 1e-9);
  }
  EXPECT_GT(cuts, 15);
  EXPECT_NEAR(extruded, rig.simulation.total("extruded_mass"), 1e-9);
  EXPECT_EQ(rig.bodies().motion[1], bodies::Motion::fixed);
  EXPECT_EQ(rig.bodies().shape[1]->outline.size(), 8u);
  EXPECT_NEAR(rig.simulation.total("crushed_mass"), k_density * crushing_energy / k_strength, 1e-9);
}

/// Every face in front stands in ice as before, so forces and the energy of crushing are those of the whole outline.
TEST(CrushedIceCut, ChangesNoLoad) {
  for (const char* hull : {"wedge.stl", "flared.stl"})
    for (const std::string& model : {k_seed, k_compliant}) {
      Rig with(towed(hull, -0.13) + clearing(model), 0.01), without(towed(hull, -0.13) + crushing(model), 0.01);
      int cuts = 0;
      for (int k = 0; k < 150; ++k) {
        const sim::StepRecord a = with.step(), b = without.step();
        cuts += static_cast<int>(a.broken.size());
        const Vec3 force = a.vessel->contact.force, as_before = b.vessel->contact.force;
        ASSERT_LE((force - as_before).norm(), 1e-9 * (1 + as_before.norm())) << hull << model << k;
      }
      EXPECT_GT(cuts, 5);
    }
}

/// The solver leaves up to its tolerance times the mass in an impulse, and where a face is in several pieces of the
/// sheet, a growth that begins within the step in some of them is steeper, in what the speed changes in a step.
TEST(CrushedIceCut, ChangesNoLoadOnAPile) {
  const std::string pile =
      "<body name='pile' shape='cylinder' radius='0.3' height='2' mass='1e6' position='-0.305 0 0' velocity='0.5 0 "
      "0'/>";
  for (const std::string& model : {k_seed, k_compliant}) {
    Rig with(pile + sheet("fixed='true'") + clearing(model), 0.01);
    Rig without(pile + sheet("fixed='true'") + crushing(model), 0.01);
    int cuts = 0;
    for (int k = 0; k < 120; ++k) {
      const sim::StepRecord a = with.step(), b = without.step();
      cuts += static_cast<int>(a.broken.size());
      ASSERT_NEAR(a.ledger.crushing, b.ledger.crushing, 1e-6 * (1 + b.ledger.crushing)) << model << k;
    }
    EXPECT_GT(cuts, 5);
  }
}

/// A box slows down a free floe: removed ice takes its share of mass and energy, and nothing else changes.
TEST(CrushedIceCut, KeepsTheAccounts) {
  Rig rig("<body name='box' shape='box' size='1 0.4 2' mass='1' fixed='true' position='-0.505 0.3 0'/>" +
              sheet("velocity='-2 0 0'", "0 -1 4 -1 4 1 0 1") + clearing(k_compliant),
          0.005);
  const auto floe = [&] { return rig.bodies().mass[1 - rig.hull()]; };
  const double mass = floe();
  double left = 0;
  int cuts = 0;
  for (int k = 0; k < 200; ++k) {
    const sim::StepRecord record = rig.step();
    EXPECT_LE(std::abs(record.ledger.imbalance), 1e-12 * 0.5 * mass * 4);
    for (const FractureEvent& event : record.broken) {
      ++cuts;
      left += event.energy;
      EXPECT_GE(event.energy, 0) << "kinetic energy of what goes";
      EXPECT_LE(event.energy, 0.5 * event.extruded * 2 * 2);
    }
  }
  EXPECT_GT(cuts, 3);
  EXPECT_GT(left, 0);
  EXPECT_NEAR(floe() + rig.simulation.total("extruded_mass"), mass, 1e-12 * mass);
  EXPECT_NEAR(ice_area(rig.bodies()) * k_thickness * k_density, floe(), 1e-9 * mass);
}

/// A leaning side removes only the ice that is crushed through at the narrow end.
TEST(CrushedIceCut, TakesNoIceThatIsNotCrushedThrough) {
  Rig rig(towed("flared.stl", -0.13) + clearing(k_seed), 0.01);
  bool is_cut = false;
  for (int k = 0; k < 150; ++k) is_cut = !rig.step().broken.empty() || is_cut;
  ASSERT_TRUE(is_cut);
  const double tip_below = rig.front(0) - 0.5 - 0.5 * 0.5 * k_thickness;  // the edge leans out by 0.5 of the height
  const Vec3 centre = rig.bodies().p_GB[1];
  double deepest = 0;
  for (const Vec2& x : rig.bodies().shape[1]->outline)
    if (std::abs(x.y() + centre.y()) < 1) deepest = std::max(deepest, x.x() + centre.x());
  EXPECT_GT(deepest, 0);
  EXPECT_LT(deepest, tip_below);
}

TEST(CrushedIceCut, AFloeThatAHullRunsOverIsGone) {
  Rig rig(box(0.4) + sheet("fixed='true'", "0 -0.1 0.2 -0.1 0.2 0.1 0 0.1") + clearing(k_seed), 0.01);
  for (int k = 0; k < 200; ++k) rig.step();
  EXPECT_EQ(rig.bodies().size(), 1);
  EXPECT_NEAR(rig.simulation.total("extruded_mass") + rig.simulation.total("brash_mass"),
              k_density * k_thickness * 0.04, 1e-12);
}

/// A box comes down through the sheet: no hole is cut, and the ice is removed once the box comes out at the far edge.
TEST(CrushedIceCut, WaitsWhileAHullStandsInTheMidst) {
  Rig rig("<body name='box' shape='box' size='0.5 0.4 8' mass='1e9' position='3.2 0 4.2' velocity='0.5 0 -2'/>" +
              sheet("fixed='true'") + clearing(k_seed),
          0.01);
  const double reaches_edge = (4 - 3.45 + k_strip) / k_speed;
  for (int k = 0; k < 150; ++k) {
    const sim::StepRecord record = rig.step();
    if (std::abs(record.t - reaches_edge) > 0.001) {
      ASSERT_EQ(record.broken.empty(), record.t < reaches_edge) << record.t;
    }
    if (!record.broken.empty()) break;
  }
  EXPECT_EQ(rig.warnings.counts().count("crushed ice inside floes"), 1u);
  EXPECT_EQ(rig.warnings.counts().count("floes that could not be cut"), 0u);
  EXPECT_GT(rig.simulation.total("extruded_mass"), 0.9 * k_density * k_thickness * 0.275 * 0.375);
}

/// The last bridge goes, however little it is, and there are two floes.
TEST(CrushedIceCut, AHullThatGoesThroughPartsTheFloe) {
  for (const double clear : {3e-3, 5e-3, 7e-3}) {
    Rig rig(box(0.4) + sheet("fixed='true'", "0 -1 0.6 -1 0.6 1 0 1") +
                "<fracture compressive_strength='1e5' min_area='1e-4'><crushing clear_volume='" + text(clear) +
                "'/></fracture>",
            0.01);
    for (int k = 0; k < 200; ++k) rig.step();
    ASSERT_EQ(rig.bodies().size(), 3) << clear;
    EXPECT_NEAR(ice_area(rig.bodies()), 1.2 - 0.6 * (0.4 - 2 * k_strip), 1e-9);
  }
}

/// The remaining strip is an eighth of the width for a hull narrower than two strips.
TEST(CrushedIceCut, ANarrowHullLeavesAChannelToo) {
  Rig rig(box(0.1) + sheet("fixed='true'") + clearing(k_seed), 0.01);
  for (int k = 0; k < 200; ++k) rig.step();
  const double cut = 24 - ice_area(rig.bodies()), length = cut / 0.075;
  EXPECT_GT(length, 0.8);
  EXPECT_LT(length, rig.front(rig.hull()) - 0.0125 + 1e-9);
}

/// Two hulls in one floe: one comes in from the edge, the other stands where there is none.
TEST(CrushedIceCut, AHullInTheMidstStopsNoOther) {
  Rig rig(box(0.4, -1) +
              "<body name='pillar' shape='box' size='0.5 0.4 8' mass='1e9' position='2.5 1 4.2' velocity='0 0 -2'/>" +
              sheet("fixed='true'") + clearing(k_seed),
          0.01);
  for (int k = 0; k < 150; ++k) rig.step();
  const double cut = 24 - ice_area(rig.bodies());
  EXPECT_GT(cut, 0.8 * 0.275 * 0.6);
  EXPECT_EQ(rig.warnings.counts().count("floes that could not be cut"), 0u);
}

TEST(CrushedIceCut, GoesOnFromACheckpointWithTheSameBits) {
  const std::string content = box(0.4, 0.1) + sheet("velocity='-1.5 0.1 0'", "0 -1 4 -1 4 1 0 1");
  Rig whole(content + clearing(k_compliant), 0.01), rest(content + clearing(k_compliant), 0.01, 2);
  int cuts = 0;
  for (int k = 0; k < 40; ++k) cuts += static_cast<int>(whole.step().broken.size());
  EXPECT_GT(cuts, 2);
  State state;
  whole.simulation.save(StateWriter(state));
  rest.simulation.restore(StateReader(state));
  for (int k = 0; k < 40; ++k) ASSERT_EQ(rest.step().state_hash, whole.step().state_hash) << k;
  EXPECT_EQ(rest.simulation.total("extruded_mass"), whole.simulation.total("extruded_mass"));
}

}  // namespace crushed_ice_test
