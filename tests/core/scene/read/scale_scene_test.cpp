/// A scaled scene has every value times the factor of its unit, and reads again as it was run.
#include <gtest/gtest.h>

#include "core/scene/read/read_scene.h"
#include "core/scene/spec/values.h"
#include "tests/core/scene/complete_scene.h"

namespace scale_scene_test {

using namespace nilas;
using namespace nilas::testing;
using scene::Scene;

class ScaleScene : public ::testing::Test {
 protected:
  Scene scaled(const std::string& text, double lambda, const scene::Overrides& overrides = {}) const {
    return scene::read_scene(folder_.write("scene.xml", text), overrides, lambda);
  }
  std::vector<Fault> faults(const std::string& text, double lambda) const {
    try {
      scaled(text, lambda);
    } catch (const SceneError& error) {
      return error.faults();
    }
    return {};
  }

  SceneFolder folder_;
};

/// The factors for 16 are powers of two: 4 of times and speeds, 16 of lengths and stresses, 16^3 of forces.
TEST_F(ScaleScene, FollowsTheUnits) {
  write_inputs(folder_);
  const Scene before = folder_.read(k_complete_scene), after = scaled(k_complete_scene, 16);
  EXPECT_EQ(after.scale, 16);
  EXPECT_EQ(after.time.step, 0.02 * 4);
  EXPECT_EQ(after.time.end, 60.0 * 4);
  EXPECT_EQ(after.gravity, before.gravity);
  EXPECT_EQ(after.seed, before.seed);
  EXPECT_EQ(after.contact.tolerance, 1e-7 * 4);
  EXPECT_EQ(after.contact.slop, 1e-4 * 16);
  EXPECT_EQ(after.contact.max_speed, 0.5 * 4);
  auto friction = before.contact.friction;
  friction.at(2).stiffness = 2e6 * 256;
  EXPECT_EQ(after.contact.friction, friction);
  EXPECT_EQ(after.water->density, 1000);
  EXPECT_EQ(after.water->level, 0.5 * 16);
  EXPECT_EQ(after.water->current->velocity, Vec3(0.1 * 4, 0.2 * 4, 0));
  EXPECT_EQ(after.hydro->drag, before.hydro->drag);
  EXPECT_EQ(after.hydro->virtual_drag->coefficient, 0.2 * 1024);
  EXPECT_EQ(after.tank->length, 40.0 * 16);
  EXPECT_EQ(after.vessel->mass.value, 1500.0 * 4096);
  EXPECT_EQ((*after.vessel->mass.inertia)[1], 3200.0 * 0x1p20);
  EXPECT_EQ(after.vessel->heading_deg, 20);
  EXPECT_EQ(after.vessel->carriage->balance.stiffness, 2e7 * 256);
  EXPECT_EQ(after.vessel->carriage->balance.damping, 2e4 * 1024);
  EXPECT_EQ(after.ice->youngs_modulus, 7e7 * 16);
  EXPECT_EQ(after.ice->poisson, 0.33);
  EXPECT_EQ(after.ice->vary[1].mean, 5e4 * 16);
  EXPECT_EQ(after.ice->vary[1].correlation_length, 2.0 * 16);
  EXPECT_EQ(after.bodies[0].angular_velocity.z(), 1.0 / 4);
  EXPECT_EQ(after.output.trajectory_every, 0.5 * 4);
}

/// With 16 and then 1/16, every value has its bits again, and so has the text of the scene as run. Defaults that are
/// written for the scaling stand where a scene that is read again has them, since a run that is resumed compares texts.
TEST_F(ScaleScene, ComesBackToTheSameBits) {
  const std::string text = in_scene(
      "<time step='0.013' end='7.7'/><water/><hydro><buoyancy/></hydro><tank length='31' width='9' depth='2'/>"
      "<vessel><hull generate='icebreaker' beam='1.3'/><mass draught='0.31'/></vessel>"
      "<ice thickness='0.047'><field kind='packed' region='7.1 -1 9 1'/><vary property='fracture_toughness' cov='0.1' "
      "correlation_length='3'/></ice><body mass='1.7' position='0.1 0.2 0.3' velocity='0.3 0 0'/>");
  const Scene up = scaled(text, 16);
  EXPECT_EQ(folder_.read(up.as_run).as_run, up.as_run) << "the scene as run is the scaled one, without --scale";
  EXPECT_EQ(folder_.read(up.as_run).fingerprint, up.fingerprint);
  const Scene down = scaled(text, 1.0 / 16);
  EXPECT_EQ(scaled(down.as_run, 16).as_run, scaled(up.as_run, 1.0 / 16).as_run);
  const Scene back = scaled(up.as_run, 1.0 / 16), before = folder_.read(text);
  EXPECT_EQ(back.scale, 1);
  EXPECT_EQ(back.time, before.time);
  EXPECT_EQ(back.tank, before.tank);
  EXPECT_EQ(back.vessel->mass, before.vessel->mass);
  EXPECT_EQ(back.vessel->generate->parameters.at("beam"), 1.3);
  EXPECT_EQ(back.ice->thickness, 0.047);
  EXPECT_EQ(back.ice->fields, before.ice->fields);
  EXPECT_EQ(back.ice->vary[0].mean, before.ice->vary[0].mean);
  EXPECT_EQ(back.bodies[0].position, before.bodies[0].position);
  EXPECT_EQ(back.bodies[0].velocity, before.bodies[0].velocity);
}

/// Defaults of a scene of nothing scale too: 0.01 s is 0.04 s, and 1 m/s of the correction is 4 m/s.
TEST_F(ScaleScene, ScalesDefaults) {
  const Scene scene = scaled(in_scene("<contact stabilisation='tasora'/><ice><field kind='packed' region='0 0 5 5'/>"
                                      "</ice><fracture><crushing model='pressure-area'/></fracture>"
                                      "<vessel><hull generate='icebreaker'/><mass draught='0.3'/></vessel><water/>"),
                             16);
  EXPECT_EQ(scene.time.step, 0.04);
  EXPECT_EQ(scene.contact.max_speed, 4);
  EXPECT_EQ(scene.ice->thickness, 0.04 * 16);
  EXPECT_EQ(scene.fracture->min_area, 2e-4 * 256);
  EXPECT_EQ(scene.fracture->fracture_toughness, 3e3 * 64);
  EXPECT_EQ(scene.vessel->generate->parameters.at("length"), 6 * 16);
  // Pa m^1.4 with the exponent -0.7: 16^(1 + 1.4)
  EXPECT_NEAR(scene.fracture->crushing->coefficient, 1e5 * 776.046882, 1);
}

/// The unit of a joint's stiffness depends on the joint, and that of a mean strength on the property.
TEST_F(ScaleScene, KnowsUnitsThatDependOnAChoice) {
  const Scene scene =
      scaled(in_scene("<water/><vessel position='0 0 0'><hull generate='icebreaker'/><mass value='1000'/>"
                      "<part name='a' joint='slider' shape='box' stiffness='1'/>"
                      "<part name='b' joint='hinge' shape='box' stiffness='1'/></vessel>"
                      "<ice><field kind='level' region='20 0 25 5'/><vary property='fracture_toughness' cov='0.1'/>"
                      "<vary property='flexural_strength' cov='0.1'/></ice>"),
             16);
  EXPECT_EQ(scene.vessel->parts[0].stiffness, 256);
  EXPECT_EQ(scene.vessel->parts[1].stiffness, 0x1p16);
  EXPECT_EQ(scene.ice->vary[0].mean, 3e3 * 64);
  EXPECT_EQ(scene.ice->vary[1].mean, 4e4 * 16);
}

TEST_F(ScaleScene, ComesAfterOverrides) { EXPECT_EQ(scaled(in_scene(""), 16, {{"time/@end", "3"}}).time.end, 12); }

TEST_F(ScaleScene, RefusesAValueThatLeavesItsRange) {
  const auto found = faults(in_scene("<water/><hydro><buoyancy/></hydro>"
                                     "<ice><field kind='level' region='0 0 1 1' breakable='true'/></ice>\n"
                                     "<fracture><bending speed_slope='9'/></fracture>"),
                            0.25);
  expect_fault(found, 3, "<fracture><bending speed_slope>", {"--scale", "18", "<= 10"});
}

}  // namespace scale_scene_test
