/// Tests of the data of a comparison's pictures, with hand-made figures.
#include "apps/compare/scenes/report/pictures.h"

#include <gtest/gtest.h>

#include <limits>

namespace pictures_test {

using namespace nilas;
using namespace nilas::compare;

/// Two settings of 1 s/s and 2 s/s, whose times scatter by `spread`; NaN: not measured.
SceneReport timed_report(double spread) {
  SceneReport report;
  report.study.plan.settings.assign(2, {"auto", "coulomb", "moreau", "projection", 0.01, 1e-6});
  report.found.measure = {"distance", "m", 1};
  report.found.time_spread = spread;
  for (std::size_t k = 0; k < 2; ++k) {
    Merit m;
    m.setting = k;
    m.planned = m.done = 1;
    m.time = k == 0 ? 1 : 2;
    m.time_spread = spread * m.time;
    m.error = 0.5;
    m.significant = true;
    report.found.merits.push_back(m);
  }
  return report;
}

Picture front_of(const SceneReport& report) {
  for (const Picture& picture : pictures_of(report))
    if (picture.name == "front") return picture;
  return {};
}

TEST(Pictures, ShowHowFarTimesScatter) {
  const Picture front = front_of(timed_report(0.25));
  EXPECT_EQ(front.data.at("bars"), "1 0.5 0.75 1.25\n2 0.5 1.5 2.5\n");
  EXPECT_LT(front.data.at("x_low").get<double>(), 0.75);
  EXPECT_GT(front.data.at("x_high").get<double>(), 2.5);
  const std::string script = script_of(front);
  EXPECT_NE(script.find("with xerrorbars"), std::string::npos);
  EXPECT_NE(script.find("'scatter of times (25 %)'"), std::string::npos);
  EXPECT_EQ(script.find("not measured"), std::string::npos);
}

TEST(Pictures, SayThatTheScatterOfTimesWasNotMeasured) {
  const Picture front = front_of(timed_report(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(front.data.at("bars"), "");
  const std::string script = script_of(front);
  EXPECT_EQ(script.find("xerrorbars"), std::string::npos);
  EXPECT_NE(script.find("'scatter of times: not measured'"), std::string::npos);
}

TEST(Pictures, EndBarsAboveZeroBecauseTheAxisIsLogarithmic) {
  const Picture front = front_of(timed_report(2));
  EXPECT_EQ(front.data.at("bars"), "1 0.5 0.001 3\n2 0.5 0.002 6\n");
}

}  // namespace pictures_test
