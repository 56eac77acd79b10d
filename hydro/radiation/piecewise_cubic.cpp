#include "hydro/radiation/piecewise_cubic.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/error.h"

namespace nilas::hydro {

namespace {

using Complex = std::complex<double>;

/// A cubic on [0, 1] is v0 h[0] + v1 h[1] + L s0 h[2] + L s1 h[3]; rows: coefficients of 1, u, u^2, u^3.
constexpr int k_cubic = 4;
constexpr std::array<std::array<double, k_cubic>, k_cubic> k_hermite{
    {{1, 0, -3, 2}, {0, 0, 3, -2}, {0, 1, -2, 1}, {0, 0, -1, 1}}};

/// The integrals of u^k exp(i theta u) over [0, 1] for k = 0 ... 3.
std::array<Complex, k_cubic> moments(double theta) {
  std::array<Complex, k_cubic> m{};
  const Complex i_theta(0, theta);
  if (std::abs(theta) > 1) {
    const Complex end = std::exp(i_theta);
    m[0] = (end - 1.0) / i_theta;
    for (int k = 1; k < k_cubic; ++k) m[k] = (end - static_cast<double>(k) * m[k - 1]) / i_theta;
    return m;
  }
  // The terms fall faster than 1/n!; what is left out is below rounding.
  constexpr int k_terms = 20;
  constexpr double k_below_rounding = 1e-17;
  static const auto inverse = [] {
    std::array<double, k_terms + k_cubic> table{};
    for (std::size_t n = 0; n < table.size(); ++n) table[n] = 1 / static_cast<double>(n + 1);
    return table;
  }();
  Complex term = 1;
  for (int n = 0; n < k_terms && std::norm(term) > k_below_rounding * k_below_rounding; ++n) {
    for (int k = 0; k < k_cubic; ++k) m[k] += term * inverse[n + k];
    term = Complex(-theta * term.imag(), theta * term.real()) * inverse[n];
  }
  return m;
}

/// Solves the tridiagonal system of the slopes in place of the right-hand sides [Thomas].
void solve_tridiagonal(const VecX& below, VecX diagonal, const VecX& above, MatX& rhs) {
  const auto n = rhs.rows();
  for (Eigen::Index k = 1; k < n; ++k) {
    const double factor = below[k] / diagonal[k - 1];
    diagonal[k] -= factor * above[k - 1];
    rhs.row(k) -= factor * rhs.row(k - 1);
  }
  rhs.row(n - 1) /= diagonal[n - 1];
  for (Eigen::Index k = n - 2; k >= 0; --k) rhs.row(k) = (rhs.row(k) - above[k] * rhs.row(k + 1)) / diagonal[k];
}

MatX spline_slopes(const std::vector<double>& x, const MatX& values, std::optional<double> first_slope) {
  // A slope of three is that of the parabola-free end condition f'' = 0: 2 s0 + s1 = 3 (v1 - v0) / L.
  constexpr double k_three = 3;
  const auto n = values.rows();
  MatX rhs(n, values.cols());
  VecX below = VecX::Zero(n), diagonal = VecX::Constant(n, 2), above = VecX::Zero(n);
  const auto secant = [&](Eigen::Index k) -> MatX { return (values.row(k + 1) - values.row(k)) / (x[k + 1] - x[k]); };
  above[0] = first_slope ? 0 : 1;
  if (first_slope)
    rhs.row(0).setConstant(2 * *first_slope);
  else
    rhs.row(0) = k_three * secant(0);
  for (Eigen::Index k = 1; k + 1 < n; ++k) {
    const double left = x[k] - x[k - 1], right = x[k + 1] - x[k];
    below[k] = right / (left + right);
    above[k] = left / (left + right);
    rhs.row(k) = k_three * (below[k] * secant(k - 1) + above[k] * secant(k));
  }
  below[n - 1] = 1;
  rhs.row(n - 1) = k_three * secant(n - 2);
  solve_tridiagonal(below, diagonal, above, rhs);
  return rhs;
}

}  // namespace

PiecewiseCubic::PiecewiseCubic(std::vector<double> x, MatX values, std::optional<double> first_slope)
    : x_(std::move(x)), value_(std::move(values)) {
  NILAS_DEMAND(x_.size() > 2 && value_.rows() == static_cast<Eigen::Index>(x_.size()));
  NILAS_DEMAND(std::adjacent_find(x_.begin(), x_.end(), [](double a, double b) { return !(a < b); }) == x_.end());
  slope_ = spline_slopes(x_, value_, first_slope);
}

VecX PiecewiseCubic::operator()(double x) const {
  NILAS_DEMAND(!x_.empty() && x >= x_.front() && x <= x_.back());
  const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const auto k = above - x_.begin() - 1;
  const double length = x_[k + 1] - x_[k], u = (x - x_[k]) / length;
  std::array<double, k_cubic> h{};
  for (int j = 0; j < k_cubic; ++j)
    h[j] = k_hermite[j][0] + u * (k_hermite[j][1] + u * (k_hermite[j][2] + u * k_hermite[j][3]));
  return (h[0] * value_.row(k) + h[1] * value_.row(k + 1) + length * (h[2] * slope_.row(k) + h[3] * slope_.row(k + 1)))
      .transpose();
}

Eigen::VectorXcd PiecewiseCubic::fourier(double t) const {
  const auto n = value_.rows();
  MatX on_values = MatX::Zero(n, 2), on_slopes = MatX::Zero(n, 2);
  const auto add = [](MatX& weights, Eigen::Index k, const Complex& weight) {
    weights(k, 0) += weight.real();
    weights(k, 1) += weight.imag();
  };
  for (Eigen::Index k = 0; k + 1 < n; ++k) {
    const double length = x_[k + 1] - x_[k];
    const auto m = moments(t * length);
    const Complex start = length * std::exp(Complex(0, t * x_[k]));
    std::array<Complex, k_cubic> h{};
    for (int j = 0; j < k_cubic; ++j) {
      for (int p = 0; p < k_cubic; ++p) h[j] += k_hermite[j][p] * m[p];
      h[j] *= start;
    }
    add(on_values, k, h[0]);
    add(on_values, k + 1, h[1]);
    add(on_slopes, k, length * h[2]);
    add(on_slopes, k + 1, length * h[3]);
  }
  const MatX both = value_.transpose() * on_values + slope_.transpose() * on_slopes;
  return both.col(0) + Complex(0, 1) * both.col(1);
}

MatX PiecewiseCubic::integrals() const {
  // The integrals of the four cubics are 1/2, 1/2, 1/12 and -1/12.
  constexpr double k_slope_share = 1.0 / 12;
  MatX sums = MatX::Zero(value_.rows(), value_.cols());
  for (Eigen::Index k = 0; k + 1 < value_.rows(); ++k) {
    const double length = x_[k + 1] - x_[k];
    sums.row(k + 1) = sums.row(k) + 0.5 * length * (value_.row(k) + value_.row(k + 1)) +
                      k_slope_share * length * length * (slope_.row(k) - slope_.row(k + 1));
  }
  return sums;
}

}  // namespace nilas::hydro
