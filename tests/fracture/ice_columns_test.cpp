#include "fracture/ice_columns.h"

#include <gtest/gtest.h>

#include "core/bodies/mass_properties.h"
#include "core/bodies/polygon.h"

namespace nilas {
namespace {

const Vec2 k_low(-10, -10), k_high(10, 10);

std::vector<char> all_outer(const ConvexPolytope& part) { return std::vector<char>(part.normals.size(), 1); }

double area_of(const std::vector<Vec2>& polygon) { return polygon.empty() ? 0 : polygon_moments(polygon).area; }

TEST(IceColumns, OfABoxKeepTheMarginFromItsSides) {
  const ConvexPolytope box = make_box({2, 3, 4});
  const Placement above{Mat3::Identity(), {0.5, 0, 0.7}};
  const auto columns = columns_inside(box, all_outer(box), above, 0.2, 0.1, k_low, k_high);
  EXPECT_NEAR(area_of(columns), 1.8 * 2.8, 1e-12);
  EXPECT_TRUE(contains(columns, {1.39, 1.39}));
  EXPECT_FALSE(contains(columns, {1.41, 0}));
  // its lower face lies within the ice from p_z = 1.9 on: no column is inside
  EXPECT_NEAR(area_of(columns_inside(box, all_outer(box), {Mat3::Identity(), {0, 0, 1.89}}, 0.2, 0, k_low, k_high)), 6,
              1e-12);
  EXPECT_TRUE(columns_inside(box, all_outer(box), {Mat3::Identity(), {0, 0, 1.91}}, 0.2, 0, k_low, k_high).empty());
  EXPECT_NEAR(area_of(columns_inside(box, all_outer(box), above, 0.2, 0.1, {0, 0}, {1, 1})), 1, 1e-12);
}

/// A side that leans outward by 45 degrees stands farther out at the top: the columns end where it is at the bottom.
TEST(IceColumns, EndAtTheNarrowestSectionOverTheThickness) {
  const ConvexPolytope box = make_box({2, 2, 2});
  const Mat3 turned(Eigen::AngleAxisd(k_pi / 4, Vec3::UnitY()));
  const auto columns = columns_inside(box, all_outer(box), {turned, Vec3::Zero()}, 0.4, 0, k_low, k_high);
  // in the plane y = 0 a square on its corner, |x| + |z| <= sqrt 2
  const double half = std::sqrt(2) - 0.2;
  EXPECT_NEAR(area_of(columns), 2 * half * 2, 1e-12);
  for (const Vec2& p : columns) EXPECT_NEAR(std::abs(p.x()), half, 1e-12);
}

TEST(IceColumns, FacesBetweenPartsNeedNoMargin) {
  const ConvexPolytope box = make_box({2, 2, 2});
  std::vector<HullFace> surface;
  for (std::size_t f = 0; f < box.faces.size(); ++f) {
    std::vector<Vec3> loop;
    for (const int v : box.faces[f]) loop.push_back(box.vertices[std::size_t(v)]);
    if (box.normals[f].x() < 0.5) surface.push_back(make_hull_face(0, loop));
  }
  const auto outer = outer_faces({box}, surface);
  ASSERT_EQ(outer.size(), 1u);
  for (std::size_t f = 0; f < box.faces.size(); ++f) EXPECT_EQ(outer[0][f], box.normals[f].x() < 0.5 ? 1 : 0);
  const auto columns = columns_inside(box, outer[0], {}, 0.1, 0.1, k_low, k_high);
  EXPECT_NEAR(area_of(columns), 1.9 * 1.8, 1e-12);
  EXPECT_TRUE(contains(columns, {0.99, 0}));
}

std::vector<Vec2> box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

/// Two columns in an L of three unit squares: one reaches out of it.
TEST(CrushedIce, HasTheAreaOfItsColumnsWithinTheOutline) {
  const std::vector<Vec2> outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const CrushedIce ice{{box(0.5, 0.5, 1.5, 1.5), box(1.75, 0.25, 1.9, 0.5)}, {}};
  const ColumnArea columns = column_area(ice, outline);
  const double first = 0.75, second = 0.15 * 0.25;
  EXPECT_NEAR(columns.area, first + second, 1e-15);
  EXPECT_NEAR(columns.outside, 0.25, 1e-15);
  const double x_first = (0.25 * 0.75 * 2 + 0.25 * 1.25) / first;
  EXPECT_NEAR(columns.centroid.x(), (first * x_first + second * 1.825) / (first + second), 1e-15);
  EXPECT_EQ(column_area({}, outline).area, 0);
}

/// Of ice between the columns of two parts that meet in a face which leans, no part alone has the whole thickness.
TEST(CrushedIce, TakesWhatIsShutInBetweenColumns) {
  const CrushedIce ice{{box(0, 0, 1, 1), box(1.1, 0, 2, 1)}, {box(-0.1, -0.1, 1.05, 1.1), box(1.05, -0.1, 2.1, 1.1)}};
  EXPECT_TRUE(is_squeezed_out(ice, box(0, 0, 1, 0.5)));
  EXPECT_TRUE(is_squeezed_out(ice, box(1, 0, 1.1, 1)));
  EXPECT_FALSE(is_squeezed_out(ice, box(1, 0, 1.1, 1.2))) << "reaches out of the hull";
  EXPECT_FALSE(is_squeezed_out(ice, box(1.9, 0, 3, 1)));
  EXPECT_FALSE(is_squeezed_out({}, box(0, 0, 1, 1)));
}

}  // namespace
}  // namespace nilas
