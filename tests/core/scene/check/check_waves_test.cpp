/// Waves and their loads: values that contradict each other are refused, and what has no effect is noted.
#include <gtest/gtest.h>

#include "tests/core/scene/scene_files.h"

namespace nilas::scene {
namespace check_waves_test {

using testing::expect_fault;
using testing::in_scene;
using testing::SceneFolder;
using testing::text_of;

const std::string k_regular = "<waves height='1' period='8'/>", k_floats = "<buoyancy/>";

std::vector<Fault> faults_of(const std::string& waves, const std::string& hydro, const std::string& more = "") {
  const SceneFolder folder;
  return folder.faults(in_scene("<water>" + waves + "</water><hydro>" + hydro + "</hydro>" + more));
}

TEST(CheckWaves, WholeScenesAreTaken) {
  EXPECT_TRUE(faults_of(k_regular, k_floats + "<wave_loads/>").empty());
  EXPECT_TRUE(
      faults_of(k_regular + "<waves kind='jonswap' height='1' period='8' shortest_period='3'/>", k_floats).empty());
  EXPECT_TRUE(faults_of(k_regular, "<wave_loads vessel='none' floes='none'/>").empty());
  EXPECT_TRUE(faults_of("<waves height='1' period='8' attenuation='meylan' ice_edge='0 0'/>", k_floats).empty());
}

TEST(CheckWaves, ASpectrumNeedsItsPeak) {
  expect_fault(faults_of("<waves kind='jonswap' height='1' period='8' shortest_period='8'/>", k_floats), 2,
               "<water><waves shortest_period>", {"found 8", "< 8 [s]"});
  // A regular wave has no shorter ones: the attribute has no effect there.
  EXPECT_TRUE(faults_of("<waves height='1' period='8' shortest_period='9'/>", k_floats).empty());
}

TEST(CheckWaves, AttenuationNeedsAnIceEdge) {
  expect_fault(faults_of("<waves height='1' period='8' attenuation='exponential'/>", k_floats), 2,
               "<water><waves attenuation>", {"without ice_edge"});
}

TEST(CheckWaves, LoadsNeedWavesAndBuoyancy) {
  expect_fault(faults_of("", k_floats + "<wave_loads/>"), 2, "<hydro><wave_loads>", {"no waves"});
  expect_fault(faults_of(k_regular, "<wave_loads/>"), 2, "<hydro><wave_loads floes>", {"with <buoyancy>"});
  const std::string vessel = "<vessel position='0 0 0'><hull/><mass value='1'/></vessel>";
  expect_fault(faults_of(k_regular, "<wave_loads floes='none'/>", vessel), 2, "<hydro><wave_loads vessel>",
               {"with <buoyancy>"});
}

TEST(CheckWaves, LoadsFromADatabaseNeedOne) {
  const std::string vessel = "<vessel position='0 0 0'><hull/><mass value='1'/></vessel>";
  expect_fault(faults_of(k_regular, k_floats + "<wave_loads vessel='database'/>"), 2, "<hydro><wave_loads vessel>",
               {"no vessel"});
  expect_fault(faults_of(k_regular, k_floats + "<wave_loads vessel='database'/>", vessel), 2,
               "<hydro><wave_loads vessel>", {"with <hydro><database>"});
  expect_fault(faults_of(k_regular, k_floats + "<wave_loads diffraction='database'/>", vessel), 2,
               "<hydro><wave_loads diffraction>", {"with <hydro><database>"});
}

TEST(CheckWaves, TheReferenceTakesNoWaveLoads) {
  expect_fault(faults_of(k_regular, k_floats + "<wave_loads/>", "<contact integrator='reference'/>"), 2,
               "<hydro><wave_loads>", {"does not take <wave_loads>"});
}

TEST(CheckWaves, WavesWithoutLoadsAreNoted) {
  const SceneFolder folder;
  const auto notes = [&](const std::string& hydro) {
    std::string all;
    for (const auto& note : folder.read(in_scene("<water>" + k_regular + "</water>" + hydro)).notes) all += note + "\n";
    return all;
  };
  EXPECT_NE(notes("<hydro><drag/></hydro>").find("waves act only through drag"), std::string::npos);
  EXPECT_NE(notes("").find("<water><waves>: no effect"), std::string::npos);
  EXPECT_EQ(notes("<hydro><buoyancy/><wave_loads/></hydro>").find("<waves>"), std::string::npos);
}

/// 0.142 g T^2 / 2 pi is 3.55 m at 4 s; a sea stays below 1/15, 1.67 m.
TEST(CheckWaves, WavesThatBreakAreDoubted) {
  const SceneFolder folder;
  const auto doubted = [&](const std::string& waves) {
    return folder.read(in_scene("<water>" + waves + "</water><hydro><buoyancy/><wave_loads/></hydro>")).warnings.size();
  };
  EXPECT_EQ(doubted("<waves height='3.5' period='4'/>"), 0u);
  EXPECT_EQ(doubted("<waves height='3.6' period='4'/>"), 1u);
  EXPECT_EQ(doubted("<waves kind='jonswap' height='1.6' period='4'/>"), 0u);
  EXPECT_EQ(doubted("<waves kind='jonswap' height='1.7' period='4'/>"), 1u);
}

/// The defaults that the table prints are those of the structs.
TEST(CheckWaves, DefaultsAreThoseOfTheStructs) {
  const SceneFolder folder;
  const Scene scene =
      folder.read(in_scene("<water><waves height='1' period='8'/><waves kind='jonswap' height='1' "
                           "period='8' attenuation='exponential' ice_edge='1 2'/></water>"
                           "<hydro><buoyancy/><wave_loads/></hydro>"));
  ASSERT_EQ(scene.water->waves.size(), 2u);
  for (WaveScene waves : scene.water->waves) {
    WaveScene plain;
    plain.kind = waves.kind;
    plain.height = 1;
    plain.period = 8;
    plain.line = waves.line;
    plain.attenuation = waves.attenuation;
    plain.ice_edge = waves.ice_edge;
    EXPECT_EQ(waves, plain);
    EXPECT_EQ(waves.shortest(), 2);
  }
  EXPECT_EQ(scene.hydro->wave_loads, WaveLoadsScene{});
}

}  // namespace check_waves_test
}  // namespace nilas::scene
