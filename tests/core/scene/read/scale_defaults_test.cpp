/// Defaults that follow the scale of a scene.
#include <algorithm>
#include <cmath>

#include "core/geometry/mesh.h"
#include "core/geometry/shape.h"
#include "core/scene/spec/ice_presets.h"
#include "tests/core/scene/scene_files.h"

namespace nilas::scene {
namespace scale_defaults_test {

using testing::in_scene;
using testing::SceneFolder;

std::string towed(const std::string& length, const std::string& ice) {
  return in_scene(
      "<water/><hydro><buoyancy/></hydro><vessel position='0 0'><hull length='" + length +
      "'/><mass draught='0.1'/><carriage speed='1.543'><force_balance kind='six-cells'/></carriage></vessel>" + ice);
}

const char* const k_field = "<ice><field region='0 0 1 1'/></ice>";

bool notes_mention(const Scene& scene, const std::string& words) {
  return std::any_of(scene.derived.begin(), scene.derived.end(),
                     [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

TEST(ScaleDefaults, OfAModelAreTheOldOnes) {
  const SceneFolder folder;
  const Scene scene = folder.read(towed("6", "<ice thickness='0.04'><field region='0 0 1 1'/></ice><fracture/>"));
  EXPECT_EQ(scene.time.step, 0.01);
  EXPECT_EQ(scene.vessel->carriage->balance.stiffness, 1e7);
  EXPECT_EQ(scene.vessel->carriage->balance.damping, 1e4);
  EXPECT_EQ(scene.ice->youngs_modulus, 6e7);
  EXPECT_EQ(std::get<LognormalSizeScene>(*scene.ice->fields[0].size()).mean, 0.8);
  EXPECT_EQ(scene.fracture->flexural_strength, 4e4);
  EXPECT_EQ(scene.fracture->compressive_strength, 1e5);
  EXPECT_EQ(scene.fracture->fracture_toughness, 3e3);
  EXPECT_EQ(scene.fracture->min_area, 2e-4);
}

TEST(ScaleDefaults, FollowFroudesLawWithTheHull) {
  const SceneFolder folder;
  const Scene scene = folder.read(towed("100", k_field));
  const CarriageScene& carriage = *scene.vessel->carriage;
  EXPECT_EQ(scene.time.step, 0.05);
  EXPECT_NEAR(carriage.balance.stiffness / (1e7 * std::pow(100.0 / 6, 2)), 1, 5e-3) << "three digits";
  EXPECT_NEAR(carriage.balance.damping / (1e4 * std::pow(100.0 / 6, 2.5)), 1, 5e-3);
  EXPECT_TRUE(notes_mention(scene, "<time step>: 0.05 s is taken"));
  EXPECT_TRUE(notes_mention(scene, "<force_balance stiffness>: 2.78e+09 N/m is taken"));
}

TEST(ScaleDefaults, TheLengthOfAHullFileCounts) {
  const SceneFolder folder;
  geometry::TriangleMesh box = geometry::box_shape(Vec3(60, 10, 8)).surface;
  geometry::write_stl(box, folder / "barge.stl");
  const Scene scene =
      folder.read(in_scene("<vessel hull='barge.stl' position='0 0 0'><mass value='1'/><carriage speed='1'>"
                           "<force_balance kind='six-cells'/></carriage></vessel>"));
  EXPECT_EQ(scene.vessel->carriage->balance.stiffness, 1e9);
  EXPECT_EQ(scene.time.step, 0.05) << "0.0316 s lies nearer to it than to 0.02, by ratio";
}

TEST(ScaleDefaults, IceIsChosenByThicknessThenHullThenField) {
  const SceneFolder folder;
  const auto strength = [&](const std::string& text) { return folder.read(text).fracture->flexural_strength; };
  const std::string fracture = "<fracture/>";
  EXPECT_EQ(strength(towed("6", "<ice thickness='1'><field region='0 0 1 1'/></ice>" + fracture)), 5e5);
  EXPECT_EQ(strength(towed("6", "<ice><field region='0 0 1 1' thickness='0.5'/></ice>" + fracture)), 5e5);
  EXPECT_EQ(strength(towed("100", "<ice thickness='0.04'><field region='0 0 1 1'/></ice>" + fracture)), 4e4);
  EXPECT_EQ(strength(towed("100", k_field + fracture)), 5e5);
  EXPECT_EQ(folder.read(towed("100", k_field)).ice->thickness, 1);
  EXPECT_EQ(strength(in_scene("<ice><field region='0 -50 200 50'/></ice>" + fracture)), 5e5);
  EXPECT_EQ(strength(in_scene(k_field + fracture)), 4e4);
}

TEST(ScaleDefaults, APresetWinsAndWhatIsGivenWinsOverIt) {
  const SceneFolder folder;
  const Scene scene = folder.read(
      in_scene("<ice preset='full-scale sea ice' youngs_modulus='2e9'><field region='0 0 9 9' breakable='true'/></ice>"
               "<fracture compressive_strength='3e6'><crushing model='pressure-area'/></fracture>"));
  EXPECT_EQ(scene.ice->youngs_modulus, 2e9);
  EXPECT_EQ(scene.ice->thickness, 1);
  EXPECT_EQ(scene.fracture->compressive_strength, 3e6);
  EXPECT_EQ(scene.fracture->flexural_strength, 5e5);
  EXPECT_EQ(scene.fracture->crushing->coefficient, 7.4e6);
  EXPECT_TRUE(notes_mention(scene, "<ice preset>: 'full-scale sea ice' is taken, as asked: thickness 1 m"));
  const auto faults = folder.faults(in_scene("<ice preset='full scale'><field region='0 0 9 9'/></ice>"));
  testing::expect_fault(faults, 2, "<ice preset>", {"found 'full scale'", "model, full-scale sea ice"});
}

TEST(ScaleDefaults, TheToleranceFollowsTheSpeedOfWhatHappens) {
  const SceneFolder folder;
  EXPECT_EQ(folder.read(towed("100", k_field)).contact.tolerance, 1e-3) << "1.543 m/s";
  EXPECT_EQ(folder.read(in_scene("<ice><field region='0 0 1 1' velocity='0.3 0 0'/></ice>")).contact.tolerance, 1e-4);
  EXPECT_EQ(folder.read(in_scene(k_field)).contact.tolerance, 1e-6) << "nothing moves";
  EXPECT_EQ(folder.read(towed("100", "")).contact.tolerance, 1e-6) << "no ice";
}

TEST(ScaleDefaults, TheSceneAsRunNamesThemAllAndReadsAlike) {
  const SceneFolder folder;
  const Scene scene = folder.read(towed("100", std::string(k_field) + "<fracture/>"));
  folder.write("again.xml", scene.as_run);
  const Scene again = read_scene(folder / "again.xml");
  EXPECT_EQ(again.as_run, scene.as_run);
  EXPECT_EQ(again.fingerprint, scene.fingerprint);
  EXPECT_TRUE(again.derived.empty()) << "given by then";
}

TEST(IcePresets, KeepToWhatIceIs) {
  for (const IcePreset& p : ice_presets()) {
    EXPECT_LT(p.density, 1000) << p.name;
    EXPECT_GT(p.youngs_modulus, 1000 * p.flexural_strength) << p.name;
    EXPECT_GE(p.compressive_strength, p.flexural_strength) << p.name;
    EXPECT_LT(p.floe_min, p.floe_mean) << p.name;
    EXPECT_LT(p.floe_mean, p.floe_max) << p.name;
  }
}

}  // namespace scale_defaults_test
}  // namespace nilas::scene
