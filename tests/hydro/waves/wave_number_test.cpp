#include "hydro/database/wave_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace wave_number_test {

using nilas::hydro::wave_number;

constexpr double k_gravity = 9.81;

/// In deep water k = w^2 / g, to the last bit.
TEST(WaveNumber, IsExactInDeepWater) {
  for (const double w : {0.01, 0.5, 1.0, 7.3}) EXPECT_EQ(wave_number(w, k_gravity, std::nullopt), w * w / k_gravity);
}

/// The residual w^2 - g k tanh kh is rounding of w^2 over eight decades of depth, from shallow to deep water.
TEST(WaveNumber, HoldsToRoundingAtAnyDepth) {
  for (double depth = 1e-3; depth < 1e5; depth *= 1.7)
    for (const double w : {0.02, 0.3, 1.0, 2.5, 9.0}) {
      const double k = wave_number(w, k_gravity, depth);
      EXPECT_NEAR(k_gravity * k * std::tanh(k * depth) / (w * w), 1, 4e-16 * 4) << w << " " << depth;
    }
}

/// Long waves travel at sqrt(g h): the error of k is (kh)^2 / 6 of it, here 2e-6.
TEST(WaveNumber, ApproachesShallowWater) {
  const double depth = 0.1, w = 0.035, k = wave_number(w, k_gravity, depth);
  EXPECT_NEAR(k / (w / std::sqrt(k_gravity * depth)), 1 + std::pow(k * depth, 2) / 6, 1e-9);
}

}  // namespace wave_number_test
