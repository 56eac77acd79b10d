#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/field/field.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/polygon.h"
#include "tests/core/field/field_measures.h"

namespace nilas::field {
namespace sheet_field_test {

const std::vector<Vec2> k_hull{{2, -0.5}, {5, -0.5}, {6, 0}, {5, 0.5}, {2, 0.5}};
constexpr double k_hull_area = 3.5;

LevelSpec level_of(std::vector<std::vector<Vec2>> keep_out) { return {{0, -4}, {10, 4}, std::move(keep_out)}; }

TEST(Level, IsOneSheetWithoutAHull) {
  const FieldResult field = level_field(level_of({}));
  ASSERT_EQ(field.floes.size(), 1u);
  EXPECT_EQ(field.floes[0].outline.size(), 4u);
  EXPECT_EQ(field.concentration, 1);
}

TEST(Level, AHullThatReachesInLeavesABay) {
  auto hull = k_hull;
  for (auto& x : hull) x.x() -= 3;
  const FieldResult field = level_field(level_of({hull}));
  ASSERT_EQ(field.floes.size(), 1u);
  EXPECT_FALSE(geometry::is_convex(field.floes[0].outline));
  EXPECT_NEAR(test::ice_area(field), 80 - (k_hull_area - 1), 1e-12);
  EXPECT_NEAR(field.concentration, 1, 1e-12);
}

TEST(Level, AHullInsideHasItsTrackOpenBehindIt) {
  const FieldResult field = level_field(level_of({k_hull}));
  ASSERT_EQ(field.floes.size(), 1u);
  EXPECT_NEAR(test::ice_area(field), 80 - k_hull_area - 2, 1e-12);
  EXPECT_NEAR(field.concentration, (80 - k_hull_area - 2) / (80 - k_hull_area), 1e-12);
  auto turned = level_of({k_hull});
  turned.aft = {0, 1};
  EXPECT_NEAR(test::ice_area(level_field(turned)), 80 - k_hull_area - (4 * 4 - 3 * 0.5 - 0.5 * 0.5), 1e-12);
}

TEST(Level, AHullAcrossPartsTheSheetInTwo) {
  const FieldResult field = level_field(level_of({{{-1, -0.5}, {11, -0.5}, {11, 1.5}, {-1, 1.5}}}));
  ASSERT_EQ(field.floes.size(), 2u);
  EXPECT_NEAR(geometry::polygon_moments(field.floes[0].outline).area, 35, 1e-12);
  EXPECT_NEAR(geometry::polygon_moments(field.floes[1].outline).area, 25, 1e-12);
}

TEST(Level, ACoveredRegionIsRefused) {
  EXPECT_THROW(level_field(level_of({{{-1, -5}, {11, -5}, {11, 5}, {-1, 5}}})), InputError);
}

TEST(Channel, HasFloesBetweenFixedSheets) {
  ChannelSpec spec;
  spec.ice.low = {0, -4};
  spec.ice.high = {20, 4};
  spec.ice.mean = 0.4;
  spec.ice.sd = 0.1;
  spec.ice.min = 0.2;
  spec.ice.max = 0.7;
  spec.width = 2;
  const FieldResult field = channel_field(spec);
  double sheets = 0, broken = 0;
  for (const auto& floe : field.floes) {
    (floe.fixed ? sheets : broken) += geometry::polygon_moments(floe.outline).area;
    for (const Vec2& x : floe.outline) EXPECT_TRUE(floe.fixed ? std::abs(x.y()) >= 1 : std::abs(x.y()) < 1);
  }
  EXPECT_NEAR(sheets, 120, 1e-12);
  EXPECT_NEAR(broken / 40, field.concentration, 1e-12);
  EXPECT_NEAR(field.concentration, 0.8, 0.5 * 0.49 / 40);
  spec.width = 8;
  EXPECT_THROW(channel_field(spec), InputError);
}

TEST(Channel, ABroadHullCutsIntoTheSheets) {
  ChannelSpec spec;
  spec.ice.low = {0, -4};
  spec.ice.high = {10, 4};
  spec.ice.mean = 0.4;
  spec.ice.min = 0.2;
  spec.width = 0.8;
  spec.ice.keep_out = {k_hull};
  double sheets = 0;
  for (const auto& floe : channel_field(spec).floes)
    if (floe.fixed) sheets += geometry::polygon_moments(floe.outline).area;
  const double beyond = 2 * (3 * 0.1 + 0.5 * 0.1 * 0.2);  // the hull's part outside the channel
  EXPECT_NEAR(sheets, 72 - beyond, 1e-12);
}

}  // namespace sheet_field_test
}  // namespace nilas::field
