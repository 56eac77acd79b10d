#include "hydro/radiation/piecewise_cubic.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace nilas::hydro::piecewise_cubic_test {

/// f = sin x on [0, pi] has f'' = 0 at both ends, so its spline errs by the fourth power of the spacing.
PiecewiseCubic sine(int intervals) {
  std::vector<double> x;
  MatX values(intervals + 1, 1);
  for (int k = 0; k <= intervals; ++k) {
    x.push_back(k_pi * k / intervals);
    values(k, 0) = std::sin(x.back());
  }
  return {x, values};
}

TEST(PiecewiseCubic, ApproachesASmoothFunctionWithFourthOrder) {
  const auto worst = [](const PiecewiseCubic& f) {
    double most = 0;
    for (double x = 0; x < k_pi; x += 1e-3) most = std::max(most, std::abs(f(x)[0] - std::sin(x)));
    return most;
  };
  const double coarse = worst(sine(10)), fine = worst(sine(40));
  EXPECT_LT(coarse, 5.0 / 384 * std::pow(k_pi / 10, 4));  // the bound of Hall and Meyer
  EXPECT_NEAR(coarse / fine, 256, 30);                    // 4^4
  EXPECT_NEAR(sine(100).integrals()(100, 0), 2, 1e-8);
}

/// int_0^pi sin x exp(i t x) dx = (1 + exp(i pi t)) / (1 - t^2).
TEST(PiecewiseCubic, TransformsAsTheClosedForm) {
  const PiecewiseCubic f = sine(400);
  for (const double t : {0.0, 1e-3, 0.5, 3.3, 17.0, 250.0}) {
    const std::complex<double> exact = (1.0 + std::exp(std::complex<double>(0, k_pi * t))) / (1 - t * t);
    EXPECT_LT(std::abs(f.fourier(t)[0] - exact), 1e-9) << t;
  }
}

/// The transform of the spline itself is exact: a rough spline against the midpoint rule with a million points.
TEST(PiecewiseCubic, TransformsARoughSplineExactly) {
  MatX values(5, 2);
  values << 0, 1, 2, -1, 1, 3, -2, 0, 1, 1;
  const std::vector<double> x{0, 0.3, 1, 1.1, 2.5};
  for (const bool clamped : {false, true}) {
    const PiecewiseCubic f(x, values, clamped ? std::optional(0.7) : std::nullopt);
    if (clamped) {
      EXPECT_DOUBLE_EQ(f.slopes()(0, 0), 0.7);
    }
    for (const double t : {0.2, 4.0, 40.0}) {
      Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(2);
      const int points = 200000;
      for (int k = 0; k < points; ++k) {
        const double at = 2.5 * (k + 0.5) / points;
        sum += 2.5 / points * std::exp(std::complex<double>(0, t * at)) * f(at).cast<std::complex<double>>();
      }
      EXPECT_LT((f.fourier(t) - sum).norm(), 1e-8) << t;
    }
  }
}

TEST(PiecewiseCubic, RefusesKnotsThatDoNotRise) {
  EXPECT_THROW(PiecewiseCubic({0, 1, 1}, MatX::Zero(3, 1)), ContractError);
  EXPECT_THROW(sine(3)(4), ContractError);
}

}  // namespace nilas::hydro::piecewise_cubic_test
