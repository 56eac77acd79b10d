/// Reading and checks of <added_mass>, and of <restoring> and <remote_control> beside other elements.
#include <gtest/gtest.h>

#include "tests/core/scene/scene_files.h"

namespace nilas::scene {
namespace check_added_mass_test {

using testing::expect_fault;
using testing::in_scene;
using testing::SceneFolder;

const std::string k_vessel = "<vessel><hull/><mass value='1e3'/>";

std::string with(const std::string& added, const std::string& current = "") {
  return in_scene("<water>" + current + "</water><hydro>\n" + added + "</hydro>" + k_vessel + "</vessel>");
}

TEST(AddedMass, IsRead) {
  const SceneFolder folder;
  const Scene scene =
      folder.read(with("<added_mass floes='disc' vessel='matrix' matrix='1 2 3 4 5 6' at='0.5 0 -0.1'/>"));
  ASSERT_TRUE(scene.hydro && scene.hydro->added_mass);
  const AddedMassScene& added = *scene.hydro->added_mass;
  EXPECT_EQ(added.floes, FloeAddedMass::disc);
  EXPECT_EQ(added.vessel, VesselAddedMass::matrix);
  EXPECT_EQ(added.matrix, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(added.at, Vec3(0.5, 0, -0.1));
  EXPECT_EQ(*folder.read(with("<added_mass/>")).hydro->added_mass, AddedMassScene{});
}

TEST(AddedMass, NeedsAMatrixThatCanBeOne) {
  const SceneFolder folder;
  const std::string at = "<hydro><added_mass matrix>";
  expect_fault(folder.faults(with("<added_mass vessel='matrix'/>")), 3, "<hydro><added_mass vessel>", {"6 or 36"});
  expect_fault(folder.faults(with("<added_mass vessel='matrix' matrix='1 2 3 4 5 6 7'/>")), 3, at, {"7 numbers"});
  expect_fault(folder.faults(with("<added_mass vessel='matrix' matrix='1 2 3 -4 5 6'/>")), 3, at, {"negative"});
  std::string skew;
  for (int k = 0; k < 36; ++k) skew += k == 1 ? "1 " : (k % 7 == 0 ? "2 " : "0 ");
  expect_fault(folder.faults(with("<added_mass vessel='matrix' matrix='" + skew + "'/>")), 3, at, {"not symmetric"});
}

TEST(AddedMass, NeedsADatabaseAndOneVelocityOfTheWater) {
  const SceneFolder folder;
  folder.write("deep.csv", "z_m,u_m_s,v_m_s\n0,1,0\n");
  expect_fault(folder.faults(with("<added_mass vessel='database'/>")), 3, "<hydro><added_mass vessel>",
               {"no database"});
  expect_fault(folder.faults(with("<drag/><added_mass/>", "<current profile='deep.csv'/>")), 3, "<hydro><added_mass>",
               {"profile"});
  expect_fault(folder.faults(in_scene("<water/><hydro>\n<added_mass vessel='matrix' matrix='1 1 1 1 1 1'/></hydro>")),
               3, "<hydro><added_mass vessel>", {"no vessel"});
}

/// One controller commands the vessel.
TEST(RemoteControl, DoesNotShareCommands) {
  const SceneFolder folder;
  const std::string thrusters =
      "<thrusters><thruster name='bow' kind='tunnel' at='60 0 2' max_thrust='2e5' power='1.5e6'/>"
      "<thruster name='aft' kind='azimuth' at='3 0 2' max_thrust='5e5' power='3e6'/></thrusters>";
  const std::string remote = "\n<remote_control socket='s'/>";
  EXPECT_TRUE(folder.faults(in_scene(k_vessel + thrusters + remote + "</vessel>")).empty());
  expect_fault(folder.faults(in_scene(k_vessel + thrusters + "<control mode='dp'/>" + remote + "</vessel>")), 3,
               "<vessel><remote_control>", {"<control>", "one of them"});
}

TEST(Thrusters, AreNotThePropellerOfTheShip) {
  const SceneFolder folder;
  const std::string thruster =
      "<thrusters>\n<thruster name='propeller' kind='tunnel' at='60 0 2' max_thrust='2e5' power='1.5e6'/></thrusters>";
  expect_fault(folder.faults(in_scene("<water/><hydro><buoyancy/></hydro>" + k_vessel + thruster +
                                      "<manoeuvring preset='kvlcc2'/></vessel>")),
               3, "<vessel><thrusters><thruster name>", {"another name"});
}

}  // namespace check_added_mass_test
}  // namespace nilas::scene
