/// Tests of ice that breaks under repeated loads below its strength.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/core/sim/breaking_rig.h"

namespace damage_test {

using namespace nilas;
using namespace nilas::sim;
using namespace nilas::test;

constexpr double k_period = 0.5;

/// The bow comes against the sheet's edge and leaves, a number of times, always as far as this [m].
std::string bow_that_comes_back(double depth, int times) {
  std::string track = "t_s,x_m,y_m,yaw_deg\n";
  for (int k = 0; k < times; ++k)
    track += text(k * k_period) + ",-0.02,0,0\n" + text((k + 0.5) * k_period) + "," + text(depth) + ",0,0\n";
  return track + text(times * k_period) + ",-0.02,0,0\n";
}

const std::string k_sheet_and_bow =
    "<vessel hull='bow.stl' position='-0.02 0 0'><mass value='1000'/><carriage><path file='track.csv'/></carriage>"
    "</vessel><ice thickness='0.05' density='900' youngs_modulus='1e8'><floe breakable='true' fixed='true' "
    "outline='0 -5 9 -5 9 5 0 5'/></ice>";

/// How many loads the sheet bears, of ten; the ratio of the break.
std::pair<int, double> loads_borne(double depth, const std::string& damage) {
  ScratchFolder folder;
  folder.write("track.csv", bow_that_comes_back(depth, 10));
  std::string content = k_sheet_and_bow;
  content.replace(content.find("track.csv"), 9, (folder / "track.csv").string());
  BreakingRig rig(content + breaking_ice("<bending/>" + damage), 0.01);
  for (int k = 0; k < static_cast<int>(10 * k_period / 0.01); ++k) {
    const StepRecord record = rig.simulation.step();
    if (!record.broken.empty()) return {static_cast<int>(record.t / k_period), record.broken[0].ratio};
  }
  return {10, 0};
}

/// The depth at which the first load breaks the sheet, halved into: a little less is a share just below 1.
double depth_that_breaks() {
  double bears = 0, breaks = 0.5;
  EXPECT_EQ(loads_borne(breaks, "").first, 0);
  for (int k = 0; k < 12; ++k) {
    const double depth = 0.5 * (bears + breaks);
    (loads_borne(depth, "").first == 0 ? breaks : bears) = depth;
  }
  return bears;
}

TEST(Damage, RepeatedLoadsBreakWhatOneDoesNot) {
  const double depth = 0.99 * depth_that_breaks();
  EXPECT_EQ(loads_borne(depth, "").first, 10) << "without damage";
  const auto [soon, ratio] = loads_borne(depth, "<damage exponent='4'/>");
  EXPECT_EQ(soon, 1) << "S^4 is left out of what the second load finds";
  EXPECT_GE(ratio, 1);
  EXPECT_EQ(loads_borne(depth, "<damage endurance='1'/>").first, 10) << "no load is that large";
  int before = 0;
  for (const char* exponent : {"5", "24", "28"}) {
    const int borne = loads_borne(0.96 * depth, std::string("<damage exponent='") + exponent + "'/>").first;
    EXPECT_GE(borne, before);
    EXPECT_GE(borne, 1);
    before = borne;
  }
  EXPECT_GT(before, 1);
  EXPECT_LT(before, 10);
}

}  // namespace damage_test
