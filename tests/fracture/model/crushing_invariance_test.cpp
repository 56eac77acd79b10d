/// Crushing whatever the frame, the order, the threads; in a field; over a checkpoint; and where it is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/core/sim/crushing_rig.h"
#include "tests/support/mirrored.h"

namespace crushing_invariance_test {

using namespace nilas;
using namespace nilas::fracture;
using namespace nilas::test;

TEST(Crushing, DoesNotDependOnTheFrame) {
  for (const std::string& model : {k_seed, k_compliant}) {
    Rig straight(towed("flared.stl", -0.13) + crushing(model), 0.01, 1, "", 0.1);
    Rig at_angle(towed("flared.stl", -0.13, 33) + crushing(model), 0.01, 1, "", 0.1);
    for (int k = 0; k < 100; ++k) {
      const Vec3 expected = straight.step().vessel->contact.force, force = at_angle.step().vessel->contact.force;
      const Vec2 back = turned(-33, force.x(), force.y());
      EXPECT_LE((Vec3(back.x(), back.y(), force.z()) - expected).norm(), 1e-8 * (1 + expected.norm())) << k;
    }
  }
}

TEST(Crushing, MirroredScenesHaveMirroredForces) {
  const auto scene = [](double side) {
    const auto corner = [&](double x, double y) { return text(x) + " " + text(side * y) + " "; };
    return "<vessel hull='flared.stl' position='-0.13 " + text(0.2 * side) +
           " 0'><mass value='1000'/><carriage speed='0.5'/></vessel><ice thickness='0.25'><floe fixed='true' "
           "breakable='true' outline='" +
           corner(0, -0.3) + corner(2, -1) + corner(2, 1) + corner(0.1, 0.6) + "'/></ice>" + crushing(k_compliant);
  };
  Rig port(scene(1), 0.01, 1, "", 0.1), starboard(scene(-1), 0.01, 1, "", 0.1);
  for (int k = 0; k < 100; ++k) {
    const Vec3 p = port.step().vessel->contact.force, s = starboard.step().vessel->contact.force;
    EXPECT_LE((p - mirrored(s)).norm(), 1e-9 * (1 + p.norm()));
  }
}

const std::string k_each_other = k_compliant + " between_floes='true'";

/// A ship into floating floes.
std::string field(bool reversed = false) {
  std::string floes;
  for (int k = 0; k < 6; ++k) {
    const int i = reversed ? 5 - k : k;
    const double x = 0.05 + 0.75 * (i / 2), y = i % 2 == 0 ? 0.02 : -0.72;
    floes += "<floe breakable='true' outline='" + outline(0, {{x, y}, {x + 0.7, y}, {x + 0.7, y + 0.7}, {x, y + 0.7}}) +
             "'/>";
  }
  return "<water density='1005'/><hydro><buoyancy/><drag/></hydro>"
         "<vessel hull='flared.stl' position='-0.2 0.05 0'><mass value='1000'/><carriage speed='0.5'/></vessel>"
         "<ice thickness='0.1'>" +
         floes + "</ice><body name='pier' shape='box' size='1 3 2' position='3 0 0' fixed='true'/>";
}

struct FieldRig : Rig {
  explicit FieldRig(const std::string& model, bool reversed = false, int threads = 1)
      : Rig(field(reversed) + crushing(model, 2e4), 0.01, threads, "stabilisation='projection'", 0.1, {0, 0, -9.81}) {}
};

TEST(Crushing, AFieldStaysCalmAndItsAccountsClose) {
  for (const std::string& model : {k_seed, k_compliant, k_each_other}) {
    FieldRig rig(model);
    sim::StepRecord record;
    double fastest = 0;
    for (int k = 0; k < 300; ++k) {
      record = rig.step();
      EXPECT_LE(record.momentum_imbalance, 1e-11 * record.momentum_scale + 1e-12);
      for (std::size_t b = 1; b < rig.bodies().id.size(); ++b) fastest = std::max(fastest, rig.bodies().v_GB[b].norm());
    }
    double put_in = 0;
    for (const double work : record.ledger.works) put_in += std::abs(work);
    EXPECT_LE(std::abs(record.ledger.imbalance), 1e-10 * put_in) << model;
    EXPECT_GT(record.ledger.crushing, 0);
    EXPECT_LT(fastest, 1.0) << "twice the hull's speed";
  }
}

TEST(Crushing, ThreadsAndOrderOfFloes) {
  for (const std::string& model : {k_compliant, k_each_other}) {
    FieldRig one(model), two(model, false, 2), reversed(model, true);
    for (int k = 0; k < 120; ++k) {
      const sim::StepRecord a = one.step(), b = two.step(), c = reversed.step();
      EXPECT_EQ(a.state_hash, b.state_hash) << k;
      const Vec3 difference = a.vessel->contact.force - c.vessel->contact.force;
      EXPECT_LE(difference.norm(), 1e-5 * (1 + a.vessel->contact.force.norm())) << model << k;
    }
  }
}

TEST(Crushing, GoesOnFromACheckpointWithTheSameBits) {
  for (const std::string& model : {k_compliant, k_each_other}) {
    FieldRig whole(model);
    for (int k = 0; k < 80; ++k) whole.step();
    State state;
    whole.simulation.save(StateWriter(state));
    FieldRig rest(model, false, 2);
    rest.simulation.restore(StateReader(state));
    for (int k = 0; k < 80; ++k) ASSERT_EQ(rest.step().state_hash, whole.step().state_hash) << model << k;
    EXPECT_EQ(rest.simulation.total("crushed_mass"), whole.simulation.total("crushed_mass"));
    EXPECT_GT(whole.simulation.total("crushed_mass"), 0);
  }
}

/// The hull against unbreakable floes, breakable floes against each other and against walls stay rigid.
TEST(Crushing, IsOfBreakableFloesAgainstHullsAlone) {
  const std::string content = towed("wedge.stl", -0.0025);
  const auto at = content.find("breakable='true'");
  Rig rigid(std::string(content).replace(at, 16, "breakable='false'") + crushing(k_seed), 0.01);
  sim::StepRecord record;
  EXPECT_ANY_THROW(static_cast<void>(Rig("<ice><floe outline='0 0 1 0 1 1'/></ice>" + crushing("model='none'"), 0.01)));
  for (int k = 0; k < 20; ++k) record = rigid.step();
  EXPECT_EQ(record.ledger.crushing, 0);
  const auto& modules = rigid.simulation.info().modules;
  EXPECT_TRUE(std::none_of(modules.begin(), modules.end(), [](const auto& m) { return m.first == "crushing"; }));
}

TEST(Crushing, TheListOfWhatWasBuiltSaysWhatStaysRigid) {
  Rig rig(
      "<ice><floe breakable='true' outline='0 0 1 0 1 1'/></ice><body name='ball' shape='sphere' position='0 0 5'/>"
      "<body name='pile' shape='cylinder' position='5 0 0'/>" +
          crushing(k_each_other),
      0.01);
  for (const auto& [name, text] : rig.simulation.info().modules) {
    if (name != "crushing") continue;
    EXPECT_EQ(text,
              "<fracture><crushing>: compliant, of floes by each other too; 'ball' has no flat faces and stays rigid");
    return;
  }
  FAIL() << "it is not listed";
}

}  // namespace crushing_invariance_test
