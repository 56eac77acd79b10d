/// Floes whose properties vary, as bodies: mass, draught, contact geometry, rest, files.
#include <gtest/gtest.h>

#include <cmath>

#include "core/field/sizes/distribution_statistics.h"
#include "core/geometry/mass_properties.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/build/build_world.h"
#include "core/sim/simulation.h"
#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace nilas::sim {
namespace vary_ice_test {

constexpr double k_water = 1005;

/// 20 x 20 squares of 0.47 m in still water.
std::string scene_with(const std::string& content) {
  return "<scene version='1'><time step='0.01' end='1'/><seed value='3'/><contact law='coulomb' solver='nsgs'/>\n"
         "<water density='1005'/><hydro><buoyancy/></hydro>\n<ice density='900' thickness='0.05'>\n" +
         content + "</ice></scene>";
}
const std::string k_grid = "<field kind='grid' region='0 0 10 10' rows='20' columns='20' gap='0.03'/>\n";
const std::string k_vary =
    "<vary property='thickness' cov='0.1'/>\n<vary property='density' distribution='uniform' cov='0.02' "
    "with='thickness' correlation='0.6'/>\n<vary property='flexural_strength' distribution='weibull' cov='0.3'/>\n";

class VaryIce : public testing::Test {
 protected:
  scene::Scene read(const std::string& content) const {
    return scene::read_scene(folder_.write("scene.xml", scene_with(content)));
  }
  WorldParts world(const std::string& content, int threads = 1) {
    return build_world(read(content), threads, warnings_);
  }

  test::ScratchFolder folder_;
  WarningCounts warnings_{make_logger("off", "")};
};

TEST_F(VaryIce, MassDraughtAndContactGeometryAreThoseOfEachFloe) {
  const WorldParts parts = world(k_grid + k_vary);
  ASSERT_EQ(parts.ice.size(), 1u);
  const auto& floes = parts.ice[0].floes;
  ASSERT_EQ(floes.size(), 400u);
  double mass = 0;
  for (std::size_t b = 0; b < floes.size(); ++b) {
    const field::FieldFloe& floe = floes[b].floe;
    EXPECT_DOUBLE_EQ(parts.bodies.mass[b],
                     floe.density * floe.thickness * geometry::polygon_moments(floe.outline).area);
    EXPECT_EQ(parts.bodies.shape[b]->thickness, floe.thickness);
    EXPECT_DOUBLE_EQ(parts.bodies.shape[b]->parts[0].smallest_width, floe.thickness);
    const double draught = 0.5 * floe.thickness - parts.bodies.p_GB[b].z();
    EXPECT_NEAR(draught, floe.thickness * floe.density / k_water, 1e-15);
    mass += parts.bodies.mass[b];
  }
  EXPECT_NEAR(parts.info.ice_mass, mass, 1e-12 * mass);
}

/// 400 floes: four standard errors.
TEST_F(VaryIce, TheFloesHaveWhatWasAsked) {
  const WorldParts parts = world(k_grid + k_vary);
  std::vector<double> thickness, density, strength;
  for (const auto& one : parts.ice[0].floes) {
    thickness.push_back(one.floe.thickness);
    density.push_back(one.floe.density);
    strength.push_back(one.floe.flexural_strength);
    EXPECT_LT(one.floe.density, k_water);
  }
  const double n = 400, error = 4 / std::sqrt(n);
  EXPECT_NEAR(field::summary_of(thickness).mean, 0.05, error * 0.005);
  EXPECT_NEAR(field::summary_of(thickness).sd, 0.005, error * 0.005 / std::sqrt(2.0));
  EXPECT_NEAR(field::summary_of(density).mean, 900, error * 18);
  EXPECT_NEAR(field::summary_of(strength).mean, 4e4, error * 1.2e4);
  EXPECT_NEAR(field::score_correlation(thickness, density), 0.6, error * (1 - 0.36));
  EXPECT_NEAR(field::score_correlation(thickness, strength), 0, error);
}

/// Each floats at its own draught, so nothing moves and no energy is lost; a floe that is too heavy for its draught
/// would heave at once.
TEST_F(VaryIce, FloesStayAtRestAndTheLedgerBalances) {
  Simulation simulation(read(k_grid + k_vary), 1, warnings_);
  StepRecord record;
  for (int k = 0; k < 20; ++k) record = simulation.step();
  double fastest = 0;
  for (const Vec3& v : simulation.bodies().v_GB) fastest = std::max(fastest, v.norm());
  EXPECT_LT(fastest, 1e-12);
  EXPECT_NEAR(record.ledger.imbalance, 0, 1e-9);
}

TEST_F(VaryIce, ThreadsChangeNoBit) {
  const std::string texture =
      "<vary property='thickness' cov='0.1' correlation_length='0.6'/>\n"
      "<vary property='flexural_strength' distribution='lognormal' cov='0.2' correlation_length='0.6' "
      "with='thickness' correlation='0.5'/>\n<vary property='density' cov='0.01'/>\n";
  const WorldParts one = world(k_grid + texture, 1), three = world(k_grid + texture, 3);
  for (std::size_t b = 0; b < one.ice[0].floes.size(); ++b) {
    const PlannedFloe &a = one.ice[0].floes[b], &c = three.ice[0].floes[b];
    for (const auto property : field::k_floe_properties)
      EXPECT_EQ(field::value_of(a.floe, property), field::value_of(c.floe, property));
    ASSERT_EQ(a.texture.size(), 2u);
    EXPECT_EQ(a.texture[0].texture.at(0.1, -0.2), c.texture[0].texture.at(0.1, -0.2));
    EXPECT_EQ(one.bodies.mass[b], three.bodies.mass[b]);
  }
}

/// A field that was written reads back to the same bodies, whatever the scene varies then.
TEST_F(VaryIce, AFileCarriesTheProperties) {
  const WorldParts drawn = world(k_grid + k_vary);
  field::FieldResult field;
  for (const auto& one : drawn.ice[0].floes) field.floes.push_back(one.floe);
  field::write_field(field, folder_.path() / "field.geojson");
  const std::string file = "<field kind='file' file='field.geojson'/>\n";
  for (const std::string& content : {file, file + k_vary}) {
    const WorldParts read = world(content);
    ASSERT_EQ(read.bodies.size(), drawn.bodies.size());
    for (std::size_t b = 0; b < drawn.ice[0].floes.size(); ++b) {
      EXPECT_EQ(read.bodies.mass[b], drawn.bodies.mass[b]);
      EXPECT_EQ(read.bodies.p_GB[b], drawn.bodies.p_GB[b]);
      EXPECT_EQ(read.bodies.inertia_B[b], drawn.bodies.inertia_B[b]);
      for (const auto property : field::k_floe_properties)
        EXPECT_EQ(field::value_of(read.ice[0].floes[b].floe, property),
                  field::value_of(drawn.ice[0].floes[b].floe, property));
    }
  }
}

TEST_F(VaryIce, SingleFloesAndFieldsVaryAboutTheirOwnThickness) {
  const std::string floes =
      "<field kind='grid' region='0 0 4 2' rows='2' columns='4' gap='0.1' thickness='0.2'/>\n"
      "<floe name='big' outline='20 0 22 0 22 1 20 1' thickness='0.3'/>\n";
  const WorldParts parts = world(floes + "<vary property='thickness' cov='0.05'/>");
  ASSERT_EQ(parts.ice.size(), 2u);
  for (const auto& one : parts.ice[0].floes) EXPECT_NEAR(one.floe.thickness, 0.2, 5 * 0.01);
  EXPECT_NEAR(parts.ice[1].floes[0].floe.thickness, 0.3, 5 * 0.015);
  EXPECT_NE(parts.ice[1].floes[0].floe.thickness, 0.3);
  // one score per name: the same ice without the field
  EXPECT_EQ(world("<floe name='big' outline='20 0 22 0 22 1 20 1' thickness='0.3'/>\n"
                  "<vary property='thickness' cov='0.05'/>")
                .ice[0]
                .floes[0]
                .floe.thickness,
            parts.ice[1].floes[0].floe.thickness);
}

TEST_F(VaryIce, WhatIsBuiltIsNamed) {
  const WorldParts parts = world(k_grid + k_vary);
  const auto named = [&](const std::string& name) {
    for (const auto& [module, why] : parts.info.modules)
      if (module == name) return why;
    return std::string();
  };
  EXPECT_EQ(named("vary thickness"), "<ice><vary>: normal, cov 0.1, one value per floe");
  EXPECT_NE(named("vary flexural_strength").find("weibull"), std::string::npos);
}

TEST_F(VaryIce, IceAsHeavyAsTheWaterIsRefusedWithItsLine) {
  const auto file = folder_.write("heavy.xml",
                                  "<scene version='1'>\n<water density='1000'/><hydro><buoyancy/></hydro>\n"
                                  "<ice density='1000'>\n<floe outline='0 0 1 0 1 1'/>\n<vary property='density'/>\n"
                                  "</ice></scene>");
  test::expect_refusal([&] { build_world(scene::read_scene(file), 1, warnings_); },
                       {"heavy.xml:5: <ice><vary>: density varies about 1000 kg/m^3"});
}

}  // namespace vary_ice_test
}  // namespace nilas::sim
