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

/// A report in which the reference differs by 0.5 N from the scene's own setting, and the second setting too. Both
/// differences are significant. The reference changes by `moves` [N] with its step.
SceneReport differing_report(double moves) {
  SceneReport report = timed_report(0.25);
  Findings& found = report.found;
  found.measure = {"load", "N", 100};
  found.shared = {0, 1};
  found.check.moves = moves;
  const PairedDifference half{{0, 1}, {0.5, 0.5}, {0.1, 0.1}, 0.5, 0.1, 2, Certainty::everywhere};
  found.merits[0].from_reference = found.merits[1].from_own = half;
  for (const int realisation : found.shared) {
    RunRow reference;
    reference.run.kind = RunKind::reference;
    reference.run.realisation = realisation;
    reference.judges = true;
    reference.own_difference = -0.5;
    found.rows.push_back(reference);
  }
  return report;
}

/// The marks of the means under this title of the picture of differences; empty if there are none.
std::string means_titled(const std::string& title, const SceneReport& report) {
  for (const Picture& picture : pictures_of(report))
    if (picture.name == "differences")
      for (const auto& layer : picture.data.at("layers"))
        if (layer.at("title").get<std::string>() == title) return layer.at("rows").get<std::string>();
  return "";
}

TEST(Pictures, DoNotCallTheReferenceDifferentBelowItsOwnChange) {
  const std::string reference = "-0.5 0 0\n", setting = "0.5 1 0\n", below = "less than the reference's own change";
  EXPECT_EQ(means_titled(below, differing_report(1)), reference);
  EXPECT_EQ(means_titled("significant", differing_report(1)), setting) << "the reference has no part in it";
  EXPECT_EQ(means_titled(below, differing_report(0.2)), "");
  EXPECT_EQ(means_titled("significant", differing_report(0.2)), reference + setting);
}

}  // namespace pictures_test
