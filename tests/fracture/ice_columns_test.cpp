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

}  // namespace
}  // namespace nilas
