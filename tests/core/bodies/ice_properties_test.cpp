#include "core/bodies/ice_properties.h"

#include <gtest/gtest.h>

namespace nilas::bodies {
namespace ice_properties_test {

TEST(WeakLines, SegmentsNearAnOutlineAreKeptAboutItsCentre) {
  const std::vector<Vec2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const WeakLine line{{{0, 0}, {9.5, 0}, {10.5, 0}, {20, 0}, {20, 9}, {10, 0.5}}, 0.3};
  const auto near = lines_near({line, {{{0, 5}, {20, 5}}, 0.4}}, {10, 0}, square);
  ASSERT_EQ(near.size(), 2u) << "the way back is a line of its own, the other line passes by";
  EXPECT_EQ(near[0].points, (std::vector<Vec2>{{-10, 0}, {-0.5, 0}, {0.5, 0}, {10, 0}}));
  EXPECT_EQ(near[1].points, (std::vector<Vec2>{{10, 9}, {0, 0.5}}));
  EXPECT_EQ(near[1].strength, 0.3);
}

}  // namespace ice_properties_test
}  // namespace nilas::bodies
