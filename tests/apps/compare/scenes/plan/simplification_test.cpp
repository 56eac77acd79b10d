/// Tests of ablations: the simplifications that they remove from a scene, and the settings that they restore.
#include "apps/compare/scenes/plan/simplification.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "apps/compare/scenes/plan/grid.h"
#include "tests/support/program.h"

namespace simplification_test {

using namespace nilas;
using namespace nilas::compare;
using enum Simplification;

scene::Scene shipped(const std::string& name, const scene::Overrides& more = {}) {
  return scene::read_scene(nilas_test::shipped_scene(name), more);
}

/// The ablation of a shipped scene, as it is read for its run.
scene::Scene without(const scene::Scene& scene, const scene::Overrides& more = {}) {
  return read_with(scene, more, without_simplifications(scene));
}
scene::Scene with(const scene::Scene& scene, Simplification which, const scene::Overrides& more = {}) {
  return read_with(scene, more, with_simplifications(scene, {which}));
}

TEST(Simplification, NoneOfTheOlderToolsIsLeftInItsOwnScene) {
  const scene::Scene bare = without(shipped("metrikin-2014.xml"));
  EXPECT_EQ(name_of(bare.contact.law), "coulomb");
  EXPECT_EQ(name_of(bare.contact.solver), "auto");
  EXPECT_GT(bare.contact.tolerance, 0);
  EXPECT_EQ(name_of(bare.contact.stabilisation), "projection");
  EXPECT_EQ(name_of(bare.contact.detection), "continuous");
  EXPECT_TRUE(bare.contact.gyroscopic);
  EXPECT_EQ(name_of(bare.vessel->carriage->balance.kind), "six-cells");
  const scene::FractureScene& fracture = bare.fracture.value();
  EXPECT_EQ(name_of(fracture.crushing->model), "compliant");
  EXPECT_TRUE(fracture.crushing->between_floes);
  EXPECT_NEAR(fracture.crushing->clear_volume.value(), 6.4e-5, 1e-12) << "the cube of the thickness";
  EXPECT_EQ(name_of(fracture.splitting->model), "lefm");
  EXPECT_EQ(name_of(fracture.cracks->path), "curved");
  ASSERT_EQ(bare.ice->vary.size(), 1u);
  EXPECT_EQ(name_of(bare.ice->vary[0].property), "flexural_strength");
  EXPECT_DOUBLE_EQ(bare.ice->vary[0].cov, 0.25);
  EXPECT_DOUBLE_EQ(bare.ice->vary[0].correlation_length, 0.4);
}

TEST(Simplification, EachIsPutBackAlone) {
  const scene::Scene scene = shipped("metrikin-2014.xml");
  EXPECT_EQ(name_of(with(scene, crushing_limit).fracture->crushing->model), "explicit");
  EXPECT_TRUE(with(scene, crushing_limit).fracture->crushing->between_floes);
  EXPECT_FALSE(with(scene, rigid_floes).fracture->crushing->between_floes);
  EXPECT_GT(with(scene, no_extrusion).fracture->crushing->clear_volume.value(), 1e20);
  EXPECT_EQ(name_of(with(scene, geometric_splitting).fracture->splitting->model), "geometric");
  EXPECT_EQ(name_of(with(scene, straight_cracks).fracture->cracks->path), "straight");
  EXPECT_EQ(with(scene, uniform_ice).ice->vary.at(0).cov, 0);
  EXPECT_EQ(name_of(with(scene, uniform_ice).fracture->splitting->model), "lefm");
}

TEST(Simplification, WhatASceneSaysItselfStays) {
  const scene::Overrides own{{"fracture/crushing/@model", "pressure-area"},
                             {"fracture/crushing/@clear_volume", "1e-3"},
                             {"ice/vary[+]/@property", "thickness"},
                             {"ice/vary[+]/@cov", "0.1"}};
  const scene::Scene scene = shipped("metrikin-2014.xml", own);
  const scene::Scene bare = without(scene, own);
  EXPECT_EQ(name_of(bare.fracture->crushing->model), "pressure-area");
  EXPECT_EQ(bare.fracture->crushing->clear_volume, 1e-3);
  ASSERT_EQ(bare.ice->vary.size(), 1u);
  EXPECT_EQ(name_of(bare.ice->vary[0].property), "thickness");
  EXPECT_EQ(bare.ice->vary[0].cov, 0.1);
  EXPECT_EQ(with(scene, uniform_ice, own).ice->vary.at(0).cov, 0);
  EXPECT_EQ(name_of(with(scene, crushing_limit, own).fracture->crushing->model), "explicit");
}

TEST(Simplification, HasARowOnlyWhereTheSceneHasWhatItConcerns) {
  const scene::Scene towing = shipped("towing.xml");
  for (const Simplification which : {crushing_limit, rigid_floes, no_extrusion, geometric_splitting, straight_cracks,
                                     uniform_ice, no_rolling, uniform_inertia}) {
    EXPECT_FALSE(no_effect(which, towing).empty()) << name_of(which);
    EXPECT_TRUE(taking_out(which, towing).empty()) << name_of(which);
  }
  GridRequest request;
  request.ablate = true;
  const Grid grid = make_grid(shipped("metrikin-2014.xml"), {}, request);
  std::set<Simplification> rows;
  for (const CompareSetting& setting : grid.settings)
    if (setting.simplifications.size() == 1) rows.insert(setting.simplifications.front());
  for (const Simplification which : {pyramid, fixed_sweeps, crushing_limit, geometric_splitting, straight_cracks,
                                     uniform_ice, rigid_floes, no_extrusion})
    EXPECT_TRUE(rows.count(which)) << name_of(which);
  EXPECT_TRUE(grid.refused.empty()) << grid.refused.front().reason;
  EXPECT_EQ(grid.settings.at(1).simplifications, std::vector{pyramid}) << "the first fault comes first";
}

/// Neither is allowed there, so that "all together" runs without them.
TEST(Simplification, AVesselOnRodsKeepsItsGyroscopicTorqueAndItsBalance) {
  const scene::Scene tied = shipped(
      "towing.xml", {{"vessel/rod[+]/@name", "tie"}, {"vessel/rod[+]/@at", "1 0 0.1"}, {"vessel/rod[+]/@to", "1 9 0"}});
  for (const Simplification which : {no_gyroscopic, prismatic}) {
    EXPECT_FALSE(no_effect(which, tied).empty()) << name_of(which);
    EXPECT_TRUE(no_effect(which, shipped("towing.xml")).empty()) << name_of(which);
  }
}

TEST(Simplification, ElasticPairsBecomeRigid) {
  EXPECT_FALSE(no_effect(rigid_contacts, shipped("towing.xml")).empty());
  const scene::Overrides elastic{{"contact/friction[1]/@elastic", "true"}, {"contact/friction[2]/@elastic", "true"}};
  EXPECT_TRUE(without(shipped("towing.xml", elastic), elastic).contact.friction.at(1).elastic);
  const scene::Scene simple = with(shipped("towing.xml", elastic), rigid_contacts, elastic);
  for (const scene::FrictionScene& pair : simple.contact.friction) EXPECT_FALSE(pair.elastic);
}

TEST(Simplification, RollingFrictionIsTakenFromEveryPair) {
  const scene::Overrides rolling{{"contact/friction[1]/@rolling", "0.01"}, {"contact/friction[2]/@spinning", "0.02"}};
  const scene::Scene scene = shipped("towing.xml", rolling);
  EXPECT_EQ(without(scene, rolling).contact.friction.at(0).rolling, 0.01);
  const scene::Scene simple = with(scene, no_rolling, rolling);
  EXPECT_EQ(simple.contact.friction.at(0).rolling, 0);
  EXPECT_EQ(simple.contact.friction.at(1).spinning, 0);
}

TEST(Simplification, UniformInertiaIsThatOfTheHullByDefault) {
  const scene::Overrides own{{"vessel/mass/@inertia", "400 4000 4000 0 0 0"}};
  const scene::Scene scene = shipped("towing.xml", own);
  const Vec6 entries = with(scene, uniform_inertia, own).vessel->mass.inertia.value();
  // as `nilas run` writes it of the scene as shipped: docs/reference/outputs.md, vessel.inertia_kg_m2
  EXPECT_NEAR(entries[0], 210.98131338083203, 1e-6);
  EXPECT_NEAR(entries[1], 2836.9196034247525, 1e-6);
  EXPECT_NEAR(entries[4], -23.445128627636898, 1e-6);
  EXPECT_TRUE(taking_out(uniform_inertia, scene).empty());
}

TEST(Simplification, WhatNilasDoesNotModelIsSaid) {
  std::set<std::string> names;
  for (const Inexpressible& one : inexpressible_simplifications()) names.insert(one.name);
  EXPECT_TRUE(names.count("hydrodynamics"));
  EXPECT_TRUE(names.count("creep"));
}

}  // namespace simplification_test
