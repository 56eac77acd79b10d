#include "fracture/bend/wedge_series.h"

#include <Eigen/Dense>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "core/base/error.h"

namespace nilas::fracture {

namespace {

/// The values w, w', w'', w''' at one point.
using Jet = Eigen::Vector4d;

constexpr double k_far = 20;  ///< Place where the growing solutions are removed, in l.

/// The product r (r-1) ... (r-k+1), and its derivative with respect to r.
struct Falling {
  double value = 1, slope = 0;
  explicit Falling(double r, int k) {
    for (int j = 0; j < k; ++j) {
      slope = slope * (r - j) + value;
      value *= r - j;
    }
  }
};

/// The sum of c_m x^(r + 4m), with c_0 = 1 and c_m = -c_(m-1) / (p (p-1)^2 (p-2)), p = r + 4m. It solves
/// (x w'')'' + x w = 0 where the root r is 0, 1 or 2. For r = 3 and r = 4, (x w'')'' + x w is 12 and 72 x. With
/// `logarithm` it is the derivative with respect to r, which at the double root 1 is the second solution.
Jet series(int root, bool logarithm, double x) {
  Jet sum = Jet::Zero();
  double c = 1, c_slope = 0;  // d ln c / dr
  for (int m = 0; m < 60; ++m) {
    const double p = root + 4 * m;
    if (m > 0) {
      c /= -p * (p - 1) * (p - 1) * (p - 2);
      c_slope -= 1 / p + 2 / (p - 1) + 1 / (p - 2);
    }
    Jet term;
    for (int k = 0; k < 4; ++k) {
      const Falling f(p, k);
      const double rise = logarithm ? f.value * (std::log(x) + c_slope) + f.slope : f.value;
      term(k) = rise == 0 ? 0 : c * rise * std::pow(x, p - k);
    }
    sum += term;
    if (term.cwiseAbs().maxCoeff() < 1e-17 * sum.cwiseAbs().maxCoeff()) break;
  }
  return sum;
}

/// The two solutions that vanish at infinity. Each member holds the shares of the series of the roots 0 and 1 that are
/// added to the series of the root 2, or to the one with the logarithm.
struct Decaying {
  Eigen::Vector2d with_square, with_logarithm;
};

const Decaying& decaying() {
  static const Decaying shares = [] {
    Eigen::Matrix2d regular;
    regular << series(0, false, k_far).head<2>(), series(1, false, k_far).head<2>();
    const auto lu = regular.fullPivLu();
    return Decaying{lu.solve(-series(2, false, k_far).head<2>()), lu.solve(-series(1, true, k_far).head<2>())};
  }();
  return shares;
}

/// The solution for one load, as shares of the series.
class Wedge {
 public:
  Wedge(TipLoad load, double a) : load_(load), a_(a) {
    if (a == 0) {
      outer_ = {0.5, 0};  // the tip's shear (x w'')' = 1 is the load
      return;
    }
    Eigen::Matrix4d join;
    join << series(0, false, a), series(1, false, a), -square(a), -logarithmic(a);
    const Jet orders(1, a, a * a, a * a * a);  // scales the rows alike for short loads
    const Eigen::Vector4d shares = (orders.asDiagonal() * join).fullPivLu().solve(-orders.cwiseProduct(particular(a)));
    inner_ = shares.head<2>();
    outer_ = shares.tail<2>();
  }
  Jet at(double x) const {
    if (x < a_) return inner_(0) * series(0, false, x) + inner_(1) * series(1, false, x) + particular(x);
    return outer_(0) * square(x) + outer_(1) * logarithmic(x);
  }
  double tip() const {
    if (a_ == 0) return outer_(0) * decaying().with_square(0);
    return inner_(0);
  }

 private:
  static Jet square(double x) {
    const Eigen::Vector2d& s = decaying().with_square;
    return series(2, false, x) + s(0) * series(0, false, x) + s(1) * series(1, false, x);
  }
  static Jet logarithmic(double x) {
    const Eigen::Vector2d& s = decaying().with_logarithm;
    return series(1, true, x) + s(0) * series(0, false, x) + s(1) * series(1, false, x);
  }
  /// The particular solution, for q = 2 x / a^2 (pressure) or q = 1 / a (line load). It is zero at the tip, with its
  /// slope and curvature.
  Jet particular(double x) const {
    if (load_ == TipLoad::pressure) return series(4, false, x) / (36 * a_ * a_);
    return series(3, false, x) / (12 * a_);
  }

  TipLoad load_;
  double a_;
  Eigen::Vector2d inner_ = Eigen::Vector2d::Zero(), outer_;
};

/// The place of the largest curvature. It is beyond a load that is not longer than k_longest_tip_load.
double steepest(const Wedge& wedge, double a) {
  const auto growth = [&](double x) { return wedge.at(x)(3); };
  const double step = 0.25 * std::cbrt(a);
  double x = a;
  while (growth(x + step) > 0) x += step;
  std::uintmax_t steps = 60;
  const auto bracket =
      boost::math::tools::toms748_solve(growth, x, x + step, boost::math::tools::eps_tolerance<double>(48), steps);
  return 0.5 * (bracket.first + bracket.second);
}

}  // namespace

WedgeResponse solve_wedge(TipLoad load, double a) {
  NILAS_DEMAND(a >= 0 && a <= k_longest_tip_load);
  const Wedge wedge(load, a);
  // Under a point load the curvature falls from its limit 1 at the tip.
  if (a == 0) return {1, 0, wedge.tip()};
  const double x = steepest(wedge, a);
  return {wedge.at(x)(2), x, wedge.tip()};
}

std::vector<double> wedge_curvatures(TipLoad load, double a, const std::vector<double>& at) {
  NILAS_DEMAND(a > 0 && a <= k_longest_tip_load);
  const Wedge wedge(load, a);
  const double x_max = steepest(wedge, a), largest = wedge.at(x_max)(2);
  std::vector<double> shares;
  for (const double x : at) shares.push_back(wedge.at(x * x_max)(2) / largest);
  return shares;
}

}  // namespace nilas::fracture
