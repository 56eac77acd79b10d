#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/vessel/model/cells.h"
#include "tests/core/vessel/example_vessel.h"
#include "tests/support/mentions.h"
#include "tests/support/refusal.h"

namespace nilas::vessel {
namespace cells_layout_test {

const char* const k_header = "x_m,y_m,z_m,ax,ay,az\n";

std::string fault(const std::string& text) {
  const example::TemporaryFile file(text);
  const std::string found = test::refusal([&] { read_cells(file.path()); });
  EXPECT_TRUE(test::mentions(found, file.path())) << found << ":\n" << text;
  return found;
}

TEST(CellsLayout, DefaultHoldsEachAxisByItself) {
  const auto cells = default_cells(2.0);
  EXPECT_LT(layout_condition(cells), 10);
  const Mat6 A = cell_wrenches(cells);
  const Mat6 K = A * A.transpose();
  EXPECT_LT((K - Mat6(K.diagonal().asDiagonal())).norm(), 1e-15);
  Vec6 expected;
  expected << 2, 6, 8, 1, 2, 3;  // arm 2: 2 (arm/2)^2, (1 + 1/2) arm^2, 2 arm^2; one, two, three cells
  EXPECT_LT((K.diagonal() - expected).norm(), 1e-15);
}

TEST(CellsLayout, ConditionDoesNotDependOnTheUnitOfLength) {
  auto cells = default_cells(2.0);
  const double condition = layout_condition(cells);
  for (auto& cell : cells) cell.point *= 1e-3;
  EXPECT_NEAR(layout_condition(cells), condition, 1e-9);
}

TEST(CellsLayout, ReadsAndNormalises) {
  const example::TemporaryFile file(
      "ax,ay,az,x_m,y_m,z_m\n2,0,0,0,0,0.5\n0,-3,0,1,0,0\n0,1,0,-1,0,0\n0,0,1,1,0,0\n0,0,1,-1,1,0\n0.3,0,0.4,-1,-1,"
      "0\n");
  const auto cells = read_cells(file.path());
  EXPECT_EQ(cells[0].point, Vec3(0, 0, 0.5));
  EXPECT_EQ(cells[0].axis, Vec3(1, 0, 0));
  EXPECT_EQ(cells[1].axis, Vec3(0, -1, 0));
  EXPECT_LT((cells[5].axis - Vec3(0.6, 0, 0.8)).norm(), 1e-15);
}

TEST(CellsLayout, RefusesWrongFiles) {
  const std::string one = "0,0,0,1,0,0\n";
  EXPECT_NE(fault(k_header + one + one).find("found 2 load cells"), std::string::npos);
  EXPECT_NE(fault("x_m,y_m,z_m,ax,ay\n0,0,0,1,0\n").find("'az' is missing"), std::string::npos);
  EXPECT_NE(fault(k_header + one + "1,0,0,0,0,0\n" + one + one + one + one).find(":3: the cell's axis"),
            std::string::npos);
  // three vertical cells in a row hold no roll
  const std::string in_a_row = k_header + one + "1,0,0,0,1,0\n-1,0,0,0,1,0\n1,0,0,0,0,1\n0,0,0,0,0,1\n-1,0,0,0,0,1\n";
  EXPECT_NE(fault(in_a_row).find("do not hold all six directions"), std::string::npos);
  EXPECT_NE(fault(k_header + one + one + one + one + one + one).find("do not hold"), std::string::npos);
  EXPECT_THROW(read_cells("/nonexistent/cells.csv"), FileError);
}

/// The condensed stiffness is the limit of a platform in series with a joint that is soft along the free axes.
TEST(CellsLayout, CondensedStiffnessIsThatOfAJointInSeries) {
  auto cells = default_cells(1.5);
  cells[0].point = {0.1, 0.2, 0.3};  // so that the axes couple
  cells[4].axis = Vec3(0.1, 0.2, 1).normalized();
  const Mat6 A = cell_wrenches(cells);
  const double k = 1e6;
  const std::vector<int> free{1, 5};
  const Mat6 K = condensed_stiffness(A, k, free);
  Mat6 joint_compliance = Mat6::Zero();
  for (const int axis : free) joint_compliance(axis, axis) = 1e9 / k;
  const Mat6 series = (Mat6(k * A * A.transpose()).inverse() + joint_compliance).inverse();
  EXPECT_LT((K - series).norm(), 1e-7 * K.norm());
  EXPECT_EQ(K.row(1).norm() + K.col(1).norm() + K.row(5).norm() + K.col(5).norm(), 0);
  EXPECT_EQ(K, K.transpose());
  EXPECT_EQ(condensed_stiffness(A, k, {0, 1, 2, 3, 4, 5}), Mat6::Zero());
}

}  // namespace cells_layout_test
}  // namespace nilas::vessel
