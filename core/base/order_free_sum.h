#pragma once
/// A sum whose bits depend neither on the order of its terms nor, but for the sign, on their common sign.
///
/// A fixed grid of units 2^(32 k) is laid over all numbers. Each term is cut into multiples of four neighbouring
/// units, which add without rounding; what is below the fourth is dropped: less than 2^-96 of the largest term each.
/// The units follow from the largest term so far, and a term small beside them cuts the same way whether the largest
/// came before or after it. Rounding to the nearest even multiple is symmetric, so mirrored terms give the mirrored
/// sum. The exact sum is rounded once: what is dropped decides in about one sum of 2^40. In all others, terms times
/// a power of two, as in a scene at another scale, give the sum times this power. Exact up to four million terms
/// between 1e-240 and 1e260; smaller ones are dropped, larger ones give NaN. Sources: Rump, Ogita, Oishi 2008
/// (extraction); Demmel, Nguyen 2015 (reproducible sums over a fixed grid).
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/math.h"

namespace nilas {

class OrderFreeSum {
 public:
  void add(double x) {
    if (!(std::abs(x) < limit_)) raise(x);
    const double high = (high_cut_ + x) - high_cut_, rest = x - high;
    const double middle = (middle_cut_ + rest) - middle_cut_;
    high_ += high;
    const double below = rest - middle, low = (low_cut_ + below) - low_cut_;
    middle_ += middle;
    low_ += low;
    lowest_ += (lowest_cut_ + (below - low)) - lowest_cut_;
  }

  double value() const {
    // Sums with their errors, from the least on: the rounding of a sum of parts would depend on the grid.
    const Rounded third = two_sum(low_, lowest_);
    const Rounded second = two_sum(middle_, third.sum), first = two_sum(high_, second.sum);
    return first.sum + (first.error + (second.error + third.error));
  }

 private:
  struct Rounded {
    double sum, error;
  };
  /// a + b as a rounded sum and its exact error [Knuth].
  static Rounded two_sum(double a, double b) {
    const double sum = a + b, of_b = sum - a, of_a = sum - of_b;
    return {sum, (a - of_a) + (b - of_b)};
  }

  static constexpr int k_width = 32;     ///< binary digits from unit to unit
  static constexpr int k_least = -26;    ///< place of the highest unit at first: 2^-832
  static constexpr int k_greatest = 27;  ///< 2^864

  static double power_of_two(int exponent) {
    constexpr int k_bias = std::numeric_limits<double>::max_exponent - 1;
    constexpr int k_shift = std::numeric_limits<double>::digits - 1;
    return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + k_bias) << k_shift);
  }
  /// 1.5 2^52 units: numbers this large are multiples of the unit, and both signs round alike.
  static double cut(int place) { return 1.5 * power_of_two(k_width * place + std::numeric_limits<double>::digits - 1); }

  /// Lifts the grid until x is below half of the unit above the highest one.
  void raise(double x) {
    const int exponent = x == 0 ? k_width * k_least : std::ilogb(x);
    if (!std::isfinite(x) || exponent >= k_width * k_greatest) {
      high_ = std::numeric_limits<double>::quiet_NaN();
      return;
    }
    int place = k_least;
    if (exponent >= k_width * k_least) place += (exponent + 1 - k_width * k_least) / k_width;
    const int steps = place - place_;
    if (steps > 0) {
      lowest_ = steps == 1 ? low_ : steps == 2 ? middle_ : steps == 3 ? high_ : 0;
      low_ = steps == 1 ? middle_ : steps == 2 ? high_ : 0;
      middle_ = steps == 1 ? high_ : 0;
      high_ = std::isnan(high_) ? high_ : 0;
    }
    place_ = place;
    limit_ = power_of_two(k_width * (place + 1) - 1);
    high_cut_ = cut(place);
    middle_cut_ = cut(place - 1);
    low_cut_ = cut(place - 2);
    lowest_cut_ = cut(place - 3);
  }

  int place_ = k_least;
  double limit_ = 0;
  double high_cut_ = 0, middle_cut_ = 0, low_cut_ = 0, lowest_cut_ = 0;
  double high_ = 0, middle_ = 0, low_ = 0, lowest_ = 0;
};

/// The same of vectors, coordinate by coordinate.
class OrderFreeVectorSum {
 public:
  void add(const Vec3& x) {
    x_.add(x.x());
    y_.add(x.y());
    z_.add(x.z());
  }
  Vec3 value() const { return {x_.value(), y_.value(), z_.value()}; }

 private:
  OrderFreeSum x_, y_, z_;
};

}  // namespace nilas
