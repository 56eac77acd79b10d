/// Balls and rollers that slip over the ground with spin, against closed forms. With a constant force the theta scheme
/// is exact, so every digit is asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/core/sim/scene_rig.h"

namespace round_shapes_test {

using namespace nilas;

constexpr double k_step = 1e-3, k_mu = 0.25, k_gravity = 9.81, k_mass = 5, k_radius = 0.2;

/// Scene of one body on the ground, by default on the plane z = 0, with the default stabilisation.
struct OnGround : test::SceneRig {
  OnGround(const std::string& body, const std::string& integrator,
           const std::string& ground = "<body name='ground' shape='plane' position='0 0 0' fixed='true'/>")
      : SceneRig(test::steps_of(k_step) + "<contact law='coulomb' solver='newton' tolerance='1e-13' integrator='" +
                 integrator + "'><friction between='* *' static='0.25' kinetic='0.25'/></contact>" + ground + body) {}

  Vec3 position() const { return bodies().p_GB[1]; }
  Vec3 velocity() const { return bodies().v_GB[1]; }
  /// The step's sum of normal impulses over its length [N].
  double normal_force() const {
    double sum = 0;
    for (const Vec3& impulse : simulation.solved_substeps().back().impulses) sum += impulse.z();
    return sum / k_step;
  }
};

const std::string k_ball =
    "<body name='ball' shape='sphere' radius='0.2' mass='5' position='0 0 0.2' velocity='2 0.5 0' "
    "angular_velocity='12 0 4'/>";

const std::string k_box = "<body name='ground' shape='box' size='10 10 1' mass='1' position='0 0 -0.5' fixed='true'/>";

/// The slip u of a solid ball keeps its direction d. Friction slows the ball by mu g d and turns it so that u falls by
/// 7/2 mu g; it ends at t = 2 |u| / (7 mu g), and the ball rolls on with v - 2/7 u.
TEST(RoundShapes, ASpinningBallSlipsWithoutAHop) {
  const Vec3 v0(2, 0.5, 0), w0(12, 0, 4);
  const Vec3 u0 = v0 + w0.cross(-k_radius * Vec3::UnitZ());
  const double end_of_slip = 2 * u0.norm() / (7 * k_mu * k_gravity);
  for (const std::string& ground :
       {std::string("<body name='ground' shape='plane' position='0 0 0' fixed='true'/>"), k_box})
    for (const std::string integrator : {"moreau", "semi-implicit-euler"}) {
      SCOPED_TRACE(integrator);
      OnGround rig(k_ball, integrator, ground);
      for (int k = 1; k * k_step < end_of_slip - k_step; ++k) {
        rig.balanced_step(1e-11, 1e-13);
        const double t = k * k_step;
        // the first-order scheme gives the constant friction half a step more of its path
        const double path = integrator == "moreau" ? t * t : t * (t + k_step);
        ASSERT_NEAR(rig.normal_force() / (k_mass * k_gravity), 1, 1e-10);
        ASSERT_NEAR(rig.position().z(), k_radius, 1e-14);
        ASSERT_LE((rig.velocity() - (v0 - k_mu * k_gravity * t * u0.normalized())).norm(), 1e-9);
        const Vec3 place = v0 * t - 0.5 * k_mu * k_gravity * path * u0.normalized() + Vec3(0, 0, k_radius);
        ASSERT_LE((rig.position() - place).norm(), 1e-9);
      }
      for (int k = 0; k < 200; ++k) {
        rig.simulation.step();
        ASSERT_NEAR(rig.position().z(), k_radius, 1e-14);
      }
      EXPECT_LE((rig.velocity() - (v0 - 2.0 / 7 * u0)).norm(), 1e-9);
    }
}

/// A cylinder on its side with its axis along y, spinning backwards: u falls by 3 mu g, and it rolls on with v - u/3.
TEST(RoundShapes, ASpinningRollerSlipsWithoutAHop) {
  const std::string roller =
      "<body name='roller' shape='cylinder' radius='0.2' height='0.6' mass='5' position='0 0 0.2' "
      "rotation_deg='0 0 90' velocity='1 0 0' angular_velocity='0 -10 0'/>";
  const double slip = 1 + 10 * k_radius, end_of_slip = slip / (3 * k_mu * k_gravity);
  for (const std::string integrator : {"moreau", "semi-implicit-euler"}) {
    SCOPED_TRACE(integrator);
    OnGround rig(roller, integrator);
    int k = 1;
    for (; k * k_step < end_of_slip - k_step; ++k) {
      rig.balanced_step(1e-11, 1e-13);
      ASSERT_NEAR(rig.normal_force() / (k_mass * k_gravity), 1, 1e-10);
      ASSERT_NEAR(rig.position().z(), k_radius, 1e-13);
      ASSERT_NEAR(rig.velocity().x(), 1 - k_mu * k_gravity * k * k_step, 1e-9);
    }
    for (int last = 0; last < 100; ++last) rig.simulation.step();
    EXPECT_NEAR(rig.velocity().x(), 1 - slip / 3, 1e-9);
    EXPECT_NEAR(rig.position().z(), k_radius, 1e-13);
  }
}

/// A ball that spins on the spot about a slanting axis neither rises nor sinks while its friction turns.
TEST(RoundShapes, ABallThatSpinsOnTheSpotStaysDown) {
  OnGround rig(
      "<body name='ball' shape='sphere' radius='0.2' mass='5' position='0 0 0.2' angular_velocity='30 -20 50'/>",
      "moreau");
  double highest = 0, lowest = 0;
  for (int k = 0; k < 2000; ++k) {
    rig.simulation.step();
    highest = std::max(highest, rig.position().z() - k_radius);
    lowest = std::min(lowest, rig.position().z() - k_radius);
  }
  EXPECT_LE(highest, 1e-13);
  EXPECT_GE(lowest, -1e-13);
}

}  // namespace round_shapes_test
