#pragma once
/// Functions of one variable with many components, cubic between knots, and their exact Fourier integrals.
#include <complex>
#include <optional>
#include <vector>

#include "core/base/math.h"

namespace nilas::hydro {

/// The cubic spline with continuous second derivative through given points. It is linear in the values, so sums and
/// mirror images of data give those of splines.
class PiecewiseCubic {
 public:
  PiecewiseCubic() = default;
  /// x: rising, at least 3 knots; values: one row per knot. At both ends the second derivative is zero, except that
  /// `first_slope` (of all components) replaces the condition at the first knot. Throws ContractError otherwise.
  PiecewiseCubic(std::vector<double> x, MatX values, std::optional<double> first_slope = std::nullopt);

  const std::vector<double>& knots() const { return x_; }
  const MatX& values() const { return value_; }
  const MatX& slopes() const { return slope_; }
  /// The components at x, which must lie between the first and the last knot.
  VecX operator()(double x) const;
  /// The integral of f(x) exp(i t x) over all knots, exact to rounding for any t: real part for cosine, imaginary part
  /// for sine. Moments of x^k exp(i theta x) come from their recursion for |theta| > 1, from their series otherwise.
  Eigen::VectorXcd fourier(double t) const;
  /// The integral of f from the first knot to each knot, one row per knot.
  MatX integrals() const;

 private:
  std::vector<double> x_;
  MatX value_, slope_;
};

}  // namespace nilas::hydro
