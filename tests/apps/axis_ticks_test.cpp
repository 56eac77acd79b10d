/// Numbers along the axes of drawings, from model to full scale.
#include "apps/report/axis_ticks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace nilas {
namespace axis_ticks_test {

TEST(AxisTicks, AreRoundAndNeitherFewNorMany) {
  constexpr int k_most = 8;
  for (double length = 1e-3; length < 1e5; length *= 1.07) {
    const double step = report::tick_step(length, k_most);
    const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
    EXPECT_TRUE(std::abs(mantissa - 1) < 1e-9 || std::abs(mantissa - 2) < 1e-9 || std::abs(mantissa - 5) < 1e-9)
        << length << ": " << step;
    EXPECT_LE(length / step, k_most + 1e-6) << length;
    EXPECT_GT(length / step, k_most / 2.5 - 1e-6) << length << ": the next smaller step would fit";
  }
}

TEST(AxisTicks, SuitHullsOfAnySize) {
  EXPECT_DOUBLE_EQ(report::tick_step(0.5, 8), 0.1);
  EXPECT_DOUBLE_EQ(report::tick_step(6, 8), 1);
  EXPECT_DOUBLE_EQ(report::tick_step(100, 8), 20);
  EXPECT_DOUBLE_EQ(report::tick_step(300, 8), 50);
  EXPECT_DOUBLE_EQ(report::tick_step(8, 8), 1) << "exactly as many as are allowed";
  EXPECT_THROW(report::tick_step(0, 8), ContractError);
  EXPECT_THROW(report::tick_step(1, 0), ContractError);
}

}  // namespace axis_ticks_test
}  // namespace nilas
