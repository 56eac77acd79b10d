#include "fracture/split/splitting_lefm.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "core/base/error.h"
#include "core/base/math.h"
#include "fracture/split/splitting_table.h"

namespace nilas::fracture {

namespace {

constexpr double k_longest = splitting_table::longest, k_widest = splitting_table::widest;

/// The k-th of n + 1 Chebyshev points on [-1, 1], in ascending order.
double chebyshev_point(int n, int k) { return -std::cos(k * k_pi / n); }

/// The weights of the values at the Chebyshev points in the polynomial's value at t, by the barycentric formula (Berrut
/// and Trefethen 2004). `Points` is the number of points.
template <int Points>
Eigen::Matrix<double, Points, 1> shares(double t) {
  static const auto points = [] {
    Eigen::Matrix<double, Points, 1> p;
    for (int k = 0; k < Points; ++k) p(k) = chebyshev_point(Points - 1, k);
    return p;
  }();
  Eigen::Matrix<double, Points, 1> out;
  for (int k = 0; k < Points; ++k) {
    if (t == points(k)) return Eigen::Matrix<double, Points, 1>::Unit(k);
    out(k) = (k % 2 ? -1.0 : 1.0) * (k == 0 || k == Points - 1 ? 0.5 : 1.0) / (t - points(k));
  }
  return out / out.sum();
}

/// The factor of H that the table leaves out.
double outer_shape(double crack) { return 1 / (std::sqrt(crack) * std::pow(1 - crack, 1.5)); }

/// H sqrt(A/L) of a half-plane. It follows from M = A J about the mouth (Budiansky and Rice 1973), with the radial
/// stress of two quarter-planes that are loaded at their corners (docs/theory/fracture.md).
double half_plane() { return 2 * std::sqrt(k_pi / (k_pi * k_pi - 4)); }

void check(const SplittingFloe& floe, double A) {
  NILAS_DEMAND(floe.length > 0 && floe.width > 0 && floe.thickness > 0 && floe.toughness > 0);
  NILAS_DEMAND(A > 0 && A < floe.length);
}

double shape(const SplittingTable& table, const SplittingFloe& floe, double A) {
  return table.H(A / floe.length, floe.width / floe.length);
}

/// The force F_Y at K = K_IC [N].
double critical_force(const SplittingFloe& floe, double H) {
  return floe.toughness * floe.thickness * std::sqrt(floe.length) / H;
}

}  // namespace

SplittingTable::SplittingTable() {
  log_shape_.row(0).setConstant(std::log(half_plane()));
  for (int j = 0; j < widths; ++j)
    for (int i = 1; i < cracks; ++i) log_shape_(i, j) = std::log(splitting_table::shape[j][i - 1]);
  const double most = std::log(k_widest);
  const auto search = [this](double t) {
    const auto shape = [&](double crack) { return H(crack, std::exp(t)); };
    return boost::math::tools::brent_find_minima(shape, 1e-3, 0.5, 50);
  };
  least_crack_ = tabulate([&](double t) { return search(t).first; }, -most, most, 96);
  least_H_ = tabulate([&](double t) { return search(t).second; }, -most, most, 96);
}

/// ln(W/L), limited to the range of the table.
static double clamped_log(double width) {
  NILAS_DEMAND(width > 0);
  return std::clamp(std::log(width), -std::log(k_widest), std::log(k_widest));
}

SplittingTable::WidthShares SplittingTable::width_shares(double width) {
  return shares<widths>(clamped_log(width) / std::log(k_widest));
}

double SplittingTable::H(double crack, double width) const {
  NILAS_DEMAND(crack > 0 && crack < 1);
  const double t = 2 * std::min(crack / k_longest, 1.0) - 1;
  const auto along = shares<cracks>(t);
  return std::exp(along.dot(log_shape_ * width_shares(width))) * outer_shape(crack);
}

SplittingTable::Least SplittingTable::least(double width) const {
  const double t = clamped_log(width);
  return {least_crack_(t), least_H_(t)};
}

double stress_intensity(const SplittingTable& table, const SplittingFloe& floe, double F_Y, double A) {
  check(floe, A);
  return F_Y * shape(table, floe, A) / (floe.thickness * std::sqrt(floe.length));
}

double growth_force(const SplittingTable& table, const SplittingFloe& floe, double A) {
  check(floe, A);
  return critical_force(floe, shape(table, floe, A));
}

double splitting_force(const SplittingTable& table, const SplittingFloe& floe, double A0) {
  check(floe, A0);
  const SplittingTable::Least least = table.least(floe.width / floe.length);
  return critical_force(floe, A0 <= least.crack * floe.length ? least.H : shape(table, floe, A0));
}

/// The ratio F_X / F_Y of a symmetric wedge.
static double wedge_ratio(double psi, double mu) {
  NILAS_DEMAND(psi > 0 && psi < k_pi / 2 && mu >= 0 && mu * std::tan(psi) < 1);
  return 2 * (std::tan(psi) + mu) / (1 - mu * std::tan(psi));
}

double wedge_force(double F_Y, double psi, double mu) { return F_Y * wedge_ratio(psi, mu); }
double opening_force(double F_X, double psi, double mu) { return F_X / wedge_ratio(psi, mu); }

}  // namespace nilas::fracture
