#include "fracture/crush/ice_columns.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/mass_properties.h"
#include "core/geometry/polygon.h"

namespace nilas::fracture {
namespace ice_columns_test {

const Vec2 k_low(-10, -10), k_high(10, 10);

std::vector<char> all_outer(const geometry::ConvexPolytope& part) { return std::vector<char>(part.normals.size(), 1); }

double area_of(const std::vector<Vec2>& polygon) {
  return polygon.empty() ? 0 : geometry::polygon_moments(polygon).area;
}

TEST(IceColumns, OfABoxKeepTheMarginFromItsSides) {
  const geometry::ConvexPolytope box = geometry::make_box({2, 3, 4});
  const Placement above{Mat3::Identity(), {0.5, 0, 0.7}};
  const auto columns = columns_inside(box, all_outer(box), above, 0.2, 0.1, k_low, k_high);
  EXPECT_NEAR(area_of(columns), 1.8 * 2.8, 1e-12);
  EXPECT_TRUE(geometry::contains(columns, {1.39, 1.39}));
  EXPECT_FALSE(geometry::contains(columns, {1.41, 0}));
  // its lower face lies within the ice from p_z = 1.9 on: no column is inside
  EXPECT_NEAR(area_of(columns_inside(box, all_outer(box), {Mat3::Identity(), {0, 0, 1.89}}, 0.2, 0, k_low, k_high)), 6,
              1e-12);
  EXPECT_TRUE(columns_inside(box, all_outer(box), {Mat3::Identity(), {0, 0, 1.91}}, 0.2, 0, k_low, k_high).empty());
  EXPECT_NEAR(area_of(columns_inside(box, all_outer(box), above, 0.2, 0.1, {0, 0}, {1, 1})), 1, 1e-12);
}

/// A side that leans outward by 45 degrees stands farther out at the top: the columns end where it is at the bottom.
TEST(IceColumns, EndAtTheNarrowestSectionOverTheThickness) {
  const geometry::ConvexPolytope box = geometry::make_box({2, 2, 2});
  const Mat3 turned(Eigen::AngleAxisd(k_pi / 4, Vec3::UnitY()));
  const auto columns = columns_inside(box, all_outer(box), {turned, Vec3::Zero()}, 0.4, 0, k_low, k_high);
  // in the plane y = 0 a square on its corner, |x| + |z| <= sqrt 2
  const double half = std::sqrt(2) - 0.2;
  EXPECT_NEAR(area_of(columns), 2 * half * 2, 1e-12);
  for (const Vec2& p : columns) EXPECT_NEAR(std::abs(p.x()), half, 1e-12);
}

TEST(IceColumns, GoOnAcrossFacesBetweenParts) {
  const geometry::ConvexPolytope box = geometry::make_box({2, 2, 2});
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
  EXPECT_NEAR(area_of(columns), (1.9 + 0.1) * 1.8, 1e-12);
  EXPECT_TRUE(geometry::contains(columns, {1.09, 0}));
}

std::vector<Vec2> box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

/// Two columns in an L of three unit squares: one reaches out of it.
TEST(CrushedIce, HasTheAreaOfItsColumnsWithinTheOutline) {
  const std::vector<Vec2> outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const ColumnArea columns = column_area({box(0.5, 0.5, 1.5, 1.5), box(1.75, 0.25, 1.9, 0.5)}, outline);
  const double first = 0.75, second = 0.15 * 0.25;
  EXPECT_NEAR(columns.area, first + second, 1e-15);
  EXPECT_NEAR(columns.outside, 0.25, 1e-15);
  const double x_first = (0.25 * 0.75 * 2 + 0.25 * 1.25) / first;
  EXPECT_NEAR(columns.centroid.x(), (first * x_first + second * 1.825) / (first + second), 1e-15);
  EXPECT_EQ(column_area({}, outline).area, 0);
  EXPECT_NEAR(column_area({box(0, 0, 0.5, 1), box(0.4, 0, 1, 1)}, outline).area, 1, 1e-15)
      << "what is in both counts once";
}

/// Two convex pieces meet in a leaning face. Neither alone has the whole thickness of the ice between their columns.
TEST(CrushedIce, TakesWhatIsShutInBetweenColumns) {
  const CrushedIce ice{{box(0, 0, 1, 1), box(1.1, 0, 2, 1)}, {box(-0.1, -0.1, 1.05, 1.1), box(1.05, -0.1, 2.1, 1.1)}};
  EXPECT_TRUE(is_squeezed_out(ice, box(0, 0, 1, 0.5)));
  EXPECT_TRUE(is_squeezed_out(ice, box(1, 0, 1.1, 1)));
  EXPECT_FALSE(is_squeezed_out(ice, box(1, 0, 1.1, 1.2))) << "reaches out of the hull";
  EXPECT_FALSE(is_squeezed_out(ice, box(1.9, 0, 3, 1)));
  EXPECT_FALSE(is_squeezed_out({}, box(0, 0, 1, 1)));
}

TEST(CrushedIce, GroupsAreOfColumnsThatOverlap) {
  const auto groups = connected({box(0, 0, 1, 1), box(3, 0, 4, 1), box(1.5, 0, 2.5, 1), box(0.9, 0, 1.6, 1)});
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].size() + groups[1].size(), 4u);
  EXPECT_EQ(std::min(groups[0].size(), groups[1].size()), 1u);
}

/// A wide box behind a narrow one: where the narrow one covers the wide one's front, the columns are one.
TEST(CrushedIce, ColumnsOfPartsThatMeetOverlap) {
  const geometry::ConvexPolytope wide = geometry::make_box({2, 2, 2}), narrow = geometry::make_box({1, 1, 2});
  const auto outer = [](const geometry::ConvexPolytope& part, double covered) {
    std::vector<char> flags;
    for (const Vec3& n : part.normals) flags.push_back(n.x() * covered > 0.5 ? 0 : 1);
    return flags;
  };
  const Vec2 low(-9, -9), high(9, 9);
  // the wide one's front is covered in part only, so it counts as surface; the narrow one's back is covered wholly
  const auto behind = columns_inside(wide, outer(wide, 0), {}, 0.4, 0.1, low, high);
  const auto before = columns_inside(narrow, outer(narrow, -1), {Mat3::Identity(), {1.5, 0, 0}}, 0.4, 0.1, low, high);
  EXPECT_EQ(connected({behind, before}).size(), 1u);
  const auto alone = columns_inside(narrow, outer(narrow, 0), {Mat3::Identity(), {1.5, 0, 0}}, 0.4, 0.1, low, high);
  EXPECT_EQ(connected({behind, alone}).size(), 2u);
}

/// A channel from the left, whose end the column stands in, in a sheet that ends at x = 5.
TEST(CrushedIce, AColumnThatReachesTheFarEdgeMeetsTheOutlineTwice) {
  const std::vector<Vec2> outline{{0, -3}, {5, -3}, {5, 3}, {0, 3}, {0, 1}, {4, 1}, {4, -1}, {0, -1}};
  EXPECT_EQ(times_inside(box(3, -1.2, 4.9, 1.2), outline), 1);
  EXPECT_EQ(times_inside(box(3, -1.2, 5.1, 1.2), outline), 2);
  EXPECT_EQ(times_inside(box(1, -2.5, 2, -1.5), outline), 0);
}

TEST(CrushedIce, LittleCornersBesideNewEdgesGo) {
  // along y = 0: a straight corner, a cusp towards the water, and a notch
  const std::vector<Vec2> all{{0, 0}, {1, 0},     {2, -0.01}, {3, 0}, {4, 0.01},
                              {5, 0}, {6, -0.01}, {7, 0},     {7, 5}, {0, 5}};
  std::vector<Vec2> outline = all;
  std::vector<bool> is_new{true, true, true, true, true, false, false, false, false, false};
  ASSERT_TRUE(trim_corners(outline, is_new, 0.1, 1));
  EXPECT_EQ(outline.size(), is_new.size());
  for (const std::size_t kept : {4, 8})
    EXPECT_NE(std::find(outline.begin(), outline.end(), all[kept]), outline.end()) << kept;
  for (const std::size_t gone : {1, 2, 3})
    EXPECT_EQ(std::find(outline.begin(), outline.end(), all[gone]), outline.end()) << gone;
  EXPECT_LE(geometry::polygon_moments(outline).area, geometry::polygon_moments(all).area);
  is_new.assign(outline.size(), false);
  EXPECT_FALSE(trim_corners(outline, is_new, 0.1, 1)) << "old corners stay";
}

}  // namespace ice_columns_test
}  // namespace nilas::fracture
