#include "core/vessel/mooring/line_shape.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nilas::vessel {
namespace line_shape_test {

MooringLine chain(double length, const Vec3& anchor) {
  MooringLine line;
  line.anchor = anchor;
  line.form = CatenaryLine{.length = length, .weight = 1000, .stiffness = 1e8, .bed_friction = 0};
  return line;
}

double length_of(const std::vector<Vec3>& points) {
  double sum = 0;
  for (std::size_t k = 1; k < points.size(); ++k) sum += (points[k] - points[k - 1]).norm();
  return sum;
}

TEST(LineShape, EndsAreThoseOfTheLineAndItsLengthIsThatOfTheCatenary) {
  const Vec3 anchor(10, 20, -50), fairlead(240, 110, -5);
  for (const std::optional<double> bed : {std::optional<double>(-50), std::optional<double>()}) {
    const auto points = line_shape(chain(260, anchor), bed, fairlead);
    EXPECT_LT((points.front() - anchor).norm(), 1e-9);
    if (bed) {
      EXPECT_NEAR(points[1].z(), *bed, 1e-6) << "the line leaves the bed there";
    } else {
      EXPECT_LT((points[1] - anchor).norm(), 1e-6);
    }
    EXPECT_LT((points.back() - fairlead).norm(), 1e-9);
    EXPECT_NEAR(length_of(points), 260, 0.01 * 260) << "32 pieces, and a small stretch";
    for (std::size_t k = 1; bed && k < points.size(); ++k) EXPECT_GE(points[k].z(), points[k - 1].z() - 1e-6);
  }
}

TEST(LineShape, ASlackLineHangsPlumbAndLiesOnTheBed) {
  const auto points = line_shape(chain(100, Vec3(0, 0, -20)), -20, Vec3(30, 0, 0));
  EXPECT_LT((points.back() - Vec3(30, 0, 0)).norm(), 1e-9);
  EXPECT_NEAR((points[1] - Vec3(30, 0, -20)).norm(), 0, 0.1);
}

TEST(LineShape, ASpringIsStraight) {
  MooringLine line;
  line.anchor = Vec3(0, 0, -20);
  line.form = bilinear_spring(10, 1e3, 1, 1e4);
  EXPECT_EQ(line_shape(line, -20, Vec3(30, 0, 0)).size(), 2u);
}

}  // namespace line_shape_test
}  // namespace nilas::vessel
