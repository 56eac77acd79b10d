/// What <radiation> needs beside it.
#include <gtest/gtest.h>

#include "core/choices/radiation_choices.h"
#include "tests/core/scene/scene_files.h"

namespace nilas::scene {
namespace check_radiation_test {

using testing::expect_fault;
using testing::in_scene;
using testing::SceneFolder;

const std::string k_vessel = "<vessel><hull/><mass value='1'/></vessel>", k_database = "<database file='sphere.h5'/>",
                  k_added = "<added_mass vessel='database'/>";

std::vector<Fault> faults_of(const std::string& hydro, const std::string& vessel = k_vessel) {
  const SceneFolder folder;
  folder.write("sphere.h5", "");
  return folder.faults(in_scene("<hydro>" + hydro + "</hydro>" + vessel));
}

TEST(CheckRadiation, ReadsItsValues) {
  const SceneFolder folder;
  folder.write("sphere.h5", "");
  const std::string before = "<hydro>" + k_database + k_added;
  const Scene plain = folder.read(in_scene(before + "<radiation/></hydro>" + k_vessel));
  EXPECT_EQ(plain.hydro->radiation, RadiationScene{});
  const Scene given = folder.read(
      in_scene(before + "<radiation model='convolution' memory='12' highest_frequency='3.5'/></hydro>" + k_vessel));
  EXPECT_EQ(given.hydro->radiation->model, RadiationModel::convolution);
  EXPECT_EQ(given.hydro->radiation->memory, 12);
  EXPECT_EQ(given.hydro->radiation->highest_frequency, 3.5);
  const Scene fitted = folder.read(in_scene(before + "<radiation error='0.05' order='6'/></hydro>" + k_vessel));
  EXPECT_EQ(fitted.hydro->radiation->error, 0.05);
  EXPECT_EQ(fitted.hydro->radiation->order, 6);
}

TEST(CheckRadiation, NeedsADatabaseAndItsAddedMass) {
  EXPECT_TRUE(faults_of(k_database + k_added + "<radiation/>").empty());
  expect_fault(faults_of(k_database + "<radiation/>"), 2, "<hydro><radiation>", {"added mass at infinite frequency"});
  expect_fault(faults_of(k_database + "<added_mass/><radiation/>"), 2, "<hydro><radiation>",
               {"allowed: with <hydro><added_mass vessel=\"database\">"});
  const std::string matrix = "<added_mass vessel='matrix' matrix='1 1 1 1 1 1'/>";
  expect_fault(faults_of(matrix + "<radiation/>"), 2, "<hydro><radiation>", {"the scene names no database"});
  expect_fault(faults_of(k_database + k_added + "<radiation/>", "<vessel><hull/><mass value='1'/><fixed/></vessel>"), 2,
               "<hydro><radiation>", {"does not move"});
}

TEST(CheckRadiation, RefusesTheReferenceIntegrator) {
  const SceneFolder folder;
  folder.write("sphere.h5", "");
  const std::string text = testing::text_of(folder.faults(
      in_scene("<contact integrator='reference'/><hydro>" + k_database + k_added + "<radiation/></hydro>" + k_vessel)));
  EXPECT_NE(text.find("whose memory is a state"), std::string::npos) << text;
}

}  // namespace check_radiation_test
}  // namespace nilas::scene
