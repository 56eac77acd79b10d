#include "contact/solvers/newton/rounded_solve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/problem/row_of.h"

namespace nilas::solvers {

namespace {

/// Corrections below this share of the solution end the rounds.
constexpr double k_enough = 0x1p-66;
/// Digits kept of the largest component.
constexpr int k_binary_digits = 36;
/// Each round gains at least a digit, or the factors are no good.
constexpr double k_least_gain = 0.1;
constexpr int k_most_rounds = 30;

/// A number as the sum of two doubles.
struct TwoFold {
  double high = 0, low = 0;

  void add(double x) {
    const double sum = high + x, part = sum - high;
    low += (high - (sum - part)) + (x - part);
    high = sum;
  }
  void add_product(double a, const TwoFold& x) {
    const double product = a * x.high;
    add(product);
    low += std::fma(a, x.high, -product) + a * x.low;
  }
  void normalise() {
    const double sum = high + low;
    low -= sum - high;
    high = sum;
  }
};

/// b - K x, rounded once.
VecX remainder(const BlockRows& matrix, const VecX& b, const std::vector<TwoFold>& x) {
  VecX out(b.size());
  for (std::size_t i = 0; i + 1 < matrix.row_start.size(); ++i)
    for (int row = 0; row < 3; ++row) {
      const Eigen::Index place = contact::row_of(i) + row;
      TwoFold sum{b[place], 0};
      for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const TwoFold* const of_column = x.data() + 3 * static_cast<std::ptrdiff_t>(matrix.column[at]);
        for (int j = 0; j < 3; ++j) sum.add_product(-matrix.block[at](row, j), of_column[j]);
      }
      out[place] = sum.high + sum.low;
    }
  return out;
}

/// The nearest multiple of `unit`, a power of two.
double rounded(const TwoFold& x, double unit) {
  const double cut = 1.5 * 0x1p52 * unit;
  const double nearest = (cut + x.high) - cut, rest = (x.high - nearest) + x.low;
  if (rest > 0.5 * unit) return nearest + unit;
  return rest < -0.5 * unit ? nearest - unit : nearest;
}

}  // namespace

bool solve_rounded(const BlockRows& matrix, const BlockLu& factors, VecX& x) {
  const VecX b = x;
  std::vector<TwoFold> solution(static_cast<std::size_t>(b.size()));
  VecX correction = b;
  double last = std::numeric_limits<double>::infinity();
  for (int round = 0; round < k_most_rounds; ++round) {
    factors.solve(correction);
    double largest = 0;
    for (std::size_t i = 0; i < solution.size(); ++i) {
      solution[i].add(correction[static_cast<Eigen::Index>(i)]);
      solution[i].normalise();
      largest = std::max(largest, std::abs(solution[i].high));
    }
    const double change = correction.cwiseAbs().maxCoeff();
    if (!std::isfinite(largest)) return false;
    if (change <= k_enough * largest) {
      const double unit = largest > 0 ? std::ldexp(1.0, std::ilogb(largest) - k_binary_digits) : 1.0;
      for (std::size_t i = 0; i < solution.size(); ++i) x[static_cast<Eigen::Index>(i)] = rounded(solution[i], unit);
      return true;
    }
    if (change > k_least_gain * last) return false;
    last = change;
    correction = remainder(matrix, b, solution);
  }
  return false;
}

}  // namespace nilas::solvers
