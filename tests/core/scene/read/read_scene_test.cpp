/// Tests that the Scene holds the values of the scene file.
#include "core/scene/read/read_scene.h"

#include <gtest/gtest.h>

#include "tests/core/scene/complete_scene.h"

namespace nilas::scene {
namespace read_scene_test {

using testing::in_scene;
using testing::SceneFolder;

class CompleteScene : public ::testing::Test {
 protected:
  void SetUp() override {
    testing::write_inputs(folder_);
    scene_ = folder_.read(testing::k_complete_scene);
  }
  SceneFolder folder_;
  Scene scene_;
};

TEST_F(CompleteScene, RunSettings) {
  EXPECT_EQ(scene_.name, "towing-broken-ice");
  EXPECT_EQ(scene_.file, folder_.path() / "scene.xml");
  EXPECT_EQ(scene_.time.step, 0.02);
  EXPECT_EQ(scene_.time.start, 1);
  EXPECT_EQ(scene_.time.end, 60);
  EXPECT_EQ(scene_.gravity, Vec3(0, 0, -9.8));
  EXPECT_EQ(scene_.seed, 7u);
  EXPECT_EQ(scene_.output.folder, "runs/towing");
  EXPECT_EQ(scene_.output.trajectory_every, 0.5);
  EXPECT_EQ(name_of(scene_.output.contacts), "none");
  EXPECT_EQ(scene_.output.bodies, true);
  EXPECT_FALSE(scene_.fracture.has_value());
}

TEST_F(CompleteScene, Contact) {
  const ContactScene& c = scene_.contact;
  EXPECT_EQ(name_of(c.law), "pyramid");
  EXPECT_EQ(name_of(c.solver), "pgs");
  EXPECT_EQ(c.tolerance, 1e-7);
  EXPECT_EQ(c.max_iterations, 200);
  EXPECT_EQ(name_of(c.on_failure), "stop");
  EXPECT_EQ(name_of(c.integrator), "semi-implicit-euler");
  EXPECT_EQ(name_of(c.stabilisation), "split-impulse");
  EXPECT_EQ(c.erp, 0.3);
  EXPECT_EQ(c.slop, 1e-4);
  EXPECT_EQ(c.max_speed, 0.5);
  EXPECT_EQ(name_of(c.detection), "discrete");
  EXPECT_EQ(c.margin, 0.01);
  EXPECT_FALSE(c.gyroscopic);
  EXPECT_EQ(c.axes_deg, 30);
  EXPECT_FALSE(c.warm_start);
}

TEST_F(CompleteScene, FrictionTakesTheMissingCoefficientFromTheOther) {
  const auto& friction = scene_.contact.friction;
  ASSERT_EQ(friction.size(), 3u);
  EXPECT_EQ(friction[0].material_a, "ice");
  EXPECT_EQ(friction[0].restitution, 0.1);
  EXPECT_EQ(friction[1].static_, 0.1);
  EXPECT_EQ(friction[1].kinetic, 0.1);
  EXPECT_EQ(friction[2].material_a, "quay");
  EXPECT_EQ(friction[2].material_b, "*");
  EXPECT_EQ(friction[2].kinetic, 0.2);
}

TEST_F(CompleteScene, ElasticPairs) {
  const auto& friction = scene_.contact.friction;
  EXPECT_FALSE(friction[0].elastic);
  EXPECT_FALSE(friction[0].stiffness || friction[0].tangential_ratio) << "those of the ice";
  EXPECT_EQ(friction[0].edge_factor, 0.5);
  EXPECT_TRUE(friction[2].elastic);
  EXPECT_EQ(friction[2].stiffness, 2e6);
  EXPECT_EQ(friction[2].edge_factor, 0.8);
  EXPECT_EQ(friction[2].tangential_ratio, 0.9);
  EXPECT_EQ(friction[2].damping_ratio, 0.3);
}

TEST_F(CompleteScene, WaterAndTank) {
  EXPECT_EQ(scene_.water->density, 1000);
  EXPECT_EQ(scene_.water->level, 0.5);
  EXPECT_EQ(scene_.water->current->velocity, Vec3(0.1, 0.2, 0));
  EXPECT_TRUE(scene_.hydro->buoyancy);
  EXPECT_EQ(scene_.hydro->drag->form, 1.1);
  EXPECT_EQ(scene_.hydro->drag->skin, 0.006);
  const DatabaseScene& database = *scene_.hydro->database;
  EXPECT_EQ(database.file, (folder_.path() / "ship.1").string());
  EXPECT_EQ(database.length, 2);
  EXPECT_EQ(database.density, 1020);
  EXPECT_EQ(database.gravity, 9.8);
  EXPECT_EQ(database.depth, 80);
  EXPECT_EQ(*database.reference, Vec3(0, 0, -1));
  EXPECT_EQ(*database.origin, Vec3(0.1, 0, 0.2));
  EXPECT_EQ(database.rotation_deg, 180);
  EXPECT_EQ(scene_.hydro->virtual_drag->coefficient, 0.2);
  EXPECT_EQ(scene_.hydro->virtual_drag->velocity, Vec3(0.389, 0, 0));
  ASSERT_EQ(scene_.water->waves.size(), 2u);
  const WaveScene& sea = scene_.water->waves[0];
  EXPECT_EQ(sea.kind, WaveKind::jonswap);
  EXPECT_EQ(sea.height, 0.1);
  EXPECT_EQ(sea.period, 2);
  EXPECT_EQ(sea.heading_deg, 30);
  EXPECT_EQ(sea.gamma, 2);
  EXPECT_EQ(sea.components, 20);
  EXPECT_EQ(sea.shortest(), 0.8);
  EXPECT_EQ(sea.spreading, 8);
  EXPECT_EQ(sea.ramp, 3);
  EXPECT_EQ(sea.depth, 2);
  EXPECT_EQ(sea.attenuation, WaveAttenuation::exponential);
  EXPECT_EQ(sea.attenuation_rate, 2e-4);
  EXPECT_EQ(sea.ice_edge, Vec2(5, 1));
  EXPECT_EQ(sea.ice_edge_deg, 10);
  EXPECT_EQ(scene_.water->waves[1].phase_deg, 45);
  EXPECT_EQ(scene_.hydro->wave_loads->vessel, VesselWaveLoads::none);
  EXPECT_EQ(scene_.hydro->wave_loads->floes, FloeWaveLoads::none);
  EXPECT_EQ(scene_.tank->length, 40);
  EXPECT_EQ(scene_.tank->width, 20);
  EXPECT_EQ(scene_.tank->depth, 2.5);
  EXPECT_EQ(scene_.tank->wall_thickness, 0.3);
  EXPECT_FALSE(scene_.tank->floor);
}

TEST_F(CompleteScene, Vessel) {
  const VesselScene& v = *scene_.vessel;
  EXPECT_EQ(v.name, "polaris");
  EXPECT_EQ(v.hull, (folder_.path() / "hulls/icebreaker").string());
  EXPECT_FALSE(v.generate);
  EXPECT_FALSE(v.position_has_z);
  EXPECT_EQ(v.position, Vec3(1, 2, 0));
  EXPECT_EQ(v.heading_deg, 20);
  EXPECT_FALSE(v.fixed);
  EXPECT_EQ(v.mass.value, 1500);
  EXPECT_EQ(*v.mass.cog, Vec3(2.9, 0, 0.1));
  EXPECT_EQ((*v.mass.inertia)[4], 5);
  EXPECT_FALSE(v.mass.draught);
  const CarriageScene& c = *v.carriage;
  EXPECT_EQ(c.speed, 0.3);
  EXPECT_EQ(c.heading_deg, 10);
  EXPECT_EQ(c.ramp, 2);
  EXPECT_EQ(name_of(c.ramp_shape), "smooth");
  EXPECT_EQ(*c.joint, Vec3(2.9, 0, 0.2));
  EXPECT_EQ(c.free, (std::array<bool, 6>{false, false, true, false, false, true}));
  EXPECT_EQ(name_of(c.balance.kind), "six-cells");
  EXPECT_EQ(c.balance.stiffness, 2e7);
  EXPECT_EQ(c.balance.damping, 2e4);
  EXPECT_EQ(c.balance.layout, (folder_.path() / "cells.csv").string());
}

TEST_F(CompleteScene, Ice) {
  const IceScene& ice = *scene_.ice;
  EXPECT_EQ(ice.density, 910);
  EXPECT_EQ(ice.youngs_modulus, 7e7);
  EXPECT_EQ(ice.poisson, 0.33);
  EXPECT_EQ(ice.thickness, 0.05);
  ASSERT_EQ(ice.fields.size(), 4u);
  const auto& channel = std::get<ChannelFieldScene>(ice.fields[3].form);
  EXPECT_EQ(channel.width, 2.5);
  EXPECT_EQ(channel.ice.overlap_tolerance, 0);
  EXPECT_EQ(channel.ice.size, SizeScene(LibrarySizeScene{}));
  EXPECT_EQ(std::get<LibraryScene>(channel.ice.shape).file, (folder_.path() / "floes.json").string());
  const auto& packed = std::get<PackedFieldScene>(ice.fields[0].form);
  EXPECT_EQ(packed.region, (RegionScene{0, -5, 40, 5}));
  EXPECT_EQ(packed.concentration, 0.75);
  EXPECT_TRUE(ice.fields[0].breakable);
  EXPECT_EQ(packed.overlap_tolerance, 2e-3);
  EXPECT_FALSE(ice.fields[0].thickness);
  EXPECT_EQ(packed.size, SizeScene(LognormalSizeScene{.mean = 0.9, .sd = 0.2, .min = 0.4, .max = 1.5}));
  EXPECT_EQ(packed.shape, FloeShapeScene(PolygonScene{.vertices_min = 4, .vertices_max = 8}));
  EXPECT_EQ(std::get<FileFieldScene>(ice.fields[2].form).file, (folder_.path() / "floes.geojson").string());
  EXPECT_EQ(ice.fields[2].region(), nullptr);
  EXPECT_EQ(ice.fields[2].velocity, Vec3(0.1, 0, 0));
}

TEST_F(CompleteScene, GridAndSingleFloe) {
  const FieldScene& field = scene_.ice->fields.at(1);
  const auto& grid = std::get<GridFieldScene>(field.form);
  EXPECT_EQ(grid.rows, 2);
  EXPECT_EQ(grid.columns, 3);
  EXPECT_EQ(grid.gap, 0.01);
  EXPECT_TRUE(grid.stagger);
  EXPECT_EQ(grid.shear_deg, 15);
  EXPECT_TRUE(field.fixed);
  EXPECT_EQ(field.z, 0.02);
  EXPECT_EQ(field.thickness, 0.06);
  ASSERT_EQ(scene_.ice->floes.size(), 1u);
  const FloeScene& floe = scene_.ice->floes[0];
  EXPECT_EQ(floe.name, "big");
  ASSERT_EQ(floe.outline.size(), 4u);
  EXPECT_EQ(floe.outline[2], Vec2(2, 1));
  EXPECT_EQ(floe.velocity, Vec3(0, 0.1, 0));
  EXPECT_EQ(floe.z, -0.01);
  EXPECT_EQ(floe.thickness, 0.07);
  EXPECT_EQ(floe.line, testing::line_of("<floe name=\"big\""));
}

TEST_F(CompleteScene, Bodies) {
  ASSERT_EQ(scene_.bodies.size(), 5u);
  const BodyScene& box = scene_.bodies[0];
  EXPECT_EQ(std::get<BoxScene>(box.shape).size, Vec3(1, 2, 3));
  EXPECT_EQ(box.mass, 12);
  EXPECT_FALSE(box.density);
  EXPECT_EQ((*box.inertia)[2], 5);
  EXPECT_EQ(box.position, Vec3(5, 6, 7));
  EXPECT_EQ(box.rotation_deg, Vec3(10, 20, 30));
  EXPECT_EQ(box.velocity, Vec3(1, 0, 0));
  EXPECT_EQ(box.angular_velocity, Vec3(0, 0, 1));
  EXPECT_EQ(box.line, testing::line_of("<body name=\"box\""));
  EXPECT_EQ(std::get<SphereScene>(scene_.bodies[1].shape).radius, 0.25);
  EXPECT_EQ(scene_.bodies[1].density, 500);
  EXPECT_EQ(std::get<CylinderScene>(scene_.bodies[2].shape).height, 4);
  EXPECT_EQ(name_of(scene_.bodies[3].kind()), "plane");
  EXPECT_TRUE(scene_.bodies[3].fixed) << "a plane is fixed without saying so";
  EXPECT_EQ(std::get<MeshScene>(scene_.bodies[4].shape).file, (folder_.path() / "quay.stl").string());
  EXPECT_EQ(scene_.bodies[4].material, "quay");
}

TEST_F(CompleteScene, OnlyWhatHasNoEffectIsNoted) {
  ASSERT_EQ(scene_.notes.size(), 2u) << scene_.notes.back();
  EXPECT_EQ(scene_.notes[0],
            "<ice><vary>: flexural_strength has no effect in a run without <fracture>; `nilas field` writes it.");
  EXPECT_EQ(scene_.notes[1], "<ice>: breakable has no effect in a run without <fracture>.");
}

TEST(ReadScene, WhatIsNotNamedIsNotThere) {
  const SceneFolder folder;
  const Scene scene = folder.read("<scene version='1'/>");
  EXPECT_EQ(scene.name, "scene") << "from the file's name";
  EXPECT_FALSE(scene.water || scene.hydro || scene.tank || scene.vessel || scene.ice);
  EXPECT_TRUE(scene.bodies.empty());
  EXPECT_EQ(scene.gravity, Vec3(0, 0, -9.81));
}

TEST(ReadScene, DefaultsAreAllBuilt) {
  const SceneFolder folder;
  const Scene scene = folder.read("<scene version='1'/>");
  EXPECT_EQ(name_of(scene.contact.law), "coulomb");
  EXPECT_EQ(name_of(scene.contact.solver), "auto");
  EXPECT_EQ(name_of(scene.contact.integrator), "moreau");
  EXPECT_EQ(scene.contact.theta, 0.5);
  EXPECT_EQ(name_of(scene.contact.stabilisation), "projection");
  EXPECT_EQ(name_of(scene.contact.detection), "continuous");
  EXPECT_EQ(scene.contact.substeps, 0);
  EXPECT_EQ(name_of(scene.output.contacts), "hull");
  EXPECT_TRUE(scene.notes.empty());
}

/// Only the steps of semi-implicit Euler can be cut.
TEST(ReadScene, ASceneWithSubstepsIsSteppedByEulerUnlessItSaysOtherwise) {
  const SceneFolder folder;
  const auto integrator = [&](const std::string& attributes) {
    return folder.read(in_scene("<contact " + attributes + "/>")).contact.integrator;
  };
  EXPECT_EQ(name_of(integrator("substeps='8'")), "semi-implicit-euler");
  EXPECT_EQ(name_of(integrator("substeps='8' detection='discrete'")), "moreau");
  EXPECT_EQ(name_of(integrator("substeps='1'")), "moreau");
  EXPECT_EQ(name_of(integrator("substeps='0'")), "moreau");
  EXPECT_EQ(name_of(integrator("substeps='0' integrator='semi-implicit-euler'")), "semi-implicit-euler");
}

TEST(ReadScene, ThePresetSetsTheOlderChoicesAndWhatIsGivenWins) {
  const SceneFolder folder;
  const ContactScene preset = folder.read(in_scene("<contact preset='metrikin-2014'/>")).contact;
  EXPECT_EQ(name_of(preset.law), "pyramid");
  EXPECT_EQ(name_of(preset.solver), "pgs");
  EXPECT_EQ(preset.tolerance, 0);
  EXPECT_EQ(preset.max_iterations, 50);
  EXPECT_EQ(name_of(preset.stabilisation), "split-impulse");
  EXPECT_EQ(name_of(preset.detection), "discrete");
  EXPECT_EQ(name_of(preset.integrator), "semi-implicit-euler");
  EXPECT_FALSE(preset.gyroscopic);
  const ContactScene given =
      folder.read(in_scene("<contact max_iterations='10' law='coulomb' preset='metrikin-2014'/>")).contact;
  EXPECT_EQ(given.max_iterations, 10);
  EXPECT_EQ(name_of(given.law), "coulomb");
  EXPECT_EQ(given.tolerance, 0);
}

TEST(ReadScene, BuoyancyBringsWaterWithItsDefaults) {
  const SceneFolder folder;
  const Scene scene = folder.read(in_scene("<hydro><buoyancy/></hydro>"));
  ASSERT_TRUE(scene.water);
  EXPECT_EQ(scene.water->density, 1025);
  EXPECT_FALSE(folder.read(in_scene("<hydro><virtual_drag/></hydro>")).water);
}

/// The specification holds only values of the scene: the generator scales the rest with the length.
TEST(ReadScene, GeneratedHullHasTheParametersThatAreNamed) {
  const SceneFolder folder;
  const Scene scene =
      folder.read(in_scene("<vessel><hull generate='icebreaker' length='5' stem_angle_deg='90' triangles='500'/><mass "
                           "value='9'/><fixed/></vessel>"));
  ASSERT_TRUE(scene.vessel->generate);
  EXPECT_EQ(name_of(scene.vessel->generate->kind), "icebreaker");
  EXPECT_EQ(scene.vessel->generate->parameters.at("length"), 5);
  EXPECT_EQ(scene.vessel->generate->parameters.at("triangles"), 500);
  EXPECT_EQ(scene.vessel->generate->parameters.at("stem_angle_deg"), 90);
  EXPECT_EQ(scene.vessel->generate->parameters.size(), 3u);
  EXPECT_TRUE(scene.vessel->fixed);
  EXPECT_TRUE(scene.vessel->hull.empty());
}

TEST(ReadScene, WhatHasNoEffectIsNoted) {
  const SceneFolder folder;
  const auto notes = folder
                         .read(in_scene("<contact preset='metrikin-2014' theta='0.5'/>"
                                        "<body shape='sphere' size='1 1 1'/>"
                                        "<ice><field kind='grid' region='0 0 1 1'><size mean='1'/></field></ice>"
                                        "<output contacts='none'/>"))
                         .notes;
  const std::vector<std::string> expected{"<contact theta>: no effect with integrator 'semi-implicit-euler'.",
                                          "<body size>: no effect with shape 'sphere'.",
                                          "<ice><field><size>: no effect with kind 'grid'."};
  EXPECT_EQ(notes, expected);
}

TEST(ReadScene, APathTakesThePlaceOfTheSpeed) {
  const SceneFolder folder;
  folder.write("track.csv", "t_s,x_m,y_m,yaw_deg\n");
  const Scene scene =
      folder.read(in_scene("<contact preset='metrikin-2014'/><output contacts='none'/><vessel><hull/>"
                           "<mass value='1'/><carriage speed='0.3' ramp='0' ramp_shape='smooth'>"
                           "<path file='track.csv'/></carriage></vessel>"));
  EXPECT_EQ(scene.vessel->carriage->path, (folder.path() / "track.csv").string());
  const std::vector<std::string> expected{"<vessel><carriage speed>: no effect with <path>.",
                                          "<vessel><carriage ramp_shape>: no effect with <path>."};
  EXPECT_EQ(scene.notes, expected);
}

TEST(ReadScene, AFileThatCannotBeOpenedIsAFileError) {
  const SceneFolder folder;
  EXPECT_THROW(read_scene(folder.path() / "none.xml"), FileError);
  EXPECT_THROW(read_scene(folder.path()), FileError) << "a folder";
}

}  // namespace read_scene_test
}  // namespace nilas::scene
