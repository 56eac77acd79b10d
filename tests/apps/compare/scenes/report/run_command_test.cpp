/// The recommendation as a command.
#include "apps/compare/scenes/report/run_command.h"

#include <gtest/gtest.h>

namespace run_command_test {

using namespace nilas;
using namespace nilas::compare;

SceneReport report_of(const std::string& scene) {
  SceneReport report;
  report.study.scene = scene;
  report.study.plan.settings.assign(2, {"auto", "coulomb", "moreau", "projection", 0.01, 1e-6});
  report.study.plan.settings[1].solver = "newton";
  report.study.plan.settings[1].step = 0.02;
  return report;
}

TEST(RunCommand, SetsWhatTheRecommendedSettingChanges) {
  SceneReport report = report_of("/ice/ship.xml");
  EXPECT_EQ(run_command(report), "") << "nothing is recommended";
  report.found.choice.chosen = 0;
  EXPECT_EQ(run_command(report), "nilas run /ice/ship.xml");
  report.found.choice.chosen = 1;
  EXPECT_EQ(run_command(report), "nilas run /ice/ship.xml --set contact/@solver=newton --set time/@step=0.02");
  report.study.ablation = true;
  EXPECT_EQ(run_command(report), "");
}

TEST(RunCommand, KeepsTheUsersChangesAndQuotesThem) {
  SceneReport report = report_of("/my ice/it's.xml");
  report.found.choice.chosen = 0;
  report.study.overrides = {{"body[@name='block']/@velocity", "1.7 1 0"}, {"time/@end", "3"}, {"seed/@value", "4"}};
  EXPECT_EQ(run_command(report),
            "nilas run '/my ice/it'\\''s.xml' --set "
            "'body[@name='\\''block'\\'']/@velocity=1.7 1 0' --set seed/@value=4");
}

}  // namespace run_command_test
