#pragma once
/// Tables of smooth functions.
#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>
#include <vector>

namespace nilas::fracture {

/// A cubic spline, twice continuously differentiable.
using TableSpline = boost::math::interpolators::cardinal_cubic_b_spline<double>;

/// The derivative f'(x) from values at x, x + h ... x + 4 h, to the fourth order in h.
template <class Function>
double end_slope(const Function& f, double x, double h) {
  return (-25 * f(x) + 48 * f(x + h) - 36 * f(x + 2 * h) + 16 * f(x + 3 * h) - 3 * f(x + 4 * h)) / (12 * h);
}

/// The spline of f between `from` and `to`, with the given slope f'(from). f is evaluated nowhere else. The slope at
/// `to` is computed from f, since the spline's own estimate is of lower order.
template <class Function>
TableSpline tabulate(const Function& f, double from, double to, int intervals, double first_slope) {
  const double step = (to - from) / intervals;
  std::vector<double> values;
  for (int k = 0; k < intervals; ++k) values.push_back(f(from + k * step));
  values.push_back(f(to));
  return TableSpline(values.begin(), values.end(), from, step, first_slope, end_slope(f, to, -0.25 * step));
}
template <class Function>
TableSpline tabulate(const Function& f, double from, double to, int intervals) {
  return tabulate(f, from, to, intervals, end_slope(f, from, 0.25 * (to - from) / intervals));
}

}  // namespace nilas::fracture
