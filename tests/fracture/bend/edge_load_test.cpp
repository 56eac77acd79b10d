#include "fracture/bend/edge_load.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/math.h"
#include "fracture/bend/edge_integral.h"

namespace nilas::fracture {

/// Both rows were computed from the same Fourier solution by other means, and rounded to these digits.
TEST(EdgeLoad, StressFactorsOfTheTable) {
  const std::vector<double> b{0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5};
  const std::vector<double> factor_30{7.882, 6.839, 5.461, 4.419, 3.380, 2.777, 2.031};
  const std::vector<double> factor_33{7.980, 6.923, 5.525, 4.469, 3.416, 2.805, 2.048};
  const EdgeLoad edge_30(0.3), edge_33(0.33);
  for (std::size_t k = 0; k < b.size(); ++k) {
    EXPECT_NEAR(edge_30.stress_factor(b[k]), factor_30[k], 6e-4) << b[k];
    EXPECT_NEAR(edge_33.stress_factor(b[k]), factor_33[k], 6e-4) << b[k];
  }
}

/// 0.95 - 1.505 ln(b/l), stated to 2 %.
TEST(EdgeLoad, LogarithmicFit) {
  const EdgeLoad edge(0.3);
  for (double b = 0.002; b <= 0.5; b *= 1.2)
    EXPECT_NEAR(edge.stress_factor(b) / (0.95 - 1.505 * std::log(b)), 1, 0.02) << b;
}

/// Westergaard's slope is 12 (1 + nu) / (pi (3 + nu)); the remainder is of the order (b/l)^2.
TEST(EdgeLoad, SlopeOfSmallLoads) {
  for (const double nu : {0.0, 0.3, 0.33, 0.5}) {
    const EdgeLoad edge(nu);
    const double slope = 12 * (1 + nu) / (k_pi * (3 + nu));
    EXPECT_NEAR((edge.stress_factor(1e-3) - edge.stress_factor(2e-3)) / std::log(2.0), slope, 1e-4 * slope);
    EXPECT_NEAR((edge.stress_factor(1e-5) - edge.stress_factor(1e-4)) / std::log(10.0), slope, 1e-12);
  }
}

TEST(EdgeLoad, DeflectionUnderAPointLoad) {
  EXPECT_NEAR(EdgeLoad(0.3).deflection(), 0.4620, 5e-5);
  EXPECT_NEAR(EdgeLoad(0.33).deflection(), 0.4693, 5e-5);
  // Westergaard's closed fit, P sqrt(2 + 1.2 nu) / sqrt(E h^3 k), is 0.6 to 0.9 % higher.
  for (const double nu : {0.3, 0.33}) {
    const double fit = std::sqrt((2 + 1.2 * nu) / (12 * (1 - nu * nu)));
    EXPECT_NEAR(fit / EdgeLoad(nu).deflection(), 1.0075, 0.002);
  }
}

/// Largest 3 (S(b + y) + S(b - y)) / b over a fine grid of y.
double searched_factor(const EdgeIntegral& integral, double b) {
  double most = 0;
  for (double y = 0; y <= b; y += b / 400)
    most = std::max(most, 3 * (integral.moment(b + y) + integral.moment(b - y)) / b);
  return most;
}

TEST(EdgeLoad, TableKeepsItsAccuracyBetweenNodes) {
  for (const double nu : {0.0, 0.3, 0.5}) {
    const EdgeIntegral integral(nu);
    const EdgeLoad edge(nu);
    for (double b = 1e-3; b < edge.widest_centred(); b *= 1.0213) {
      const double exact = 6 * integral.moment(b) / b;
      ASSERT_NEAR(edge.stress_factor(b), exact, 1e-6 * exact) << b;
    }
  }
}

/// The largest stress lies off the middle beyond widest_centred. The search over y in steps of b / 400 falls short by
/// half its curvature times (b / 800)^2, here below 2e-4.
TEST(EdgeLoad, LongLoadsBreakNearTheirEnds) {
  const EdgeIntegral integral(0.3);
  const EdgeLoad edge(0.3);
  for (const double b : {1.5, 1.9, 2.5, 4.0, 7.0, 9.9, 12.0}) {
    const double searched = searched_factor(integral, b);
    EXPECT_GE(edge.stress_factor(b), searched * (1 - 1e-6)) << b;
    EXPECT_NEAR(edge.stress_factor(b), searched, 2e-4 * searched) << b;
  }
  EXPECT_GT(edge.stress_factor(3), 1.5 * 6 * integral.moment(3) / 3);
}

/// Values and slopes agree on both sides of the three joints; the step itself alters the slope by 1e-5. Where the
/// largest stress leaves the middle the second derivative jumps; at b/l = 10 the ends' last influence on each other,
/// below 1e-6, is dropped.
TEST(EdgeLoad, IsSmoothAcrossItsJoints) {
  const EdgeLoad edge(0.3);
  const auto slope = [&](double b, double step) {
    return (edge.stress_factor(b + step) - edge.stress_factor(b)) / step;
  };
  for (const auto& [b, tolerance] : {std::pair{1e-3, 2e-5}, {edge.widest_centred(), 1e-3}, {10.0, 1e-3}}) {
    const double step = 1e-5 * b;
    EXPECT_NEAR(slope(b, step) / slope(b, -step), 1, tolerance) << b;
    EXPECT_NEAR(edge.stress_factor(b * (1 + 1e-9)) / edge.stress_factor(b * (1 - 1e-9)), 1, 1e-7) << b;
  }
}

TEST(EdgeLoad, CrackLoadScalesWithStrengthAndThickness) {
  const EdgeLoad edge(0.3);
  const double load = radial_crack_load(edge, 0.5, 10, 1, 5e5);
  EXPECT_NEAR(load, 5e5 / edge.stress_factor(0.05), 1e-6);
  EXPECT_NEAR(radial_crack_load(edge, 0.5, 10, 1, 1e6) / load, 2, 1e-12);
  EXPECT_NEAR(radial_crack_load(edge, 0.5, 10, 2, 5e5) / load, 4, 1e-12);
}

TEST(EdgeLoad, RefusesImpossibleInput) {
  EXPECT_THROW(EdgeLoad(0.6), ContractError);
  EXPECT_THROW(EdgeLoad(0.3).stress_factor(0), ContractError);
}

}  // namespace nilas::fracture
