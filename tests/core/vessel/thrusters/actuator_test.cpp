#include "core/vessel/thrusters/actuator.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/math.h"

namespace actuator_test {

using namespace nilas;
using vessel::follow_command;
using vessel::turn_towards;

constexpr double k_no_rate = std::numeric_limits<double>::infinity();

// Without a rate limit x = c + (x0 - c) exp(-t / lag).
TEST(Actuator, FollowsByTheExponentialOfItsLag) {
  EXPECT_DOUBLE_EQ(follow_command(2, 10, 1.5, k_no_rate, 3), 10 - 8 * std::exp(-2));
}

// Far from its command it moves at its rate: from 0 towards 10 at 2 per s with lag 1 s, it is 2 away after 4 s, and
// 2 exp(-1) away after 5 s.
TEST(Actuator, MovesAtItsRateAndThenByItsLag) {
  EXPECT_DOUBLE_EQ(follow_command(0, 10, 1, 2, 3), 6);
  EXPECT_DOUBLE_EQ(follow_command(0, 10, 1, 2, 4), 8);
  EXPECT_NEAR(follow_command(0, 10, 1, 2, 5), 10 - 2 * std::exp(-1), 1e-14);
  EXPECT_NEAR(follow_command(0, -10, 1, 2, 5), -10 + 2 * std::exp(-1), 1e-14);
}

TEST(Actuator, IsExactOverStepsOfAnySize) {
  for (const double lag : {0.0, 0.3, 2.0})
    for (const double rate : {0.7, 5.0, k_no_rate}) {
      double x = -1;
      for (const double h : {0.01, 0.4, 1.3, 0.002, 2.0}) x = follow_command(x, 3, lag, rate, h);
      EXPECT_NEAR(x, follow_command(-1, 3, lag, rate, 0.01 + 0.4 + 1.3 + 0.002 + 2.0), 1e-14)
          << "lag " << lag << ", rate " << rate;
    }
}

TEST(Actuator, TurnsTheShortestWay) {
  EXPECT_NEAR(turn_towards(170 * k_deg, -170 * k_deg, 10 * k_deg, 1), 180 * k_deg, 1e-14);
  EXPECT_NEAR(turn_towards(170 * k_deg, -170 * k_deg, 10 * k_deg, 1.5), -175 * k_deg, 1e-14);
  EXPECT_NEAR(turn_towards(0, -90 * k_deg, 10 * k_deg, 1), -10 * k_deg, 1e-14);
  EXPECT_EQ(turn_towards(0, 0.1, k_no_rate, 0.1), 0.1);
}

}  // namespace actuator_test
