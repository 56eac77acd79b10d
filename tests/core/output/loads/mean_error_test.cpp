#include "core/output/loads/mean_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/base/random.h"

namespace nilas::output {
namespace mean_error_test {

/// x_k+1 = phi x_k + noise of variance 1, from its stationary state.
std::vector<double> autoregressive(double phi, int n, std::uint64_t seed) {
  RandomStream random(seed, "series");
  std::vector<double> series{random.normal() / std::sqrt(1 - phi * phi)};
  while (static_cast<int>(series.size()) < n) series.push_back(phi * series.back() + random.normal());
  return series;
}

double mean(const std::vector<double>& x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

TEST(MeanError, OfACorrelatedSeriesIsThatOfItsCorrelation) {
  constexpr int k_steps = 10000, k_series = 300;
  for (const double phi : {0.0, 0.9, 0.95}) {
    const double known = 1 / (1 - phi) / std::sqrt(k_steps);  // of long records
    double sum = 0;
    int held = 0;
    for (int k = 0; k < k_series; ++k) {
      const auto series = autoregressive(phi, k_steps, static_cast<std::uint64_t>(k));
      const MeanError error = mean_error(series);
      sum += error.standard_error;
      held += std::abs(mean(series)) <= error.half_width();
    }
    // the least of three estimates lies below their mean
    EXPECT_GT(sum / k_series / known, 0.75) << phi;
    EXPECT_LT(sum / k_series / known, 1.0) << phi;
    EXPECT_GE(held, 0.88 * k_series) << phi;
  }
}

TEST(MeanError, OfAConstantAndOfASteadyRiseIsZero) {
  EXPECT_EQ(mean_error(std::vector<double>(1000, -14.1)).half_width(), 0);
  std::vector<double> ramp(1024);
  std::iota(ramp.begin(), ramp.end(), 0.0);
  EXPECT_EQ(mean_error(ramp).standard_error, 0);
}

/// A load that forgets itself within a tenth of the record, as in ice that breaks.
TEST(MeanError, OfASlowSeriesHoldsWhereThatOfAFastOneDoesNot) {
  constexpr int k_steps = 1000, k_series = 300;
  int slow_held = 0, fast_held = 0;
  for (int k = 0; k < k_series; ++k) {
    const auto series = autoregressive(0.97, k_steps, static_cast<std::uint64_t>(k));
    slow_held += std::abs(mean(series)) <= slow_mean_error(series).half_width();
    fast_held += std::abs(mean(series)) <= mean_error(series).half_width();
  }
  EXPECT_GE(slow_held, 0.85 * k_series);
  EXPECT_LE(fast_held, 0.75 * k_series) << "or one estimate would do";
}

TEST(MeanError, OfASlowSeriesIsThatAboutASteadyRise) {
  std::vector<double> ramp(1024);
  std::iota(ramp.begin(), ramp.end(), 0.0);
  EXPECT_NEAR(slow_mean_error(ramp).standard_error, 0, 1e-9);
  EXPECT_EQ(slow_mean_error(std::vector<double>(1000, -14.1)).half_width(), 0);
  // batches 1, -1, -1, 1 and again: no rise, squares 8 of 6 degrees of freedom
  const std::vector<double> waves{1, 1, -1, -1, -1, -1, 1, 1, 1, 1, -1, -1, -1, -1, 1, 1};
  EXPECT_NEAR(slow_mean_error(waves).standard_error, std::sqrt(8.0 / 6 / 8), 1e-12);
  EXPECT_EQ(slow_mean_error(waves).freedom, 6);
  EXPECT_EQ(slow_mean_error({1, 2, 3}).freedom, 0);
}

TEST(MeanError, TooFewValuesSayNothing) {
  EXPECT_EQ(mean_error({1, 2, 3}).freedom, 0);
  EXPECT_TRUE(std::isinf(mean_error({1, 2, 3}).half_width()));
  EXPECT_EQ(mean_error_of_runs({5}).freedom, 0);
}

TEST(MeanError, OfRunsIsTheTextbooks) {
  const MeanError error = mean_error_of_runs({1, 3});
  EXPECT_DOUBLE_EQ(error.standard_error, 1);
  EXPECT_NEAR(error.half_width(), 12.7062, 1e-4);
  EXPECT_NEAR(mean_error_of_runs({1, 2, 3, 4}).half_width(), 3.18245 * std::sqrt(5.0 / 3) / 2, 1e-4);
}

}  // namespace mean_error_test
}  // namespace nilas::output
