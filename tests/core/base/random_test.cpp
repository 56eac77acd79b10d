#include "core/base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace nilas {
namespace random_test {

constexpr int k_samples = 200000;

struct Moments {
  double mean = 0, variance = 0, skewness = 0, kurtosis = 0;
};

template <class Draw>
Moments moments_of(const Draw& draw) {
  std::vector<double> x;
  for (int i = 0; i < k_samples; ++i) x.push_back(draw());
  Moments m;
  for (const double v : x) m.mean += v / k_samples;
  double third = 0, fourth = 0;
  for (const double v : x) {
    const double d = v - m.mean;
    m.variance += d * d / k_samples;
    third += d * d * d / k_samples;
    fourth += d * d * d * d / k_samples;
  }
  m.skewness = third / std::pow(m.variance, 1.5);
  m.kurtosis = fourth / (m.variance * m.variance);
  return m;
}

/// Five standard deviations of a mean of k_samples draws with standard deviation `sd`.
double allowed(double sd) { return 5 * sd / std::sqrt(k_samples); }

TEST(RandomStream, SameSeedAndNameGiveTheSameNumbers) {
  RandomStream a(42, "field"), b(42, "field");
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(a.bits(), b.bits());
}

TEST(RandomStream, OtherSeedsAndNamesGiveOthers) {
  std::set<std::uint64_t> seen;
  int drawn = 0;
  for (const char* name : {"", "field", "fielc", "dleif", "thickness"})
    for (const std::uint64_t seed : {0ull, 1ull, 2ull, 42ull, ~0ull}) {
      RandomStream stream(seed, name);
      for (int i = 0; i < 100; ++i, ++drawn) seen.insert(stream.bits());
    }
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(drawn));
}

/// The numbers themselves are part of the contract: a scene must give the same field on every machine and version.
TEST(RandomStream, NumbersDoNotChangeBetweenVersions) {
  RandomStream stream(1, "reference");
  EXPECT_EQ(stream.bits(), 0xb19191600293c89eull);
  EXPECT_EQ(stream.bits(), 0x0fc8668e15fd6fc1ull);
  EXPECT_EQ(stream.uniform(), 0x1.fab4e9b3598b5p-1);
}

TEST(RandomStream, UniformHasTheRightMomentsAndStaysBelowOne) {
  RandomStream stream(3, "uniform");
  const Moments m = moments_of([&] {
    const double x = stream.uniform();
    EXPECT_TRUE(x >= 0 && x < 1);
    return x;
  });
  EXPECT_NEAR(m.mean, 0.5, allowed(std::sqrt(1.0 / 12)));
  EXPECT_NEAR(m.variance, 1.0 / 12, allowed(std::sqrt(1.0 / 180)));  // variance of (x - 1/2)^2 is 1/180
}

TEST(RandomStream, UniformFillsEveryBinAlike) {
  RandomStream stream(3, "bins");
  const int bins = 100;
  std::vector<int> count(bins, 0);
  for (int i = 0; i < k_samples; ++i) ++count[static_cast<std::size_t>(stream.uniform() * bins)];
  double chi2 = 0;
  const double expected = double{k_samples} / bins;
  for (const int c : count) chi2 += (c - expected) * (c - expected) / expected;
  // chi-square of 99 degrees: mean 99, standard deviation sqrt(198)
  EXPECT_NEAR(chi2, bins - 1, 5 * std::sqrt(2.0 * (bins - 1)));
}

TEST(RandomStream, UniformBetweenBounds) {
  RandomStream stream(4, "bounds");
  const Moments m = moments_of([&] {
    const double x = stream.uniform(-3, 5);
    EXPECT_TRUE(x >= -3 && x < 5);
    return x;
  });
  EXPECT_NEAR(m.mean, 1, allowed(8 / std::sqrt(12.0)));
}

TEST(RandomStream, NeighboursAreNotCorrelated) {
  RandomStream stream(5, "pairs");
  double sum = 0, before = stream.normal();
  for (int i = 0; i < k_samples; ++i) {
    const double x = stream.normal();
    sum += x * before;
    before = x;
  }
  EXPECT_NEAR(sum / k_samples, 0, allowed(1));
}

TEST(RandomStream, NormalHasTheRightMoments) {
  RandomStream stream(6, "normal");
  const Moments m = moments_of([&] { return stream.normal(); });
  EXPECT_NEAR(m.mean, 0, allowed(1));
  EXPECT_NEAR(m.variance, 1, allowed(std::sqrt(2.0)));
  EXPECT_NEAR(m.skewness, 0, allowed(std::sqrt(6.0)));
  EXPECT_NEAR(m.kurtosis, 3, allowed(std::sqrt(24.0)));
}

/// Mean and standard deviation are those of the variable, not of its logarithm; the logarithm is normal with
/// s^2 = ln(1 + sd^2/mean^2) about ln(mean) - s^2/2.
TEST(RandomStream, LognormalHasTheRightMoments) {
  RandomStream stream(7, "lognormal");
  const double mean = 12, sd = 5, s2 = std::log1p(sd * sd / (mean * mean));
  const Moments m = moments_of([&] { return stream.lognormal(mean, sd); });
  EXPECT_NEAR(m.mean, mean, allowed(sd));
  const double w = std::exp(s2), kurtosis = w * w * w * w + 2 * w * w * w + 3 * w * w - 3;
  EXPECT_NEAR(m.variance, sd * sd, allowed(sd * sd * std::sqrt(kurtosis - 1)));
  const Moments logs = moments_of([&] { return std::log(stream.lognormal(mean, sd)); });
  EXPECT_NEAR(logs.mean, std::log(mean) - s2 / 2, allowed(std::sqrt(s2)));
  EXPECT_NEAR(logs.variance, s2, allowed(s2 * std::sqrt(2.0)));
}

TEST(RandomStream, LognormalWithoutSpreadIsItsMean) {
  RandomStream stream(8, "constant");
  for (int i = 0; i < 10; ++i) EXPECT_DOUBLE_EQ(stream.lognormal(3, 0), 3);
}

}  // namespace random_test
}  // namespace nilas
