#include "core/field/spec/keep_out.h"

#include <gtest/gtest.h>

#include "core/geometry/mass_properties.h"
#include "core/geometry/polygon.h"

namespace nilas::field {
namespace keep_out_test {

std::vector<Vec2> box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

/// Area of a convex outline grown by m: A + P m + pi m^2; the many-sided corners add a little.
TEST(KeepOut, GrownOutlineHoldsTheRoundOne) {
  const auto grown = grown_outline(box(0, 0, 3, 1), 0.5);
  const double area = geometry::polygon_moments(grown).area, round = 3 + 8 * 0.5 + k_pi * 0.25;
  EXPECT_TRUE(geometry::is_convex(grown));
  EXPECT_GE(area, round);
  EXPECT_LE(area, round * 1.002);
  for (int k = 0; k < 360; ++k) {
    const Vec2 ray(std::cos(k * k_deg), std::sin(k * k_deg));
    EXPECT_TRUE(geometry::contains(grown, Vec2(3, 1) + 0.4999 * ray));
  }
}

/// Two crossing strips of a 10 x 10 region: 2 x 10 + 10 x 3 - 2 x 3; a third far outside counts nothing.
TEST(KeepOut, FreeAreaCountsOverlapsOnceAndOnlyTheRegion) {
  const std::vector<std::vector<Vec2>> strips{box(4, -5, 6, 20), box(-1, 2, 11, 5), box(20, 20, 30, 30)};
  EXPECT_NEAR(free_area({0, 0}, {10, 10}, strips), 100 - (20 + 30 - 6), 1e-12);
  EXPECT_NEAR(free_area({0, 0}, {10, 10}, {box(-1, -1, 11, 11)}), 0, 1e-12);
}

TEST(KeepOut, CutKeepsOneSide) {
  const auto half = cut_outline(box(0, 0, 2, 1), {1, 0}, 0.5);
  EXPECT_NEAR(geometry::polygon_moments(half).area, 0.5, 1e-15);
  EXPECT_TRUE(cut_outline(box(0, 0, 2, 1), {1, 0}, -1).empty());
}

}  // namespace keep_out_test
}  // namespace nilas::field
