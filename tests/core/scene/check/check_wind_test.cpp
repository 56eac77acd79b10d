/// What <wind_area> and <propeller_wash> need from the rest of the scene.
#include <gtest/gtest.h>

#include "tests/core/scene/complete_scene.h"

namespace nilas::scene {
namespace check_wind_test {

using testing::expect_fault;
using testing::in_scene;
using testing::SceneFolder;

class CheckWind : public ::testing::Test {
 protected:
  void expect(const std::string& content, const std::string& where, const std::string& word) const {
    SCOPED_TRACE(content);
    expect_fault(folder_.faults(in_scene(content)), 2, where, {word});
  }

  SceneFolder folder_;
  std::string vessel_ = "<vessel><hull/><mass value='1'/>";
};

TEST_F(CheckWind, ModelNeedsItsData) {
  expect(vessel_ + "<wind_area frontal='1' lateral='1'/></vessel>", "<vessel><wind_area>", "ship_type=\"...\"");
  expect(vessel_ + "<wind_area model='coefficients' frontal='1' lateral='1'/></vessel>", "<vessel><wind_area>",
         "file=\"...\"");
  expect(vessel_ + "<wind_area ship_type='ferri' frontal='1' lateral='1'/></vessel>", "<vessel><wind_area ship_type>",
         "ferry");
  expect(vessel_ + "<wind_area ship_type='ferry' frontal='0' lateral='1'/></vessel>", "<vessel><wind_area frontal>",
         "> 0");
}

TEST_F(CheckWind, WindNeedsItsSpeed) {
  expect("<wind direction_deg='20'/>", "<wind speed>", "missing");
  expect("<wind speed='-1'/>", "<wind speed>", ">= 0");
}

TEST_F(CheckWind, JetNeedsAVesselAThrustAndADirection) {
  const auto wash = [](const std::string& jets) {
    return "<water/><hydro><drag/><propeller_wash>" + jets + "</propeller_wash></hydro>";
  };
  const auto jet = [&](const std::string& attributes) {
    return wash("<jet diameter='1' position='0 0 0' " + attributes + "/>");
  };
  const std::string ship = vessel_ + "</vessel>", where = "<hydro><propeller_wash>";
  expect(jet("thrust='1'"), where, "no vessel");
  expect(wash("") + ship, where, "no jet");
  expect(jet("") + ship, where + "<jet>", "neither of thruster and thrust");
  expect(jet("thrust='1' thruster='a'") + ship, where + "<jet>", "both of thruster and thrust");
  expect(jet("thrust='1' direction='0 0 0'") + ship, "<hydro><propeller_wash><jet direction>", "found 0 0 0");
  expect(jet("thrust='1'") + ship + "<contact integrator='reference'/>", where, "integrator 'reference'");
  EXPECT_TRUE(folder_.faults(in_scene(jet("thrust='1'") + ship)).empty());
}

TEST_F(CheckWind, MissingFilesAreNamed) {
  expect("<water><current profile='none.csv'/></water>", "<water><current profile>", "none.csv");
}

}  // namespace check_wind_test
}  // namespace nilas::scene
