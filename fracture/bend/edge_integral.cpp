#include "fracture/bend/edge_integral.h"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/expint.hpp>
#include <cmath>

#include "core/base/error.h"
#include "core/base/math.h"

namespace nilas::fracture {

namespace {

using Rule = boost::math::quadrature::gauss<double, 16>;

/// The ends of the panels. They are fine enough for sin(20 a) up to a = 60, where the integrand without its slowly
/// decaying part has fallen below 1e-9. The growing panels beyond serve small u, for which it does not oscillate there.
std::vector<double> panel_ends() {
  std::vector<double> ends;
  for (double a = 0; a < 12; a += 0.5) ends.push_back(a);
  for (double a = 12; a < 60; a += 1) ends.push_back(a);
  for (double a = 60; a < 4000; a *= 1.25) ends.push_back(a);
  return ends;
}

/// Calls use(node, weight) for every node of the composite Gauss rule on the panels.
template <class Use>
void for_each_node(const Use& use) {
  const std::vector<double> ends = panel_ends();
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const double middle = 0.5 * (ends[k] + ends[k - 1]), half = 0.5 * (ends[k] - ends[k - 1]);
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      use(middle - half * Rule::abscissa()[i], half * Rule::weights()[i]);
      use(middle + half * Rule::abscissa()[i], half * Rule::weights()[i]);
    }
  }
}

/// The part of the integrand that decays slowly: 1/a^2 but for terms of the order a^-6 for large a.
double slow_part(double a) { return 4 / (3 * (a * a + 1)) - 1 / (3 * (a * a + 4)); }

/// int_0^inf sin(a u) / (a^2 + s^2) da, u > 0.
double sine_transform(double s, double u) {
  const double x = s * u;
  return (std::exp(-x) * boost::math::expint(x) + std::exp(x) * boost::math::expint(1, x)) / (2 * s);
}

}  // namespace

EdgeIntegral::EdgeIntegral(double nu) : nu_(nu) {
  NILAS_DEMAND(nu >= 0 && nu <= 0.5);
  const double slow = log_slope() * k_pi / 6;
  for_each_node([&](double a, double weight) {
    rest_.push_back({a, weight * ((1 - nu_ * nu_) * a * transfer(a) - slow * slow_part(a))});
  });
}

double EdgeIntegral::transfer(double a) const {
  const double s = (1 - nu_) * a * a;
  // m = sqrt(a^2 + i), with the imaginary part computed without cancellation.
  const double re = std::sqrt(0.5 * (std::hypot(a * a, 1) + a * a)), im = 0.5 / re;
  return 1 / (2 * s * re + (1 - s * s) * im);
}

double EdgeIntegral::log_slope() const { return 12 * (1 + nu_) / (k_pi * (3 + nu_)); }

double EdgeIntegral::moment(double u) const {
  if (u < 0) return -moment(-u);
  if (u == 0) return 0;
  double sum = 0;
  for (const Node& node : rest_) sum += node.weight * std::sin(node.a * u);
  const double slow = log_slope() * k_pi / 6;
  return (slow * (4 * sine_transform(1, u) - sine_transform(2, u)) / 3 + sum) / k_pi;
}

double EdgeIntegral::deflection() const {
  double sum = 0;
  for_each_node([&](double a, double weight) { sum += weight * transfer(a); });
  // The rest of the integral beyond the panels, where G = 2 / ((1 - nu) (3 + nu) a^3).
  const double end = panel_ends().back();
  return (sum + 1 / ((1 - nu_) * (3 + nu_) * end * end)) / k_pi;
}

}  // namespace nilas::fracture
