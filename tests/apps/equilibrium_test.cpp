/// Tests of the floating position of a vessel that `nilas check` reports.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace equilibrium_test {

using namespace nilas_test;

/// A generated hull of 3 m; `mass` and `rest` fill the vessel.
std::string scene(const std::string& mass, const std::string& rest = "", const std::string& position = "0 0") {
  return R"(<scene version="1" name="afloat"><time step="0.01" end="1"/>
  <water density="1000"/><hydro><buoyancy/></hydro>
  <vessel name="ship" position=")" +
         position + R"("><hull generate="icebreaker" length="3" beam="0.6" depth="0.5"/>)" + mass + rest +
         "</vessel></scene>\n";
}

nlohmann::json equilibrium(const std::string& text) {
  const ScratchFolder folder;
  folder.write("scene.xml", text);
  const auto result = run_nilas("check scene.xml --json", folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return nlohmann::json::parse(result.out).at("equilibrium");
}

TEST(CheckEquilibrium, MassAndPlaceOfItsCentreGiveDraughtTrimAndHeel) {
  const auto middle = equilibrium(scene("<mass value='250' cog='1.5 0 0.2'/>"));
  EXPECT_EQ(middle["held"], "none");
  EXPECT_TRUE(middle["stable"].get<bool>());
  EXPECT_NEAR(middle["displaced_volume_m3"], 0.25, 1e-9);
  EXPECT_NEAR(middle["heel_deg"], 0, 1e-8);
  const auto ahead = equilibrium(scene("<mass value='250' cog='1.6 0.01 0.2'/>"));
  EXPECT_GT(ahead["trim_deg"], middle["trim_deg"].get<double>() + 0.1) << "bow down";
  EXPECT_LT(ahead["heel_deg"], -0.1) << "port down";
  // metacentres belong to the waterplane: 5 cm lower is 5 cm more
  const auto low = equilibrium(scene("<mass value='250' cog='1.5 0 0.15'/>"));
  EXPECT_NEAR(low["gm_transverse_m"].get<double>() - middle["gm_transverse_m"].get<double>(), 0.05, 2e-3);
  EXPECT_GT(low["gm_longitudinal_m"], low["gm_transverse_m"]);
}

TEST(CheckEquilibrium, TopHeavyHeldAndSinkingVesselsAreSaidToBeSo) {
  const auto top_heavy = equilibrium(scene("<mass value='250' cog='1.5 0 0.6'/>"));
  EXPECT_FALSE(top_heavy["stable"].get<bool>());
  EXPECT_LT(top_heavy["gm_transverse_m"], 0);
  EXPECT_EQ(equilibrium(scene("<mass value='250'/>", "<fixed/>"))["held"], "fixed");
  EXPECT_EQ(equilibrium(scene("<mass value='250'/>", "<carriage free='heave'/>"))["held"], "carriage");
  const auto sinking = equilibrium(scene("<mass value='5000'/>", "", "0 0 0"));
  EXPECT_FALSE(sinking["floats"].get<bool>());
  EXPECT_NE(sinking["message"].get<std::string>().find("would sink"), std::string::npos);
  EXPECT_FALSE(sinking.contains("draught_m"));
}

TEST(CheckEquilibrium, TheConsoleShowsItAndADrySceneDoesNot) {
  const ScratchFolder folder;
  folder.write("scene.xml", scene("<mass value='250'/>"));
  const auto wet = run_nilas("check scene.xml", folder.path());
  for (const char* word : {"draught", "trim", "heel", "GM transverse", "displacement"})
    EXPECT_NE(wet.out.find(word), std::string::npos) << word << "\n" << wet.out;
  folder.write("dry.xml", R"(<scene version="1" name="dry"><body shape="box"/></scene>)");
  EXPECT_FALSE(nlohmann::json::parse(run_nilas("check dry.xml --json", folder.path()).out).contains("equilibrium"));
}

}  // namespace equilibrium_test
