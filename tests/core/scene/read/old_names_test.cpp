/// Names of choices that have changed are still read, with a warning that names the new one.
#include "core/scene/read/old_names.h"

#include <gtest/gtest.h>

#include "tests/core/scene/scene_files.h"
#include "tests/support/refusal.h"

namespace nilas::scene {
namespace old_names_test {

using testing::in_scene;
using testing::SceneFolder;

const std::string k_rest =
    "<ice><field region='0 0 1 1' breakable='true'/></ice><hydro><buoyancy/></hydro><fracture>%s<bending/></fracture>";

std::string breaking(const std::string& models) {
  std::string text = k_rest;
  return text.replace(text.find("%s"), 2, models);
}

TEST(OldNames, AreReadAsTodaysWithAWarningThatNamesPlaceAndNewName) {
  const SceneFolder folder;
  const Scene scene = folder.read(in_scene(
      "<contact preset='seed-2014'/>" + breaking("<crushing model='seed-limit'/><splitting model='seed-geometric'/>")));
  EXPECT_EQ(scene.contact.preset, ContactPreset::metrikin_2014);
  EXPECT_EQ(scene.contact.max_iterations, 50);
  EXPECT_EQ(scene.fracture->crushing->model, CrushingModel::explicit_area);
  EXPECT_EQ(scene.fracture->splitting->model, SplittingModel::geometric);
  ASSERT_EQ(scene.warnings.size(), 3u);
  EXPECT_EQ(scene.warnings[0].where, "<contact preset>");
  EXPECT_EQ(scene.warnings[1].text().find((folder.path() / "scene.xml").string() + ":2:"), 0u)
      << scene.warnings[1].text();
  EXPECT_NE(scene.warnings[1].text().find(
                "<fracture><crushing model>: 'seed-limit' is now called 'explicit'; use the new name"),
            std::string::npos);
  EXPECT_NE(scene.warnings[2].message.find("'geometric'"), std::string::npos);
}

TEST(OldNames, AreTakenByOverridesToo) {
  const SceneFolder folder;
  const auto file = folder.write("scene.xml", in_scene(breaking("<crushing model='compliant'/>")));
  const Scene scene = read_scene(file, {{"fracture/crushing/@model", " seed-limit "}});
  EXPECT_EQ(scene.fracture->crushing->model, CrushingModel::explicit_area);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0].text().find("--set: <fracture><crushing model>"), 0u) << scene.warnings[0].text();
}

TEST(OldNames, MakeTheSameSceneAsRun) {
  const SceneFolder folder;
  const Scene before = folder.read(in_scene(breaking("<crushing model='seed-limit'/>"))),
              now = folder.read(in_scene(breaking("<crushing model='explicit'/>")));
  EXPECT_TRUE(now.warnings.empty());
  EXPECT_EQ(before.as_run, now.as_run);
  EXPECT_EQ(before.as_run.find("seed-limit"), std::string::npos);
  EXPECT_EQ(before.fingerprint, now.fingerprint);
}

TEST(OldNames, OfOtherAttributesAreNotTaken) {
  const SceneFolder folder;
  EXPECT_EQ(folder.faults(in_scene(breaking("<crushing model='seed-geometric'/>"))).size(), 1u);
}

TEST(OldNames, AShippedSceneThatMovedIsNamed) {
  const SceneFolder folder;
  const auto old_file = folder.path() / "seed-2014.xml";
  EXPECT_EQ(moved_scene(old_file), "");
  const auto now = folder.write("metrikin-2014.xml", "<scene version='1'/>");
  test::expect_refusal<FileError>([&] { read_scene(old_file); }, {"the scene is now " + now.string()});
  folder.write("seed-2014.xml", "<scene version='1' name='mine'/>");
  EXPECT_EQ(read_scene(old_file).name, "mine") << "one's own scene may be called so";
}

}  // namespace old_names_test
}  // namespace nilas::scene
