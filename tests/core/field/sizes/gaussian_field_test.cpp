#include "core/field/sizes/gaussian_field.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "core/field/sizes/distribution_statistics.h"

namespace nilas::field {
namespace gaussian_field_test {

constexpr double k_length = 0.7;

GaussianField field_of(int seed) { return {k_length, RandomStream(static_cast<std::uint64_t>(seed), "texture")}; }

/// Points at some distances, in several directions, from one that lies anywhere.
const Vec2 k_from(31.7, -12.4);
const std::vector<Vec2> k_steps{{0.35, 0}, {0, 0.7}, {-0.5, 0.5}, {0.9, 0.9}, {0, -2.1}};

double stated(const Vec2& step) { return GaussianField::correlation(step.norm(), k_length); }

/// Moments over 4000 seeds. Tolerances are four standard errors: 1/sqrt(n) of the mean, sqrt(2/n) of the variance,
/// sqrt((1 + c^2)/n) of a covariance c.
TEST(GaussianField, OverManySeedsMomentsAndCovarianceAreThoseStated) {
  constexpr int k_seeds = 4000;
  std::vector<double> here, product(k_steps.size(), 0);
  for (int seed = 0; seed < k_seeds; ++seed) {
    const GaussianField field = field_of(seed);
    here.push_back(field.at(k_from));
    for (std::size_t k = 0; k < k_steps.size(); ++k)
      product[k] += here.back() * field.at(k_from + k_steps[k]) / k_seeds;
  }
  const double n = k_seeds;
  const auto s = summary_of(here);
  EXPECT_NEAR(s.mean, 0, 4 / std::sqrt(n));
  EXPECT_NEAR(s.sd * s.sd, 1, 4 * std::sqrt(2 / n));
  for (std::size_t k = 0; k < k_steps.size(); ++k) {
    const double c = stated(k_steps[k]);
    EXPECT_NEAR(product[k], c, 4 * std::sqrt((1 + c * c) / n)) << k_steps[k].transpose();
  }
  const auto normal = [](double u) {
    constexpr double k_far = 40;
    return u <= 0 ? -k_far : u >= 1 ? k_far : boost::math::quantile(boost::math::normal(), u);
  };
  // one sample in a thousand is further off
  EXPECT_LT(ks_distance(here, normal), 1.95 / std::sqrt(n));
}

/// One field over a wide plane: 20000 points far apart, so within four standard errors and the 0.01 of the modes.
TEST(GaussianField, OneFieldHasThemOverThePlane) {
  const GaussianField field = field_of(11);
  RandomStream places(1, "places");
  constexpr int k_points = 20000;
  double sum = 0, squares = 0;
  std::vector<double> product(k_steps.size(), 0);
  for (int i = 0; i < k_points; ++i) {
    const double x = places.uniform(-2000, 2000), y = places.uniform(-2000, 2000), value = field.at({x, y});
    sum += value / k_points;
    squares += value * value / k_points;
    for (std::size_t k = 0; k < k_steps.size(); ++k) product[k] += value * field.at(Vec2(x, y) + k_steps[k]) / k_points;
  }
  const double error = 4 / std::sqrt(static_cast<double>(k_points));
  EXPECT_NEAR(sum, 0, error);
  EXPECT_NEAR(squares, 1, error * std::sqrt(2.0));
  for (std::size_t k = 0; k < k_steps.size(); ++k)
    EXPECT_NEAR(product[k], stated(k_steps[k]), 0.01 + error * std::sqrt(2.0)) << k_steps[k].transpose();
}

TEST(GaussianField, SameStreamSameBits) {
  EXPECT_EQ(field_of(5).at({3, 4}), field_of(5).at({3, 4}));
  EXPECT_NE(field_of(5).at({3, 4}), field_of(6).at({3, 4}));
  EXPECT_DOUBLE_EQ(GaussianField::correlation(k_length, k_length), std::exp(-1));
}

}  // namespace gaussian_field_test
}  // namespace nilas::field
