/// Bodies at rest keep their contacts step by step, and a body that slides over an edge changes its contacts without a
/// jump.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/sim/simulation.h"
#include "tests/core/sim/scene_rig.h"

namespace resting_contacts_test {

using namespace nilas;
using namespace nilas::sim;

struct Rig : test::SceneRig {
  explicit Rig(const std::string& body) : SceneRig(test::steps_of(0.01) + body) {}
  std::set<std::uint64_t> step() {
    simulation.step();
    const auto& keys = simulation.last_problem().problem.key;
    return {keys.begin(), keys.end()};
  }
};

struct Rest {
  const char* name;
  std::size_t contacts;
  int settling, steps;
  const char* scene;
};

void PrintTo(const Rest& rest, std::ostream* out) { *out << rest.name; }

#define NILAS_FRICTION "<friction between='* *' static='0.3' kinetic='0.3'/></contact>"
#define NILAS_PROJECTION \
  "<contact law='coulomb' solver='auto' tolerance='1e-8' stabilisation='projection'>" NILAS_FRICTION
#define NILAS_SPLIT \
  "<contact law='coulomb' solver='auto' tolerance='1e-6' stabilisation='split-impulse'>" NILAS_FRICTION
#define NILAS_WATER "<water density='1005'/><hydro><buoyancy/><drag form='1' skin='0.005'/>"
#define NILAS_STACK                                                                                                \
  "<body name='ground' shape='plane' fixed='true'/><body shape='box' size='1 1 0.2' mass='2' position='0 0 0.1'/>" \
  "<body shape='box' size='1 1 0.2' mass='2' position='0.05 0.02 0.3' rotation_deg='10 0 0'/>"                     \
  "<body shape='box' size='0.8 1 0.2' mass='2' position='-0.05 0 0.5' rotation_deg='40 0 0'/>"                     \
  "<body shape='box' size='1 1 0.2' mass='2' position='0 0 0.7'/>"
#define NILAS_SHIP                                                                                                  \
  "<vessel name='ship' position='0 0'><hull generate='icebreaker' length='3' beam='0.8' draught='0.2' depth='0.4' " \
  "triangles='600'/><mass draught='0.2'/><fixed/></vessel>"

const std::vector<Rest> k_rests{
    {"PlateOnAPlane", 4, 200, 10000,
     NILAS_SPLIT "<body name='ground' shape='plane' fixed='true'/>"
                 "<body shape='box' size='1 0.8 0.1' mass='2' position='0 0 0.05'/>"},
    {"PlateThatFellOnAPlate", 4, 300, 10000,
     NILAS_PROJECTION "<body name='shelf' shape='box' size='3 3 0.2' position='0 0 -0.1' fixed='true'/>"
                      "<body shape='box' size='1 0.8 0.1' mass='2' position='0.1 0 0.055' rotation_deg='20 0.5 0.3'/>"},
    // The plate rocks by 2e-8 m. In addition to its four, each pair keeps the corners that have been the deepest. What
    // the tolerance leaves decides which, and so how many: the count follows the arithmetic of the solver.
    {"StackOfTurnedPlates", 21, 5000, 2000, NILAS_SPLIT NILAS_STACK},
    {"StackOfTurnedPlatesProjected", 16, 1000, 2000, NILAS_PROJECTION NILAS_STACK},
    {"FloatingFloesSideBySide", 4, 100, 2000,
     NILAS_PROJECTION NILAS_WATER "</hydro><ice thickness='0.1'><floe outline='0 0 1 0 1 1 0 1'/>"
                                  "<floe outline='1 0.2 2 0.2 2 1.2 1 1.2'/></ice>"},
    {"FloeOnALargerFloe", 4, 1000, 2000,
     NILAS_PROJECTION NILAS_WATER "</hydro><ice thickness='0.1'><floe outline='0 0 2 0 2 2 0 2'/>"
                                  "<floe outline='0.5 0.5 1.5 0.6 1.4 1.5 0.6 1.4' z='0.1'/></ice>"},
    {"PlateOnTheDeckOfAHull", 4, 200, 2000,
     NILAS_PROJECTION NILAS_WATER "</hydro>" NILAS_SHIP
                                  "<body shape='box' size='0.5 0.3 0.05' mass='1' position='1.5 0 0.226'/>"},
    {"FloePressedAgainstAHull", 2, 1500, 1500,
     NILAS_PROJECTION NILAS_WATER "<virtual_drag coefficient='10' velocity='0 -0.3 0'/></hydro>" NILAS_SHIP
                                  "<ice thickness='0.05'><floe outline='1.0 0.45 1.7 0.45 1.7 1 1.0 1'/></ice>"}};

class AtRest : public ::testing::TestWithParam<Rest> {};

TEST_P(AtRest, KeepsItsContacts) {
  const Rest& rest = GetParam();
  Rig rig(rest.scene);
  std::set<std::uint64_t> keys;
  for (int k = 0; k < rest.settling; ++k) keys = rig.step();
  EXPECT_EQ(keys.size(), rest.contacts);
  int changes = 0;
  for (int k = 0; k < rest.steps; ++k) {
    const auto now = rig.step();
    changes += now == keys ? 0 : 1;
    keys = now;
  }
  EXPECT_EQ(changes, 0);
}

INSTANTIATE_TEST_SUITE_P(All, AtRest, ::testing::ValuesIn(k_rests),
                         [](const auto& instance) { return instance.param.name; });

/// A plate slides off a shelf without friction. It keeps its speed and its weight holds it, wherever its corners are,
/// until its centre passes the edge; then it tips.
TEST(Sliding, OverAnEdgeIsQuasiStatic) {
  constexpr double k_mass = 2, k_h = 0.01, k_g = 9.81, k_speed = 0.37;
  for (const double yaw : {0.0, 25.0}) {
    Rig rig(
        "<contact law='coulomb' solver='auto' tolerance='1e-11' stabilisation='projection'/>"
        "<body name='shelf' shape='box' size='4 4 0.2' position='-2 0 -0.1' fixed='true'/>"
        "<body name='plate' shape='box' size='1 0.8 0.1' mass='2' position='-0.9 0 0.05' velocity='0.37 0 0' "
        "rotation_deg='" +
        std::to_string(yaw) + " 0 0'/>");
    double noise = 0, across = 0;
    int steps = 0;
    const bodies::Bodies& bodies = rig.simulation.bodies();
    while (bodies.p_GB[1].x() < -k_speed * k_h) {
      const Vec3 before = bodies.v_GB[1];
      rig.step();
      const Vec3 force = k_mass * ((bodies.v_GB[1] - before) / k_h + k_g * Vec3::UnitZ());
      if (++steps <= 3) continue;
      noise = std::max(noise, std::abs(force.z() - k_mass * k_g));
      across = std::max(across, std::hypot(force.x(), force.y()));
    }
    EXPECT_NEAR(steps, 0.9 / (k_speed * k_h), 2) << yaw;
    EXPECT_LT(noise, 1e-6 * k_mass * k_g) << yaw;
    EXPECT_LT(across, 1e-6 * k_mass * k_g) << yaw;
    EXPECT_LT(bodies.w_GB[1].norm(), 1e-6) << yaw;
    for (int k = 0; k < 30; ++k) rig.step();
    EXPECT_GT(bodies.w_GB[1].y(), 0.05) << yaw;
  }
}

}  // namespace resting_contacts_test
