/// Numbers of a report as text.
#include "apps/report/page/words.h"

#include <gtest/gtest.h>

namespace words_test {

using nilas::Vec3;
using namespace nilas::report;

/// A bow that is hit amidships: what rounding leaves across is no place.
TEST(PlaceText, RoundingIsZero) {
  EXPECT_EQ(place_text(Vec3(12.3456, -3.6e-9, -1.5)), "x = 12.35 m, y = 0 m, z = -1.5 m");
  EXPECT_EQ(place_text(Vec3(123.456, 0.04, 0.06)), "x = 123.5 m, y = 0 m, z = 0.1 m");
  EXPECT_EQ(place_text(Vec3(1e-9, -1e-9, 2e-8)), "x = 0 m, y = 0 m, z = 0 m");
  EXPECT_EQ(horizontal_place_text(Vec3(-0.51234, 0.2, 7)), "x = -0.5123 m, y = 0.2 m");
}

}  // namespace words_test
