#pragma once
/// A sum whose bits depend neither on the order of its terms nor, but for the sign, on their common sign.
///
/// Each term is cut at two fixed places into multiples of a unit, small enough in number to add without rounding, and a
/// rest below 2^-90 of the largest term, which is dropped. The units follow from the largest term and the number of
/// terms alone. Rounding to the nearest even multiple is symmetric, so mirrored terms give the mirrored sum.
/// Sources: Rump, Ogita, Oishi 2008 (extraction); Demmel, Nguyen 2013 (reproducible sums).
#include <cmath>
#include <cstddef>
#include <limits>

namespace nilas {

class OrderFreeSum {
 public:
  /// `largest`: of the absolute terms; `count`: at least their number.
  OrderFreeSum(double largest, std::ptrdiff_t count) {
    if (!std::isfinite(largest)) {
      high_ = std::numeric_limits<double>::quiet_NaN();
    } else if (largest > 0) {
      const int spread = std::ilogb(static_cast<double>(count > 0 ? count : 1)) + 1 + k_room;
      const int exponent = std::ilogb(largest) + 1 + spread;
      high_cut_ = std::ldexp(k_middle, exponent);
      low_cut_ = std::ldexp(k_middle, exponent - k_digits + spread);
    }
  }

  void add(double x) {
    const double high = (high_cut_ + x) - high_cut_;
    high_ += high;
    low_ += (low_cut_ + (x - high)) - low_cut_;
  }

  double value() const { return high_ + low_; }

 private:
  static constexpr int k_digits = std::numeric_limits<double>::digits;  ///< 53
  static constexpr int k_room = 2;         ///< bits that keep cut + sum within one power of two
  static constexpr double k_middle = 1.5;  ///< of a power of two: both signs round at the same unit

  double high_cut_ = 0, low_cut_ = 0;
  double high_ = 0, low_ = 0;
};

}  // namespace nilas
