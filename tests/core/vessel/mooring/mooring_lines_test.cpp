/// Lines as springs, and the pull of a single line in space.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "core/vessel/mooring/mooring_model.h"

namespace nilas::vessel {

namespace mooring_lines_test {

TEST(SpringLine, HasTwoSlopes) {
  const SpringLine spring = bilinear_spring(10, 100, 2, 500);
  EXPECT_EQ(spring.tension(-1), 0);
  EXPECT_DOUBLE_EQ(spring.tension(0.5), 50);
  EXPECT_DOUBLE_EQ(spring.tension(2), 200);
  EXPECT_DOUBLE_EQ(spring.tension(4), 200 + 2 * 500);
  EXPECT_EQ(spring.slope(-1), 0);
  EXPECT_DOUBLE_EQ(spring.slope(1), 100);
  EXPECT_DOUBLE_EQ(spring.slope(9), 500);
}

class SpringTable : public testing::Test {
 protected:
  SpringLine read(const std::string& rows) const {
    std::ofstream(file_) << "stretch_m,tension_N\n" << rows;
    return tabulated_spring(10, file_.string());
  }
  void TearDown() override { std::filesystem::remove(file_); }
  std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("nilas_spring_" + std::to_string(::getpid()) + ".csv");
};

TEST_F(SpringTable, IsReadFromAFile) {
  const SpringLine spring = read("-1,0\n0,50\n2,60\n");
  EXPECT_EQ(spring.tension(-2), 0);
  EXPECT_DOUBLE_EQ(spring.tension(-0.5), 25);
  EXPECT_DOUBLE_EQ(spring.tension(1), 55);
  EXPECT_DOUBLE_EQ(spring.tension(4), 70);
}

/// By Froude's law at twice the lengths, tensions are eight times as great.
TEST_F(SpringTable, IsScaled) {
  read("-1,0\n0,50\n2,60\n");
  const SpringLine spring = tabulated_spring(20, file_.string(), 2);
  EXPECT_EQ(spring.length, 20);
  EXPECT_DOUBLE_EQ(spring.tension(-1), 8 * 25);
  EXPECT_DOUBLE_EQ(spring.tension(2), 8 * 55);
  EXPECT_DOUBLE_EQ(spring.slope(1), 4 * 5);
}

TEST_F(SpringTable, IsRefusedWhereItIsNoCurve) {
  EXPECT_THROW(read("0,0\n"), InputError);
  EXPECT_THROW(read("0,0\n0,5\n"), InputError);
  EXPECT_THROW(read("0,5\n1,4\n"), InputError);
  EXPECT_THROW(read("0,-1\n1,4\n"), InputError);
  EXPECT_THROW(tabulated_spring(10, "no such file.csv"), FileError);
}

MooringLine line_from(const Vec3& anchor, std::variant<CatenaryLine, SpringLine> form) {
  MooringLine line;
  line.name = "m";
  line.anchor = anchor;
  line.form = std::move(form);
  return line;
}

/// A 3-4-5 triangle: a spring of 45 m between ends 50 m apart pulls with 5 m times its stiffness.
TEST(LineForce, PullsASpringTowardsItsAnchor) {
  const LineForce force = line_force(line_from({30, 0, -40}, bilinear_spring(45, 100, 100, 100)), -40, Vec3::Zero());
  EXPECT_NEAR((force.on_fairlead - Vec3(300, 0, -400)).norm(), 0, 1e-9);
  EXPECT_DOUBLE_EQ(force.tension(), 500);
}

/// The derivative of the force is measured by central differences, along and across the line.
TEST(LineForce, HasTheStiffnessOfItsForce) {
  const Vec3 anchor(300, -200, -100), fairlead(20, 10, 5);
  for (const auto& line :
       {line_from(anchor, CatenaryLine{420, 1500, 8e8, 0.0}), line_from(anchor, bilinear_spring(300, 1e4, 1e9, 1e4))}) {
    const Mat3 K = line_force(line, -100, fairlead).stiffness;
    constexpr double k_move = 1e-3;  // [m]
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = k_move * Vec3::Unit(axis);
      const Vec3 change =
          line_force(line, -100, fairlead + step).on_fairlead - line_force(line, -100, fairlead - step).on_fairlead;
      EXPECT_LT((change / (2 * k_move) + K.col(axis)).norm(), 1e-6 * K.norm()) << axis;
    }
  }
}

TEST(LineForce, TurnsWithItsLine) {
  const MooringLine line = line_from({300, 0, -100}, CatenaryLine{320, 1500, 8e8, 0.2});
  const Vec3 force = line_force(line, -100, {5, 0, 2}).on_fairlead;
  for (const double angle : {0.3, 1.0, 2.5, 4.0}) {
    const Quat turn(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
    const MooringLine turned = line_from(turn * line.anchor, line.form);
    EXPECT_LT((line_force(turned, -100, turn * Vec3(5, 0, 2)).on_fairlead - turn * force).norm(), 1e-11 * force.norm());
  }
}

/// The axis of a line of 0.4 m lies 0.2 m above the bed, and an anchor on the bed holds its end there. So its forces
/// are those of a thin line in water that is shallower by 0.2 m. An anchor above that height stays where it is.
TEST(LineForce, RestsOnItsUnderside) {
  CatenaryLine chain{320, 1500, 8e8, 0.2};
  const Vec3 fairlead(5, 0, 2);
  const LineForce shallow = line_force(line_from({300, 0, -99.8}, chain), -99.8, fairlead);
  chain.diameter = 0.4;
  const MooringLine thick = line_from({300, 0, -100}, chain);
  EXPECT_DOUBLE_EQ(axis_on_bed(thick, -100).value(), -99.8);
  EXPECT_LT((line_force(thick, -100, fairlead).on_fairlead - shallow.on_fairlead).norm(), 1e-9 * shallow.tension());
  const LineForce high = line_force(line_from({300, 0, -90}, chain), -100, fairlead);
  chain.diameter = 0;
  EXPECT_LT((high.on_fairlead - line_force(line_from({300, 0, -90}, chain), -99.8, fairlead).on_fairlead).norm(),
            1e-9 * high.tension());
  EXPECT_FALSE(axis_on_bed(line_from({30, 0, -40}, bilinear_spring(45, 100, 100, 100)), -40));
}

TEST(LineForce, RefusesAFairleadBelowTheBed) {
  const MooringLine line = line_from({300, 0, -100}, CatenaryLine{320, 1500, 8e8, 0});
  try {
    line_force(line, -100, {0, 0, -101});
    FAIL() << "no refusal";
  } catch (const SimulationError& error) {
    EXPECT_STREQ(error.what(), "mooring line 'm': its fairlead is 1 m below the sea bed");
  }
}

}  // namespace mooring_lines_test

}  // namespace nilas::vessel
