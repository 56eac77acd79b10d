/// Tests of the cost of simplifications: every row shows a cost, which vanishes without the simplification.
#include "apps/verify/limitations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace limitations_test {

using namespace nilas;
using namespace nilas::verify;

TEST(Limitations, EveryRowIsExactWithoutItsSimplificationAndOffWithIt) {
  int times = 0;
  for (const Limitation& one : limitations()) {
    if (!one.exact) {
      ++times;
      EXPECT_TRUE(std::isfinite(one.with) && one.with > 0) << one.measured;
      EXPECT_EQ(one.without, 1) << one.measured;
      continue;
    }
    const double scale = std::max({std::abs(*one.exact), std::abs(one.with)});
    EXPECT_NEAR(one.without, *one.exact, 1e-6 * scale) << one.name << ": " << one.measured;
    EXPECT_GT(std::abs(one.with - *one.exact), 0.2 * scale) << one.name << ": " << one.measured;
  }
  EXPECT_EQ(times, 1);
}

TEST(Limitations, TimesHaveTwoDigitsAndNoExactValue) {
  const std::string page = limitations_markdown({{"a tool", "time", "`a.xml`", 3.14159, 1}});
  EXPECT_NE(page.find("| a tool | time | `a.xml` | 3.1 | 1 | - |\n"), std::string::npos) << page;
}

}  // namespace limitations_test
