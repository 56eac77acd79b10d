/// <fracture> and what it means for <vary>, from XML to plain values.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/scene/scene_files.h"

namespace nilas::scene {
namespace fracture_scene_test {

using testing::expect_fault;
using testing::in_scene;
using testing::SceneFolder;

const std::string k_ice = "<ice><floe breakable='true' outline='0 0 1 0 1 1'/></ice>";

int count(const Scene& scene, const std::string& note) {
  return static_cast<int>(std::count(scene.notes.begin(), scene.notes.end(), note));
}

TEST(FractureScene, ReadsToPlainValues) {
  const SceneFolder folder;
  const Scene scene = folder.read(
      in_scene(k_ice + "<fracture flexural_strength='5e4' compressive_strength='2e5' fracture_toughness='4e3' "
                       "min_area='1e-3' max_aspect='6'>"
                       "<crushing model='pressure-area' coefficient='3e5' exponent='-0.1'/></fracture>"));
  ASSERT_TRUE(scene.fracture.has_value());
  const FractureScene& fracture = *scene.fracture;
  EXPECT_EQ(fracture.flexural_strength, 5e4);
  EXPECT_EQ(fracture.compressive_strength, 2e5);
  EXPECT_EQ(fracture.fracture_toughness, 4e3);
  EXPECT_EQ(fracture.min_area, 1e-3);
  EXPECT_EQ(fracture.max_aspect, 6);
  ASSERT_TRUE(fracture.crushing.has_value());
  EXPECT_EQ(name_of(fracture.crushing->model), "pressure-area");
  EXPECT_EQ(fracture.crushing->coefficient, 3e5);
  EXPECT_EQ(fracture.crushing->exponent, -0.1);
  EXPECT_EQ(SceneFolder().read(scene.as_run).as_run, scene.as_run);
}

TEST(FractureScene, DefaultsAreTheSeedsModel) {
  const SceneFolder folder;
  const Scene scene = folder.read(in_scene(k_ice + "<fracture><crushing/></fracture>"));
  EXPECT_EQ(name_of(scene.fracture->crushing->model), "explicit");
  EXPECT_EQ(scene.fracture->compressive_strength, 1e5);
  EXPECT_TRUE(scene.notes.empty()) << scene.notes.front();
  EXPECT_FALSE(folder.read(in_scene(k_ice)).fracture.has_value());
}

TEST(FractureScene, WhatHasNoEffectIsNamed) {
  const SceneFolder folder;
  const std::string crushing = "<fracture><crushing/></fracture>";
  EXPECT_EQ(count(folder.read(in_scene("<ice><floe outline='0 0 1 0 1 1'/></ice>" + crushing)),
                  "<fracture>: no effect: no <field> or <floe> is breakable."),
            1);
  EXPECT_EQ(count(folder.read(in_scene(k_ice + "<fracture/>")),
                  "<fracture>: no effect: it names no <crushing>, <bending> or <splitting>."),
            1);
  EXPECT_EQ(count(folder.read(in_scene(k_ice + "<fracture><crushing exponent='0'/></fracture>")),
                  "<fracture><crushing exponent>: no effect with model 'explicit'."),
            1);
  const Scene varied = folder.read(
      in_scene("<ice><floe breakable='true' outline='0 0 1 0 1 1'/><vary property='flexural_strength' cov='0.1'/>"
               "<vary property='compressive_strength' cov='0.1'/></ice>" +
               crushing));
  ASSERT_EQ(varied.notes.size(), 1u);
  EXPECT_EQ(varied.notes.front(),
            "<ice><vary>: flexural_strength has no effect in a run without <bending>; `nilas field` writes it.");
}

TEST(FractureScene, BendingAndSplittingTakeTheirSettings) {
  const SceneFolder folder;
  const std::string water = "<water/><hydro><buoyancy/></hydro>";
  const Scene plain = folder.read(in_scene(water + k_ice + "<fracture><bending/><splitting/></fracture>"));
  ASSERT_TRUE(plain.fracture->bending && plain.fracture->splitting);
  EXPECT_EQ(count(plain,
                  "<fracture>: without <crushing> ice breaks by the peaks of rigid contacts, which depend on the "
                  "step."),
            1);
  EXPECT_EQ(name_of(plain.fracture->bending->model), "nevel");
  EXPECT_EQ(plain.fracture->bending->wedge_angle_deg, 45);
  EXPECT_EQ(plain.fracture->bending->speed_slope, 0);
  EXPECT_EQ(name_of(plain.fracture->splitting->model), "geometric");
  EXPECT_EQ(plain.fracture->splitting->multiplier, 2.5);
  EXPECT_EQ(name_of(plain.fracture->small_pieces), "brash");
  const Scene given =
      folder.read(in_scene(water + k_ice +
                           "<fracture small_pieces='refuse'><bending wedge_angle_deg='60' speed_slope='-0.14'/>"
                           "<splitting model='lefm'/></fracture>"));
  EXPECT_EQ(given.fracture->bending->wedge_angle_deg, 60);
  EXPECT_EQ(given.fracture->bending->speed_slope, -0.14);
  EXPECT_EQ(name_of(given.fracture->splitting->model), "lefm");
  EXPECT_EQ(name_of(given.fracture->small_pieces), "refuse");
  const std::string vary =
      "<ice><floe breakable='true' outline='0 0 1 0 1 1'/><vary property='flexural_strength' cov='0.1'/></ice>";
  EXPECT_TRUE(folder.read(in_scene(water + vary + "<fracture><crushing/><splitting/></fracture>")).notes.empty())
      << "radial cracks take the flexural strength";
}

TEST(FractureScene, WeakLinesBondsAndCurvedCracks) {
  const SceneFolder folder;
  const std::string water = "<water/><hydro><buoyancy/></hydro>";
  const std::string ice =
      "<ice><field kind='voronoi' region='0 0 9 9' concentration='1' breakable='true'><bond strength='0.4'/></field>"
      "<weak_line points='0 0 1 2 3 4' strength='0.25'/></ice>";
  const std::string fracture =
      "<fracture><crushing/><bending/><cracks path='curved' segment_thicknesses='3'/></fracture>";
  const Scene scene = folder.read(in_scene(water + ice + fracture));
  EXPECT_EQ(std::get<VoronoiFieldScene>(scene.ice->fields.at(0).form).bond, 0.4);
  const WeakLineScene& line = scene.ice->weak_lines.at(0);
  EXPECT_EQ(line.points, (std::vector<Vec2>{{0, 0}, {1, 2}, {3, 4}}));
  EXPECT_EQ(line.strength, 0.25);
  EXPECT_EQ(name_of(scene.fracture->cracks->path), "curved");
  EXPECT_EQ(scene.fracture->cracks->segment_thicknesses, 3);
  EXPECT_TRUE(scene.notes.empty()) << scene.notes.front();
  EXPECT_EQ(SceneFolder().read(scene.as_run).as_run, scene.as_run);

  const Scene straight = folder.read(in_scene(water + ice + "<fracture><crushing/><bending/></fracture>"));
  const std::string without = ": no effect without <fracture><cracks path=\"curved\">.";
  EXPECT_EQ(count(straight, "<ice><weak_line>" + without), 1);
  EXPECT_EQ(count(straight, "<ice><field><bond>" + without), 1);
  EXPECT_EQ(count(folder.read(in_scene(k_ice + "<fracture><crushing/><cracks path='curved'/></fracture>")),
                  "<fracture><cracks>: no effect without <bending> or <splitting>."),
            1);
  const auto faults = [&](const std::string& content) { return folder.faults(in_scene("<ice>" + content + "</ice>")); };
  expect_fault(faults("<weak_line points='0 0 1' strength='0.5'/>"), 2, "<ice><weak_line points>", {"at least 4"});
  expect_fault(faults("<weak_line points='0 0 1 1 2' strength='0.5'/>"), 2, "<ice><weak_line points>", {"even"});
  expect_fault(faults("<weak_line points='0 0 1 1'/>"), 2, "<ice><weak_line strength>", {"missing"});
  expect_fault(faults("<weak_line points='0 0 1 1' strength='0'/>"), 2, "<ice><weak_line strength>", {"> 0"});
  expect_fault(faults("<field kind='voronoi' region='0 0 1 1'><bond strength='1'/></field>"), 2,
               "<ice><field concentration>", {"allowed with <bond>: 1"});
  EXPECT_TRUE(
      faults("<field kind='packed' region='0 0 1 1' concentration='0.5'><bond strength='0.5'/></field>").empty());
}

TEST(FractureScene, StrengthsVaryAboutItsOwn) {
  const SceneFolder folder;
  const std::string ice =
      "<ice><floe breakable='true' outline='0 0 1 0 1 1'/>"
      "<vary property='compressive_strength' cov='0.1'/></ice>";
  EXPECT_EQ(folder.read(in_scene(ice + "<fracture compressive_strength='3e5'/>")).ice->vary.at(0).mean, 3e5);
  EXPECT_EQ(folder.read(in_scene("<fracture compressive_strength='3e5'/>" + ice)).ice->vary.at(0).mean, 3e5);
}

TEST(FractureScene, FaultsAreFound) {
  const SceneFolder folder;
  const auto faults = [&](const std::string& content) { return folder.faults(in_scene(k_ice + content)); };
  expect_fault(faults("<fracture compressive_strength='0'/>"), 2, "<fracture compressive_strength>", {"> 0"});
  expect_fault(faults("<fracture><crushing model='compliance'/></fracture>"), 2, "<fracture><crushing model>",
               {"compliant"});
  expect_fault(faults("<fracture><crushing model='pressure-area' exponent='-1'/></fracture>"), 2,
               "<fracture><crushing exponent>", {">= -0.95"});
  expect_fault(faults("<fracture><splitting/></fracture>"), 2, "<fracture><splitting>", {"with <hydro><buoyancy>"});
  expect_fault(faults("<water/><hydro><buoyancy/></hydro><fracture><bending wedge_angle_deg='0'/></fracture>"), 2,
               "<fracture><bending wedge_angle_deg>", {">= 5"});
  expect_fault(faults("<water/><hydro><buoyancy/></hydro><fracture><splitting multiplier='1'/></fracture>"), 2,
               "<fracture><splitting multiplier>", {"> 1"});
  expect_fault(faults("<fracture><cracks path='crooked'/></fracture>"), 2, "<fracture><cracks path>", {"curved"});
}

}  // namespace fracture_scene_test
}  // namespace nilas::scene
