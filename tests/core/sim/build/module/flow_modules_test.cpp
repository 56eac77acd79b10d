/// Currents, wind and jets in whole runs.
#include "core/sim/build/module/flow_modules.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/sim/build/build_world.h"
#include "core/vessel/thrusters/rudder.h"
#include "tests/core/sim/scene_rig.h"
#include "tests/support/refusal.h"

namespace nilas::sim {
namespace flow_modules_test {

const std::string k_drag = "<hydro><drag form='1' skin='0.005'/></hydro>";

WorldParts built(const std::string& inside, const test::SceneRig::Files& files = {},
                 const ModuleList& modules = scene_modules()) {
  const test::ScratchFolder folder;
  geometry::write_stl(geometry::box_shape(Vec3(2, 1, 0.5)).surface, folder / "box.stl");
  for (const auto& [name, content] : files) folder.write(name, content);
  const scene::Scene scene = scene::read_scene(folder.write("scene.xml", "<scene version='1'>" + inside + "</scene>"));
  WarningCounts warnings(make_logger("off", ""));
  return build_world(scene, 1, warnings, modules);
}

/// Velocity, profile and series add up.
TEST(FlowModules, PartsOfTheCurrentAddUp) {
  const WorldParts parts = built(
      "<time start='5' end='10'/><water level='1'><current velocity='0.1 0 0' profile='p.csv' "
      "series='s.csv'/></water>" +
          k_drag,
      {{"p.csv", "z_m,u_m_s,v_m_s\n0,0.2,0\n-2,0,0\n"}, {"s.csv", "t_s,u_m_s,v_m_s\n0,0,0\n10,0,0.6\n"}});
  ASSERT_EQ(parts.water->flows.size(), 2u);
  Vec3 u = parts.water->current;
  for (const auto& flow : parts.water->flows) u += flow->velocity({0, 0, 0}, 5);
  EXPECT_LT((u - Vec3(0.1 + 0.1, 0.3, 0)).norm(), 1e-15);
  EXPECT_LT((parts.current - Vec3(0.1 + 0.2, 0.3, 0)).norm(), 1e-15) << "at the surface and the start";
}

/// A tide that turns at the start of the run has a direction nonetheless: axes of loads follow it, and it drives ice.
TEST(FlowModules, SlackWaterAtTheStartHasTheDirectionOfTheTide) {
  const test::SceneRig::Files tide{{"s.csv", "t_s,u_m_s,v_m_s\n0,0,0\n100,0,-0.5\n200,0,0.4\n"}};
  const WorldParts parts = built("<water><current series='s.csv'/></water>" + k_drag + test::k_no_weight +
                                     test::box_vessel("position='0 0 0'", "<fixed/>") +
                                     "<ice thickness='0.1'><floe outline='3 0 4 0 4 1'/></ice>",
                                 tide);
  EXPECT_EQ(parts.current, Vec3(0, -0.5, 0));
  EXPECT_EQ(parts.info.drift_course, Vec2(0, 1));
}

/// A uniform current makes no part of a flow, so its runs keep their bits.
TEST(FlowModules, AUniformCurrentIsNoFlow) {
  const WorldParts parts = built("<water><current velocity='0.1 0.2 0'/></water>" + k_drag);
  EXPECT_TRUE(parts.water->flows.empty());
  EXPECT_EQ(parts.water->current, Vec3(0.1, 0.2, 0));
  EXPECT_EQ(parts.current, Vec3(0.1, 0.2, 0));
}

/// The run in a constant series is that in a uniform current, to rounding.
TEST(FlowModules, AConstantSeriesIsAUniformCurrent) {
  const auto run = [](const std::string& current) {
    test::SceneRig rig(
        "<time step='0.01' end='10'/><water>" + current + "</water>" +
            "<hydro><buoyancy/><drag/></hydro><ice thickness='0.1'><floe outline='0 0 1 0 1 2 0 2'/></ice>",
        1, {{"s.csv", "t_s,u_m_s,v_m_s\n0,0.3,-0.2\n9,0.3,-0.2\n"}});
    for (int k = 0; k < 200; ++k) rig.simulation.step();
    return rig.bodies().v_GB[0];
  };
  const Vec3 a = run("<current velocity='0.3 -0.2 0'/>"), b = run("<current series='s.csv'/>");
  EXPECT_GT(a.norm(), 0.05);
  EXPECT_LT((a - b).norm(), 1e-12);
}

/// Gusty wind on a vessel and a floe, with a jet behind the vessel. Momentum and energy are booked, and a resumed run
/// has the same bits. The jet has V0 = 1.78 m/s and 0.30 m/s at the near side of the floe, 2 m behind the propeller and
/// 0.16 m from the axis. So 0.5 rho C_f A u^2 = 4 N push 92 kg for 0.8 s, to 0.035 m/s; the wind takes a little of it.
TEST(FlowModules, WindAndJetGoOnFromACheckpoint) {
  const std::string scene =
      test::steps_of(0.01) + "<water density='1000'/><hydro><buoyancy/><drag/>" +
      "<propeller_wash><jet thrust='50' diameter='0.2' position='-1 0 -0.2'/></propeller_wash></hydro>" +
      "<wind speed='15' direction_deg='40' profile='log' gusts='npd'/>" +
      test::box_vessel("position='0 0 0'", "<wind_area ship_type='research' frontal='0.3' lateral='0.5'/>", 500) +
      "<ice thickness='0.1'><floe outline='-4 -0.5 -3 -0.5 -3 0.5 -4 0.5'/></ice>";
  test::SceneRig whole(scene);
  ASSERT_EQ(whole.simulation.info().vessel_loads, std::vector<std::string>{"wind"});
  Simulation first(whole.scene, 1, whole.warnings), rest(whole.scene, 2, whole.warnings);
  for (int k = 0; k < 30; ++k) first.step();
  State state;
  first.save(StateWriter(state));
  rest.restore(StateReader(state));
  StepRecord of_whole, of_rest;
  for (int k = 0; k < 80; ++k) of_whole = whole.balanced_step(1e-11, 1e-11);
  for (int k = 30; k < 80; ++k) of_rest = rest.step();
  EXPECT_EQ(of_rest.state_hash, of_whole.state_hash);
  test::expect_energy_kept(of_whole, 1e-9);
  EXPECT_NEAR(whole.bodies().v_GB[1].x(), -0.033, 0.005) << "the jet drives the floe astern";
  EXPECT_GT(whole.bodies().v_GB[0].y(), 1e-4) << "the wind drives the vessel";
}

/// A tunnel's jet leaves athwart and a propeller's astern, unless the scene says otherwise. With its rudder over, a
/// propeller sends the jet against the force of both.
TEST(FlowModules, JetsLeaveAgainstTheThrust) {
  const std::string strong = "max_thrust='100' power='1000' at='0 0 -0.1' ";
  const std::string jet = "<jet diameter='0.2' position='0 0 -0.1' thruster=";
  const WorldParts parts = built(
      "<water density='1000'/><hydro><buoyancy/><drag/><propeller_wash>" + jet + "'bow'/>" + jet + "'main'/>" + jet +
      "'bow' direction='0 -3 -4'/>" + jet + "'steered'/></propeller_wash></hydro>" +
      test::box_vessel("position='0 0 0'",
                       "<thrusters><thruster name='bow' kind='tunnel' " + strong +
                           "/><thruster name='main' "
                           "kind='propeller' " +
                           strong + "/><thruster name='steered' kind='propeller-rudder' " + strong +
                           "rudder_area='0.03' rudder_span='0.2' rudder_distance='0.1' diameter='0.2'/></thrusters>",
                       500));
  for (const char* name : {"bow", "main", "steered"})
    parts.commands->set(parts.commands->find(name + std::string(".thrust_actual")), 80);
  parts.commands->set(parts.commands->find("steered.angle_actual"), 0.5);
  for (const auto& module : parts.modules)
    if (module->name() == "propeller_wash") module->end_substep(parts.bodies, 0, 0.1);
  const Vec3 centre = parts.bodies.p_GB[0] + Vec3(0, 0, -0.1) - parts.vessel_model->mass.com;
  const auto leaves = [&](std::size_t k, const Vec3& direction) {
    const double V0 = parts.jets[k]->efflux_velocity();
    EXPECT_GT(V0, 1);
    EXPECT_LT((parts.jets[k]->velocity(centre + 0.05 * direction, 0) - V0 * direction).norm(), 1e-9) << k;
  };
  leaves(0, -Vec3::UnitY());
  leaves(1, -Vec3::UnitX());
  leaves(2, Vec3(0, -0.6, -0.8));
  const vessel::Rudder rudder{
      .area = 0.03, .span = 0.2, .behind = 0.1, .diameter = 0.2, .most_angle = 35 * k_deg, .water_density = 1000};
  const Vec2 force = Vec2::UnitX() + vessel::rudder_force(rudder, 0.5, 1, 0, 0);
  EXPECT_GT(force.y(), 0.2);
  leaves(3, -Vec3(force.x(), force.y(), 0).normalized());
}

TEST(FlowModules, AThrusterThatPublishesNoThrustIsRefused) {
  const std::string scene =
      "<water/><hydro><drag/>\n<propeller_wash><jet thruster='stern' diameter='1' position='0 0 0'/></propeller_wash>"
      "</hydro>" +
      test::box_vessel("position='0 0 0'", "");
  test::expect_refusal([&] { built(scene); }, {"scene.xml:2", "found 'stern'", "no thruster or propeller"});
  ModuleList modules = scene_modules();
  modules.insert(modules.begin(), {"stub", false, [](const ModuleSources& from) -> BuiltModule {
                                     from.parts.commands->add("bow.thrust_actual", "N", 0);
                                     return {};
                                   }});
  test::expect_refusal([&] { built(scene, {}, modules); }, {"found 'stern'", "allowed: bow"});
}

TEST(FlowModules, WrongTablesAreRefused) {
  test::expect_refusal(
      [] {
        built("<water><current profile='p.csv'/></water>", {{"p.csv", "z_m,u,v\n0,1,0\n"}});
      },
      {"p.csv:1:5", "unknown column 'u'"});
}

}  // namespace flow_modules_test
}  // namespace nilas::sim
