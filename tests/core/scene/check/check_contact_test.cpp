/// Contact settings that exclude each other are faults of the scene, all reported at once.
#include <gtest/gtest.h>

#include "tests/core/scene/scene_files.h"

namespace nilas::scene {
namespace check_contact_test {

using testing::expect_fault;
using testing::in_scene;
using testing::SceneFolder;
using testing::text_of;

TEST(CheckContact, ASolverThatDoesNotTakeTheLawIsRefused) {
  const SceneFolder folder;
  expect_fault(folder.faults(in_scene("<contact law='pyramid' solver='admm'/>")), 2, "<contact solver>",
               {"does not take the law 'pyramid'", "it takes: coulomb, ccp, frictionless"});
  EXPECT_TRUE(folder.faults(in_scene("<contact law='pyramid-8' solver='nsgs'/>")).empty());
}

TEST(CheckContact, RollingFrictionNeedsASolverAndALawThatTakeIt) {
  const SceneFolder folder;
  const std::string pair = "<friction between='* *' kinetic='0.1' rolling='0.01'/></contact>";
  expect_fault(folder.faults(in_scene("<contact solver='newton'>" + pair)), 2, "<contact><friction rolling>",
               {"'newton' does not take rolling and spinning friction", "nsgs, auto"});
  expect_fault(folder.faults(in_scene("<contact law='ccp'>" + pair)), 2, "<contact><friction rolling>",
               {"not with 'ccp'"});
  EXPECT_TRUE(folder.faults(in_scene("<contact>" + pair)).empty());
}

TEST(CheckContact, SpinningFrictionHasNoPlaceInStoredProblems) {
  const SceneFolder folder;
  const std::string contact = "<contact><friction between='* *' kinetic='0.1' spinning='0.01'/></contact>";
  expect_fault(folder.faults(in_scene(contact + "<output problems='every'/>")), 2, "<output problems>",
               {"FCLIB", "allowed: never"});
  EXPECT_TRUE(folder.faults(in_scene(contact + "<output problems='never'/>")).empty());
}

TEST(CheckContact, TheReferenceKnowsNoElasticContacts) {
  const SceneFolder folder;
  const std::string pair = "<friction between='* *' kinetic='0.1' elastic='true' stiffness='1e5'/></contact>";
  expect_fault(folder.faults(in_scene("<contact integrator='reference'>" + pair)), 2, "<contact><friction elastic>",
               {"integrator 'reference' does not take elastic contacts", "allowed: false"});
  EXPECT_TRUE(folder.faults(in_scene("<contact>" + pair)).empty());
}

TEST(CheckContact, StepsOfMoreauAreNotCut) {
  const SceneFolder folder;
  expect_fault(folder.faults(in_scene("<contact integrator='moreau' substeps='4'/>")), 2, "<contact substeps>",
               {"semi-implicit-euler"});
  EXPECT_TRUE(folder.faults(in_scene("<contact integrator='moreau' substeps='4' detection='discrete'/>")).empty());
}

TEST(CheckContact, AllFaultsAreToldAtOnce) {
  const SceneFolder folder;
  const auto faults =
      folder.faults(in_scene("<gravity value='1 0 0'/><hydro><buoyancy/></hydro>\n"
                             "<contact integrator='reference' law='pyramid' solver='admm' gyroscopic='false'>\n"
                             "<friction between='* *' kinetic='0.1' rolling='0.01'/></contact>\n"
                             "<fracture><crushing/></fracture>\n<body name='log' shape='cylinder' mass='1'/>\n"
                             "<output contacts='all' checkpoint_every='1'/>"));
  std::vector<std::string> places;
  for (const Fault& fault : faults) places.push_back(std::to_string(fault.line) + " " + fault.where);
  const std::vector<std::string> expected{"2 <gravity value>",
                                          "3 <contact law>",
                                          "3 <contact solver>",
                                          "3 <contact gyroscopic>",
                                          "4 <contact><friction rolling>",
                                          "4 <contact><friction rolling>",
                                          "5 <fracture>",
                                          "6 <body shape>",
                                          "7 <output contacts>",
                                          "7 <output checkpoint_every>"};
  EXPECT_EQ(places, expected) << text_of(faults);
}

}  // namespace check_contact_test
}  // namespace nilas::scene
