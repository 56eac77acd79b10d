/// Natural periods against closed forms of a box-shaped barge.
#include "core/sim/build/natural_periods.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/scene/read/read_scene.h"
#include "core/sim/build/build_world.h"
#include "tests/support/scratch_folder.h"

namespace nilas::sim {
namespace natural_periods_test {

constexpr double k_length = 12, k_beam = 4, k_depth = 2, k_draught = 1, k_water = 1000, k_gravity = 9.81;
constexpr double k_mass = k_water * k_length * k_beam * k_draught;

/// `rest`: the support of the barge.
std::map<std::string, NaturalPeriod> periods(const std::string& rest, const std::string& heading = "0") {
  const test::ScratchFolder folder;
  geometry::TriangleMesh box = geometry::box_shape(Vec3(k_length, k_beam, k_depth)).surface;
  geometry::write_stl(box, folder / "barge.stl");
  const auto file = folder.write("scene.xml", R"(<scene version="1"><time step="0.01" end="1"/><water density="1000"/>
  <hydro><buoyancy/></hydro><vessel hull="barge.stl" position="0 0" heading_deg=")" +
                                                  heading + R"("><mass draught="1"/>)" + rest + "</vessel></scene>");
  const scene::Scene scene = scene::read_scene(file);
  WarningCounts warnings(make_logger("off", ""));
  const WorldParts parts = build_world(scene, 1, warnings);
  std::map<std::string, NaturalPeriod> found;
  for (const NaturalPeriod& p : natural_periods(scene, parts)) found.emplace(p.motion, p);
  return found;
}

double period(double inertia, double stiffness) { return 2 * k_pi * std::sqrt(inertia / stiffness); }

/// Metacentre above the centre of mass, which is the box's centre.
double metacentric(double width) { return width * width / (12 * k_draught) + 0.5 * (k_draught - k_depth); }

TEST(NaturalPeriods, OfAFreeBargeAreThoseOnTheWater) {
  for (const char* heading : {"0", "30", "90"}) {
    const auto found = periods("", heading);
    ASSERT_EQ(found.size(), 3u) << "nothing holds surge, sway and yaw";
    EXPECT_NEAR(found.at("heave").period, period(k_mass, k_water * k_gravity * k_length * k_beam), 1e-6);
    const double rolling = k_mass / 12 * (k_beam * k_beam + k_depth * k_depth);
    const double pitching = k_mass / 12 * (k_length * k_length + k_depth * k_depth);
    EXPECT_NEAR(found.at("roll").period, period(rolling, k_mass * k_gravity * metacentric(k_beam)), 1e-5) << heading;
    EXPECT_NEAR(found.at("pitch").period, period(pitching, k_mass * k_gravity * metacentric(k_length)), 1e-5);
    EXPECT_FALSE(found.at("heave").on_cells);
  }
}

TEST(NaturalPeriods, OnSixCellsTheCellsHoldWhatTheJointDoesNotFree) {
  const auto found = periods(
      "<carriage speed='1' free='heave'><force_balance kind='six-cells' stiffness='1e7' damping='0'/></carriage>");
  EXPECT_NEAR(found.at("surge").period, period(k_mass, 1e7), 1e-6) << "one cell along";
  EXPECT_TRUE(found.at("surge").on_cells);
  EXPECT_NEAR(found.at("sway").period, period(k_mass, 2e7), 1e-6) << "two cells across";
  EXPECT_FALSE(found.at("heave").on_cells);
  EXPECT_NEAR(found.at("heave").period, period(k_mass, k_water * k_gravity * k_length * k_beam), 1e-6);
  const double arm = 0.25 * k_length, turning = k_mass / 12 * (k_length * k_length + k_beam * k_beam);
  EXPECT_NEAR(found.at("yaw").period, period(turning, 2e7 * arm * arm), 1e-6);
}

TEST(NaturalPeriods, OnARigidBalanceOnlyTheFreeAxesHaveOne) {
  EXPECT_TRUE(periods("<carriage speed='1'/>").empty());
  EXPECT_TRUE(periods("<fixed/>").empty());
  const auto found = periods("<carriage speed='1' free='heave pitch'/>");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found.at("heave").period, period(k_mass, k_water * k_gravity * k_length * k_beam), 1e-6);
}

}  // namespace natural_periods_test
}  // namespace nilas::sim
