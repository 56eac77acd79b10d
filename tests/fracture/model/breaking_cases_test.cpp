/// Breaks in company: several in a step, floes that go altogether, other integrators, bodies whose numbers shift.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/core/sim/breaking_rig.h"

namespace breaking_cases_test {

using namespace nilas;
using namespace nilas::fracture;
using namespace nilas::test;

double mass_of_ice(const bodies::Bodies& bodies) {
  double sum = 0;
  for (std::size_t b = 0; b < bodies.id.size(); ++b)
    if (bodies.kind[b] == bodies::BodyKind::floe) sum += bodies.mass[b];
  return sum;
}

/// Goes on from here alike, saved and restored.
void expect_same_bits_after_restore(BreakingRig& rig, int steps) {
  State state;
  rig.simulation.save(StateWriter(state));
  sim::Simulation other(rig.scene, 1, rig.warnings);
  other.restore(StateReader(state));
  for (int k = 0; k < steps; ++k) ASSERT_EQ(rig.simulation.step().state_hash, other.step().state_hash) << k;
}

/// A bow between two sheets that mirror each other.
TEST(BreakingCases, TwoFloesBreakInOneStep) {
  BreakingRig rig(
      "<vessel hull='bow.stl' position='-0.02 0 0'><mass value='1000'/><carriage speed='0.3'/></vessel>"
      "<ice thickness='0.05' density='900' youngs_modulus='1e8'>"
      "<floe breakable='true' fixed='true' outline='0 0 9 0 9 5 0 5'/>"
      "<floe breakable='true' fixed='true' outline='0 -5 9 -5 9 0 0 0'/></ice>" +
      breaking_ice());
  const double mass = mass_of_ice(rig.bodies());
  const sim::StepRecord record = rig.until_broken();
  ASSERT_EQ(record.broken.size(), 2u);
  const FractureEvent &one = record.broken[0], &two = record.broken[1];
  EXPECT_EQ(one.floe, 2);
  EXPECT_EQ(two.floe, 3);
  ASSERT_EQ(one.pieces.size(), two.pieces.size());
  EXPECT_EQ(one.pieces.back() + 1, two.pieces.front()) << "numbers go on";
  EXPECT_NEAR(one.ratio, two.ratio, 1e-9);
  EXPECT_NEAR(one.p_G.y(), -two.p_G.y(), 1e-9);
  EXPECT_NEAR(mass_of_ice(rig.bodies()), mass, 1e-12 * mass);
  ASSERT_EQ(rig.bodies().size(), 1 + static_cast<int>(one.pieces.size() + two.pieces.size()));
  // the pieces are mirror images
  std::vector<double> left, right;
  for (const std::int64_t id : one.pieces) left.push_back(rig.bodies().mass[rig.bodies().index_of(id)]);
  for (const std::int64_t id : two.pieces) right.push_back(rig.bodies().mass[rig.bodies().index_of(id)]);
  std::sort(left.begin(), left.end());
  std::sort(right.begin(), right.end());
  for (std::size_t k = 0; k < left.size(); ++k) EXPECT_NEAR(left[k], right[k], 1e-9 * mass);
  expect_same_bits_after_restore(rig, 30);
}

TEST(BreakingCases, AFloeThatBecomesAllBrashIsGone) {
  BreakingRig rig(bow("fixed='true' outline='0 -2 3 -2 3 2 0 2'") +
                  "<fracture flexural_strength='5e4' compressive_strength='2e5' min_area='100' small_pieces='brash'>"
                  "<crushing model='explicit'/><bending/></fracture>");
  const double mass = mass_of_ice(rig.bodies());
  const sim::StepRecord record = rig.until_broken();
  ASSERT_EQ(record.broken.size(), 1u);
  EXPECT_TRUE(record.broken[0].pieces.empty());
  EXPECT_NEAR(record.broken[0].brash, mass, 1e-12 * mass);
  EXPECT_EQ(rig.simulation.total("brash_mass"), record.broken[0].brash);
  ASSERT_EQ(rig.bodies().size(), 1) << "the vessel";
  const sim::StepRecord next = rig.simulation.step();
  EXPECT_EQ(next.floes, 0);
  EXPECT_EQ(next.contacts, 0);
  EXPECT_EQ(next.vessel->contact.force, Vec3(0, 0, 0));
  expect_same_bits_after_restore(rig, 10);
}

/// The account of a break closes whatever moves the bodies, and the ice breaks at about the same load.
TEST(BreakingCases, MoreauBreaksAsSemiImplicitEulerDoes) {
  const std::string scene = bow("outline='0 -2 3 -1.5 3.5 1.5 0.1 2' velocity='-0.3 0.05 0'") + breaking_ice();
  BreakingRig euler(scene, 2.5e-3), moreau(scene, 2.5e-3, 1, "integrator='moreau'");
  const double mass = mass_of_ice(moreau.bodies());
  const sim::StepRecord expected = euler.until_broken(), record = moreau.until_broken();
  ASSERT_EQ(record.broken.size(), 1u);
  EXPECT_EQ(record.broken[0].kind, expected.broken[0].kind);
  EXPECT_NEAR(record.t, expected.t, 0.1 * expected.t);
  EXPECT_NEAR(record.broken[0].radius, expected.broken[0].radius, 0.1 * expected.broken[0].radius);
  EXPECT_NEAR(mass_of_ice(moreau.bodies()) + record.broken[0].brash, mass, 1e-12 * mass);
  const double scale = std::abs(record.ledger.kinetic) + std::abs(record.ledger.potential);
  EXPECT_LE(std::abs(record.broken[0].energy), 1e-12 * scale);
  EXPECT_LE(std::abs(record.ledger.imbalance), 1e-11 * scale);
  EXPECT_LE(record.momentum_imbalance, 1e-9 * record.momentum_scale);
  expect_same_bits_after_restore(moreau, 30);
}

/// A ball strikes the edge of a floe within the step, which ends there in its first part: the load is a mean over the
/// whole step, however it was cut.
TEST(BreakingCases, AnImpactThatCutsTheStepBreaksIce) {
  const auto struck = [](const std::string& contact) {
    BreakingRig rig(
        "<body shape='sphere' radius='0.05' mass='5' position='0.06 0 0.18' velocity='0 0 -6'/>"
        "<ice thickness='0.05' density='900' youngs_modulus='1e8'><floe breakable='true' outline='0 -2 3 -2 "
        "3 2 0 2'/></ice>" +
            breaking_ice(),
        0.01, 1, contact);
    const double mass = mass_of_ice(rig.bodies());
    const sim::StepRecord record = rig.until_broken(20);
    EXPECT_NEAR(mass_of_ice(rig.bodies()), mass, 1e-12 * mass);
    const double scale = std::abs(record.ledger.kinetic) + std::abs(record.ledger.potential);
    EXPECT_LE(std::abs(record.ledger.imbalance), 1e-11 * scale);
    EXPECT_LE(record.momentum_imbalance, 1e-9 * record.momentum_scale);
    expect_same_bits_after_restore(rig, 10);
    return record;
  };
  const sim::StepRecord whole = struck("integrator='semi-implicit-euler' substeps='1'"), cut = struck("substeps='4'");
  EXPECT_EQ(whole.parts, 1);
  EXPECT_GT(cut.parts, 1);
  ASSERT_EQ(cut.broken.size(), 1u);
  EXPECT_EQ(cut.t, whole.t);
  EXPECT_NEAR(cut.broken[0].ratio, whole.broken[0].ratio, 0.05 * whole.broken[0].ratio);
}

/// The box comes after the floes among the bodies: pieces that take a floe's place shift it, and the floe that it
/// crushes. It goes on as if nothing had broken.
TEST(BreakingCases, ABoxGoesOnCrushingAnotherFloe) {
  const auto scene = [](double bow_x) {
    return "<vessel hull='bow.stl' position='" + text(bow_x) +
           " 0 0'><mass value='1000'/><carriage speed='0.3'/></vessel>"
           "<ice thickness='0.05' density='900' youngs_modulus='1e8'>"
           "<floe breakable='true' fixed='true' outline='0 -5 9 -5 9 1.5 0 1.5'/>"
           "<floe breakable='true' fixed='true' outline='0 2 3 2 3 4 0 4'/></ice>"
           "<body name='box' shape='box' size='0.5 0.5 0.5' mass='60' position='-0.251 3 0.01' velocity='0.5 0 0'/>" +
           breaking_ice();
  };
  const std::string euler = "integrator='semi-implicit-euler'";
  BreakingRig breaks(scene(-0.02), 0.01, 1, euler), whole(scene(-3), 0.01, 1, euler);
  bool broken = false;
  int crushing = 0;
  for (int k = 0; k < 60; ++k) {
    const sim::StepRecord record = breaks.simulation.step();
    EXPECT_TRUE(whole.simulation.step().broken.empty());
    const auto box_of = [](const bodies::Bodies& bodies) {
      return static_cast<std::size_t>(std::find(bodies.name.begin(), bodies.name.end(), "box") - bodies.name.begin());
    };
    const std::size_t one = box_of(breaks.bodies()), other = box_of(whole.bodies());
    if (broken) {
      EXPECT_LT(one, other);
      crushing += whole.bodies().v_GB[other].x() > 1e-3 ? 1 : 0;
    }
    EXPECT_LE((breaks.bodies().v_GB[one] - whole.bodies().v_GB[other]).norm(), 1e-8) << k;
    EXPECT_LE((breaks.bodies().p_GB[one] - whole.bodies().p_GB[other]).norm(), 1e-8) << k;
    broken = broken || !record.broken.empty();
  }
  EXPECT_TRUE(broken);
  EXPECT_GT(crushing, 5) << "it still crushes after the break";
}

}  // namespace breaking_cases_test
