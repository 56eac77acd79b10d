#include "fracture/bend/edge_load.h"

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "core/base/error.h"
#include "fracture/bend/edge_integral.h"

namespace nilas::fracture {

namespace {

constexpr double k_least = 1e-3, k_most = 10;  ///< Range of b/l in the tables.

/// The place u where S is largest.
double peak(const TableSpline& moment) {
  return boost::math::tools::brent_find_minima([&](double u) { return -moment(u); }, 0.3, 3.0, 40).first;
}

/// The place behind the peak where S'' changes its sign. It is the half length b/l of a load beyond which the stress at
/// the middle is no longer the largest.
double inflection(const TableSpline& moment, double from) {
  const auto curvature = [&](double u) { return moment.double_prime(u); };
  std::uintmax_t steps = 60;
  return boost::math::tools::toms748_solve(curvature, from, 3 * from, boost::math::tools::eps_tolerance<double>(40),
                                           steps)
      .first;
}

/// The largest 3 (S(b + y) + S(b - y)) / b away from the middle of the load.
double split_factor(const TableSpline& moment, double b, double peak_at) {
  const auto lack = [&](double y) { return -(moment(b + y) + moment(b - y)); };
  return -3 / b * boost::math::tools::brent_find_minima(lack, 0.0, b - 0.9 * peak_at, 40).second;
}

}  // namespace

EdgeLoad::EdgeLoad(double nu) {
  const EdgeIntegral integral(nu);
  log_slope_ = integral.log_slope();
  deflection_ = integral.deflection();
  near_factor_ = 6 * integral.moment(k_least) / k_least;
  const TableSpline moment = tabulate([&](double u) { return integral.moment(u); }, 0.25, 2 * k_most + 0.25, 1000);
  const double peak_at = peak(moment);
  widest_centred_ = inflection(moment, peak_at);
  centred_ = tabulate(
      [&](double t) {
        const double b = std::exp(t);
        return 6 * integral.moment(b) / b;
      },
      std::log(k_least), std::log(widest_centred_), 256);
  split_ = tabulate([&](double t) { return split_factor(moment, std::exp(t), peak_at); }, std::log(widest_centred_),
                    std::log(k_most), 256);
  far_factor_ = split_(std::log(k_most));
}

double EdgeLoad::stress_factor(double b_over_l) const {
  NILAS_DEMAND(b_over_l > 0);
  if (b_over_l <= k_least) return near_factor_ - log_slope_ * std::log(b_over_l / k_least);
  if (b_over_l >= k_most) return far_factor_ * k_most / b_over_l;
  const double t = std::log(b_over_l);
  return b_over_l <= widest_centred_ ? centred_(t) : split_(t);
}

double radial_crack_load(const EdgeLoad& edge, double b, double l, double thickness, double flexural_strength) {
  NILAS_DEMAND(l > 0 && thickness > 0 && flexural_strength > 0);
  return flexural_strength * thickness * thickness / edge.stress_factor(b / l);
}

}  // namespace nilas::fracture
