/// parts.csv: columns and rows of parts and rods.
#include "core/output/tables/parts_csv.h"

#include <gtest/gtest.h>

#include "tests/core/output/sample_run.h"
#include "tests/support/csv_table.h"
#include "tests/support/file_text.h"

namespace nilas::output {
namespace parts_csv_test {

TEST(PartsCsv, HasTheTensionOfEachRodBehindTheParts) {
  sim::RunInfo info;
  info.parts = {{"arm", JointKind::weld}};
  info.rods = {"tie", "strut"};
  sim::VesselRecord vessel;
  sim::PartRecord part;
  part.joint = {Vec3(1, 2, 3), Vec3(4, 5, 6)};
  vessel.parts = {part};
  vessel.rods = VecX(2);
  vessel.rods << 120.5, -30;
  const test::ScratchFolder folder;
  PartsCsv csv(folder / "parts.csv", info);
  csv.row(0.5, vessel);
  csv.finish();
  const auto lines = test::lines_of(folder / "parts.csv");
  ASSERT_EQ(lines.size(), 2U);
  const auto names = test::cells_of(lines[0]), values = test::cells_of(lines[1]);
  ASSERT_EQ(names.size(), 17U);
  ASSERT_EQ(values.size(), names.size());
  EXPECT_EQ(names[1], "arm_joint_fx_N");
  EXPECT_EQ(names[15], "rod_tie_N");
  EXPECT_EQ(names[16], "rod_strut_N");
  EXPECT_EQ(std::stod(values[2]), 2);
  EXPECT_EQ(std::stod(values[15]), 120.5);
  EXPECT_EQ(std::stod(values[16]), -30);
}

TEST(PartsCsv, IsTheFileOfAVesselOnRodsWithoutParts) {
  EXPECT_EQ(part_columns({}, {"tie"}), (std::vector<std::string>{"time_s", "rod_tie_N"}));
}

}  // namespace parts_csv_test
}  // namespace nilas::output
