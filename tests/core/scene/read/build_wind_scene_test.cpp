/// Currents, wind and propeller wash arrive in the scene, with their defaults and notes.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/scene/complete_scene.h"
#include "tests/support/mentions.h"

namespace nilas::scene {
namespace build_wind_scene_test {

using testing::in_scene;
using testing::SceneFolder;

class CompleteWindScene : public ::testing::Test {
 protected:
  CompleteWindScene() {
    testing::write_inputs(folder_);
    scene_ = folder_.read(testing::k_complete_scene);
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  SceneFolder folder_;
  Scene scene_;
};

TEST_F(CompleteWindScene, Current) {
  const CurrentScene& current = *scene_.water->current;
  EXPECT_EQ(current.profile, path("keel.csv"));
  EXPECT_EQ(current.series, path("tide.csv"));
}

/// Files of currents and coefficients are inputs of the run, copied and known by their SHA-256.
TEST_F(CompleteWindScene, FilesAreInputs) {
  for (const char* name : {"keel.csv", "tide.csv", "coefficients.csv"}) {
    const auto input = std::find_if(scene_.inputs.begin(), scene_.inputs.end(),
                                    [&](const InputFile& file) { return file.source == path(name); });
    ASSERT_NE(input, scene_.inputs.end()) << name;
    EXPECT_EQ(input->sha256.size(), 64u);
    EXPECT_EQ(input->copy, std::string("inputs/") + name);
  }
}

TEST_F(CompleteWindScene, Wind) {
  const WindScene& wind = *scene_.wind;
  EXPECT_EQ(wind.speed, 12);
  EXPECT_EQ(wind.direction_deg, 60);
  EXPECT_EQ(wind.density, 1.3);
  EXPECT_EQ(wind.profile, WindProfileKind::power);
  EXPECT_EQ(wind.exponent, 0.1);
  EXPECT_EQ(wind.gusts, GustSpectrum::npd);
  EXPECT_EQ(wind.floe_drag, 0.003);
}

TEST_F(CompleteWindScene, WindArea) {
  const WindAreaScene& area = *scene_.vessel->wind_area;
  EXPECT_EQ(area.model, WindAreaModel::coefficients);
  EXPECT_EQ(area.ship_type, std::nullopt);
  EXPECT_EQ(area.file, path("coefficients.csv"));
  EXPECT_EQ(area.frontal, 0.5);
  EXPECT_EQ(area.lateral, 2);
  EXPECT_EQ(area.length, 6);
  EXPECT_EQ(area.midship, 2.8);
  EXPECT_EQ(area.lateral_centroid, -0.1);
  EXPECT_EQ(area.height, 0.3);
}

TEST_F(CompleteWindScene, Jets) {
  const auto& jets = scene_.hydro->jets;
  ASSERT_EQ(jets.size(), 2u);
  EXPECT_EQ(jets[0].thruster, "stern");
  EXPECT_EQ(jets[0].thrust, std::nullopt);
  EXPECT_EQ(jets[0].diameter, 0.2);
  EXPECT_EQ(jets[0].position, Vec3(-3, 0, -0.2));
  EXPECT_EQ(jets[0].direction, std::nullopt);
  EXPECT_GT(jets[0].line, 10);
  EXPECT_EQ(jets[1].thruster, "");
  EXPECT_EQ(jets[1].thrust, 40);
  EXPECT_EQ(jets[1].direction, Vec3(0, -2, 0));
}

TEST(WindScenes, DefaultsAreThoseOfTheStructs) {
  const SceneFolder folder;
  const Scene scene =
      folder.read(in_scene("<water/><hydro><drag/><propeller_wash><jet thrust='1' diameter='1' position='0 0 0'/>"
                           "</propeller_wash></hydro>"
                           "<wind speed='3'/><vessel><hull/><mass value='1'/>"
                           "<wind_area ship_type='ferry' frontal='1' lateral='2'/></vessel>"));
  WindScene wind = *scene.wind;
  EXPECT_EQ(wind.speed, 3);
  wind.speed = WindScene{}.speed;
  EXPECT_EQ(wind, WindScene{});
  WindAreaScene area = *scene.vessel->wind_area;
  EXPECT_EQ(area.ship_type, BlendermannShip::ferry);
  area.ship_type.reset(), area.frontal = 0, area.lateral = 0;
  EXPECT_EQ(area, WindAreaScene{});
  JetScene jet = scene.hydro->jets.at(0);
  jet.thrust.reset(), jet.diameter = 0, jet.line = 0;
  EXPECT_EQ(jet, JetScene{});
  EXPECT_EQ(folder.read(in_scene("<water/>")).wind, std::nullopt);
}

TEST(WindScenes, WhatHasNoEffectIsNoted) {
  const SceneFolder folder;
  testing::write_inputs(folder);
  const auto expect_note = [&](const std::string& content, const std::string& words) {
    const auto& notes = folder.read(in_scene(content)).notes;
    EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [&](const auto& note) { return test::mentions(note, words); }))
        << words;
  };
  const std::string vessel = "<vessel><hull/><mass value='1'/>";
  const std::string wash = "<propeller_wash><jet thrust='1' diameter='1' position='0 0 0'/></propeller_wash>";
  expect_note("<water><current series='tide.csv'/></water>",
              "<water><current series>: no effect on bodies without <hydro><drag>");
  expect_note("<water/><hydro><buoyancy/>" + wash + "</hydro>" + vessel + "</vessel>",
              "<hydro><propeller_wash>: no effect without <hydro><drag>");
  expect_note(vessel + "<wind_area ship_type='ferry' frontal='1' lateral='2'/></vessel>",
              "<vessel><wind_area>: no effect without <wind>");
  expect_note("<wind speed='3'/>", "<wind>: no effect without <ice>");
  expect_note("<wind speed='3' exponent='0.2'/>", "<wind exponent>: no effect with profile 'uniform'");
}

}  // namespace build_wind_scene_test
}  // namespace nilas::scene
