/// A whole run under control from outside, by the Python program of docs/howto/control-from-outside.md.
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <thread>

#include "core/base/error.h"
#include "tests/core/sim/scene_rig.h"

namespace remote_control_run_test {

using namespace nilas;
using namespace nilas::test;

std::string floating_box(const std::string& socket, const std::string& more) {
  return steps_of(0.01) + "<water density='1000'/><hydro><buoyancy/><drag/></hydro>" +
         box_vessel("position='0 0 0'", "<remote_control socket='" + socket + "' " + more + "/>", 500);
}

/// The law has the stiffness 1500 (2 pi / 6)^2 = 1645 N/m and the damping 1500 * 1.4 * 2 pi / 6 = 2199 N s/m on 500 kg.
/// Its slower pole is -0.95 1/s, and that in yaw, on 208 kg m^2, is -0.77 1/s. So less than a millionth of the error is
/// left after 18 s.
TEST(RemoteControlRun, ReachesPlaceAndHeadingUnderThePythonController) {
  const ScratchFolder folder;
  const std::string socket = (folder / "s").string();
  std::optional<SceneRig> rig(std::in_place, floating_box(socket, "force='true'"));
  ASSERT_EQ(rig->simulation.info().vessel_loads, std::vector<std::string>{"remote_control"});
  int ended = -1;
  std::thread controller([&] {
    const std::string program = "python3 '" NILAS_SOURCE_DIR "/docs/howto/controller.py' '";
    ended = std::system((program + socket + "' 0.6 -0.4 30").c_str());
  });
  sim::StepRecord last;
  std::string failure;
  try {
    for (int k = 0; k < 1800; ++k) last = rig->simulation.step();
  } catch (const std::exception& error) {
    failure = error.what();
  }
  EXPECT_EQ(failure, "");
  const Vec3 place = rig->bodies().p_GB[0];
  const Mat3 R = rig->bodies().R_GB[0];
  EXPECT_LE(last.momentum_imbalance, 1e-11 * last.momentum_scale);
  EXPECT_LE(std::abs(last.ledger.imbalance), 1e-6);
  rig.reset();  // closes the socket, which ends the controller
  controller.join();
  EXPECT_EQ(ended, 0);
  EXPECT_NEAR(place.x(), 0.6, 1e-5);
  EXPECT_NEAR(place.y(), -0.4, 1e-5);
  EXPECT_NEAR(std::atan2(R(1, 0), R(0, 0)) / k_deg, 30, 1e-3);
}

TEST(RemoteControlRun, RefusesScenesWithoutCommandsAndPerturbedRuns) {
  const auto refusal = [](const std::string& inside) -> std::string {
    try {
      const SceneRig rig(inside);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal(floating_box("s", "")).find("nothing to command"), std::string::npos);
  EXPECT_NE(refusal(floating_box("s", "force='true'") + "<seed twin='1'/>").find("perturbed run"), std::string::npos);
  EXPECT_EQ(refusal(floating_box("s", "force='true'")), "") << "building a scene waits for nobody";
  EXPECT_NE(refusal(floating_box(std::string(200, 's'), "force='true'")).find("1 to 107"), std::string::npos);
  const std::string held = "<remote_control socket='s' force='true'/><fixed/>";
  EXPECT_NE(refusal(steps_of(0.01) + box_vessel("position='0 0 0'", held)).find("free vessel"), std::string::npos);
  const std::string exact = "<contact integrator='reference'/>" + floating_box("s", "force='true'");
  EXPECT_NE(refusal(exact).find("does not take <remote_control>"), std::string::npos);
}

}  // namespace remote_control_run_test
