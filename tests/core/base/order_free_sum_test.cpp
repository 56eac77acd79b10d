/// Sums whose bits depend on the terms alone.
#include "core/base/order_free_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/random.h"

namespace nilas {
namespace order_free_sum_test {

double sum_of(const std::vector<double>& terms, double sign) {
  OrderFreeSum sum;
  for (const double x : terms) sum.add(sign * x);
  return sum.value();
}

void shuffle(std::vector<double>& terms, RandomStream& random) {
  for (std::size_t k = terms.size(); k > 1; --k) std::swap(terms[k - 1], terms[random.bits() % k]);
}

TEST(OrderFreeSum, HasTheSameBitsInAnyOrderAndForTheNegative) {
  RandomStream random(3, "sum");
  // ranges of binary exponents: within one unit of the grid, over two, over many
  for (const int range : {4, 60, 400}) {
    std::vector<double> terms;
    for (int k = 0; k < 1000; ++k)
      terms.push_back(
          std::ldexp(random.normal(), static_cast<int>(random.bits() % static_cast<unsigned>(range)) - range / 2));
    double largest = 0;
    long double exact = 0;
    for (const double x : terms) {
      largest = std::max(largest, std::abs(x));
      exact += x;
    }
    const double first = sum_of(terms, 1);
    EXPECT_NEAR(first, static_cast<double>(exact), 1e-15 * largest);
    for (int k = 0; k < 50; ++k) {
      shuffle(terms, random);
      EXPECT_EQ(sum_of(terms, 1), first);
      EXPECT_EQ(sum_of(terms, -1), -first);
    }
  }
}

/// Just below and above the places where the grid is raised, a late largest term must cut the others as an early one.
TEST(OrderFreeSum, DoesNotShowWhenTheLargestCame) {
  for (int exponent = -70; exponent <= 70; ++exponent)
    for (const double share : {1.0, 1 - 0x1p-53, 1 + 0x1p-52, 1.2345678912345678}) {
      const double x = std::ldexp(share, exponent);
      std::vector<double> terms{x, 1.0, -x / 3, 0x1p-40};
      std::sort(terms.begin(), terms.end());
      const double first = sum_of(terms, 1);
      do EXPECT_EQ(sum_of(terms, 1), first);
      while (std::next_permutation(terms.begin(), terms.end()));
    }
}

/// A scene at another scale has its terms times a power of two, which moves them against the grid. 1000 terms over 2^30
/// keep all their bits above 2^-96 of the largest but for a few of the smallest.
TEST(OrderFreeSum, OfTermsTimesAPowerOfTwoIsTheSumTimesThatPower) {
  RandomStream random(7, "power");
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> terms;
    for (int k = 0; k < 1000; ++k) terms.push_back(std::ldexp(random.normal(), static_cast<int>(random.bits() % 30)));
    const double first = sum_of(terms, 1);
    for (const int power : {2, 12, 16, 20, -12})
      EXPECT_EQ(sum_of(terms, std::ldexp(1, power)), std::ldexp(first, power));
  }
}

TEST(OrderFreeSum, CancelsWhatIsItsOwnImage) {
  RandomStream random(5, "image");
  std::vector<double> terms;
  for (int k = 0; k < 300; ++k) {
    const double x = std::ldexp(random.normal(), static_cast<int>(random.bits() % 80) - 40);
    terms.push_back(x);
    terms.push_back(-x);
  }
  shuffle(terms, random);
  EXPECT_EQ(sum_of(terms, 1), 0);
}

TEST(OrderFreeSum, OfNothingAndOfTheExtremes) {
  EXPECT_EQ(sum_of({}, 1), 0);
  EXPECT_EQ(sum_of({0, 0}, 1), 0);
  EXPECT_EQ(sum_of({1e260, -1e-200}, 1), 1e260);
  for (const double x : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(std::isnan(sum_of({x}, 1)));
    EXPECT_TRUE(std::isnan(sum_of({1.0, x, 1e200}, 1)));
  }
}

}  // namespace order_free_sum_test
}  // namespace nilas
