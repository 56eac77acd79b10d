/// The scene as run is complete, and reads back as itself.
#include <gtest/gtest.h>

#include "core/scene/read/input_files.h"
#include "tests/core/scene/complete_scene.h"
#include "tests/support/mentions.h"

namespace nilas::scene {
namespace as_run_test {

using testing::expect_fault;
using testing::in_scene;
using testing::SceneFolder;

/// Copies the inputs to the paths that they have in a run folder.
void copy_inputs(const Scene& scene, const SceneFolder& folder) {
  for (const auto& input : scene.inputs) {
    const auto copy = folder.path() / input.copy;
    std::filesystem::create_directories(copy.parent_path());
    std::filesystem::copy_file(input.source, copy);
  }
}

void expect_round_trip(const SceneFolder& folder, const Scene& scene) {
  const SceneFolder elsewhere;
  copy_inputs(scene, elsewhere);
  const Scene again = elsewhere.read(scene.as_run);
  EXPECT_EQ(again.as_run, scene.as_run);
  EXPECT_EQ(again.fingerprint, scene.fingerprint);
  EXPECT_EQ(again.name, scene.name);
  EXPECT_TRUE(std::filesystem::exists(folder.path()));
}

TEST(AsRun, TheFingerprintIsOfAllButTheEndAndTheCheckpoints) {
  const SceneFolder folder;
  const auto fingerprint = [&](const std::string& content) { return folder.read(in_scene(content)).fingerprint; };
  const std::string plain = fingerprint("<time end='3'/><output/>");
  EXPECT_EQ(plain.size(), 64u);
  EXPECT_EQ(fingerprint("<time end='5.0' /><output checkpoint_every='2'/>"), plain);
  EXPECT_NE(fingerprint("<time end='3' step='0.02'/><output/>"), plain);
  EXPECT_NE(fingerprint("<time end='3'/><output/><seed value='2'/>"), plain);
  EXPECT_NE(fingerprint("<time end='3'/><output trajectory_every='1'/>"), plain);
}

TEST(AsRun, TheCompleteSceneReadsBackFromAnotherFolder) {
  const SceneFolder folder;
  testing::write_inputs(folder);
  const Scene scene = folder.read(testing::k_complete_scene);
  expect_round_trip(folder, scene);
  const SceneFolder elsewhere;
  copy_inputs(scene, elsewhere);
  const Scene again = elsewhere.read(scene.as_run);
  EXPECT_EQ(again.vessel->hull, elsewhere.path() / "inputs/icebreaker");
  EXPECT_EQ(again.vessel->position_has_z, scene.vessel->position_has_z);
  EXPECT_EQ(again.contact.friction[1].kinetic, scene.contact.friction[1].kinetic);
  EXPECT_EQ(std::get<FileFieldScene>(again.ice->fields[2].form).file, elsewhere.path() / "inputs/floes.geojson");
  EXPECT_EQ(again.bodies[3].fixed, true);
}

TEST(AsRun, DefaultsAreWrittenOutAsTheyWereUsed) {
  const SceneFolder folder;
  const Scene scene = folder.read(in_scene("<ice><field region='0 0 01.50 1e0'/></ice><body shape='sphere'/>"));
  expect_round_trip(folder, scene);
  for (const char* part :
       {"<time step=\"0.01\" start=\"0\" end=\"10\"/>", "<gravity value=\"0 0 -9.81\"/>",
        "<seed value=\"1\" twin=\"0\"/>", "solver=\"auto\"", "integrator=\"moreau\"", "detection=\"continuous\"",
        "stabilisation=\"projection\"", "contacts=\"hull\"", "region=\"0 0 1.5 1\"", "<size distribution=\"lognormal\"",
        "<shape kind=\"polygon\"", "name=\"body 1\" shape=\"sphere\" radius=\"0.5\"", "density=\"1000\"",
        "tolerance=\"1e-06\""})
    EXPECT_TRUE(test::mentions(scene.as_run, part)) << part << "\n" << scene.as_run;
  for (const char* part : {"water", "vessel", "height=", "rows="})
    EXPECT_FALSE(test::mentions(scene.as_run, part)) << part << "\n" << scene.as_run;
  const SceneFolder elsewhere;
  EXPECT_TRUE(elsewhere.read(scene.as_run).notes.empty()) << "nothing is left to defaults";
}

TEST(AsRun, OverridesPresetAndGeneratedHull) {
  const SceneFolder folder;
  const Scene scene =
      folder.read(in_scene("<contact preset='metrikin-2014'/><vessel><hull/><mass value='1'/><carriage/></vessel>"),
                  {{"vessel/hull/@beam", "1.5"}, {"contact/@max_iterations", "20"}});
  expect_round_trip(folder, scene);
  EXPECT_TRUE(test::mentions(scene.as_run, "beam=\"1.5\"")) << scene.as_run;
  EXPECT_TRUE(test::mentions(scene.as_run, "max_iterations=\"20\"")) << scene.as_run;
  EXPECT_TRUE(test::mentions(scene.as_run, "<force_balance kind=\"rigid\"/>")) << scene.as_run;
}

TEST(AsRun, NamesWithMarkupCharactersSurvive) {
  const SceneFolder folder;
  const Scene scene =
      folder.read(in_scene("<body name='a &amp; b'/><output folder='runs/&quot;x&apos; &lt;&amp;&gt;'/>"));
  EXPECT_EQ(scene.bodies[0].name, "a & b");
  EXPECT_EQ(scene.output.folder, "runs/\"x' <&>");
  expect_round_trip(folder, scene);
}

TEST(AsRun, InputFilesAreNamedWithTheirHashes) {
  const SceneFolder folder;
  testing::write_inputs(folder);
  const std::string text = folder.read(testing::k_complete_scene).as_run;
  std::size_t inputs = 0;
  for (auto at = text.find("<input "); at != std::string::npos; at = text.find("<input ", at + 1)) ++inputs;
  EXPECT_EQ(inputs, 13u) << "two of the database, four of the hull folder, cells, field, library, mesh, two of the "
                            "current and one of the wind:\n"
                         << text;
  EXPECT_FALSE(test::mentions(text, "notes.txt"));
  EXPECT_TRUE(test::mentions(text, "<input file=\"inputs/icebreaker/part-02.stl\" sha256=\"" +
                                       file_sha256(folder.path() / "hulls/icebreaker/part-02.stl") + "\"/>"));
}

TEST(AsRun, AChangedInputFileIsRefusedWithBothHashes) {
  const SceneFolder folder;
  testing::write_inputs(folder);
  const Scene scene = folder.read(testing::k_complete_scene);
  const std::string text = scene.as_run;
  copy_inputs(scene, folder);
  const std::string before = file_sha256(folder.path() / "inputs/quay.stl");
  folder.write("inputs/quay.stl", "solid other");
  const std::string after = file_sha256(folder.path() / "inputs/quay.stl");
  const auto faults = folder.faults(text);
  ASSERT_EQ(faults.size(), 1u) << testing::text_of(faults);
  EXPECT_EQ(faults[0].where, "<input sha256>");
  EXPECT_TRUE(test::mentions(faults[0].message, before) && test::mentions(faults[0].message, after))
      << faults[0].message;
  std::filesystem::remove(folder.path() / "inputs/quay.stl");
  EXPECT_EQ(folder.faults(text).size(), 2u) << "named as the mesh and as an input";
}

/// Files of one name from several folders, and names that other systems do not take.
TEST(AsRun, CopiesHaveNamesOfTheirOwnThatStay) {
  const SceneFolder folder;
  for (const char* file : {"a/quay.stl", "b/Quay.stl", "c/quay-2.stl", "d/no: name?.stl", "e/nilas-inputs.sha256"})
    folder.write(file, file);
  folder.write("hull/fluid.stl", "fluid");
  const Scene scene =
      folder.read(in_scene("<body shape='mesh' mesh='a/quay.stl'/><body shape='mesh' mesh='b/Quay.stl'/>"
                           "<body shape='mesh' mesh='c/quay-2.stl'/><body shape='mesh' mesh='d/no: name?.stl'/>"
                           "<body shape='mesh' mesh='./a/quay.stl'/><body shape='mesh' mesh='hull/'/>"
                           "<ice><field kind='file' file='e/nilas-inputs.sha256'/></ice>"));
  std::vector<std::string> copies;
  for (const auto& input : scene.inputs) copies.push_back(input.copy);
  EXPECT_EQ(copies, (std::vector<std::string>{"inputs/quay.stl", "inputs/Quay-2.stl", "inputs/quay-2-2.stl",
                                              "inputs/no_ name_.stl", "inputs/hull/fluid.stl",
                                              "inputs/nilas-inputs-2.sha256"}));
  expect_round_trip(folder, scene);
}

/// FIPS 180-2, appendix B.1, and the digest of nothing.
TEST(Sha256, KnownDigests) {
  const SceneFolder folder;
  EXPECT_EQ(file_sha256(folder.write("abc", "abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(file_sha256(folder.write("none", "")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_THROW(file_sha256(folder.path() / "missing"), FileError);
}

TEST(Sha256, FilesLongerThanTheBuffer) {
  const SceneFolder folder;
  EXPECT_EQ(file_sha256(folder.write("a", std::string(1000000, 'a'))),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace as_run_test
}  // namespace nilas::scene
