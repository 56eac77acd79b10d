#include "hydro/radiation/vector_fit.h"

#include <algorithm>

namespace nilas::hydro {

namespace {

constexpr int k_relocations = 20;
/// The first poles lie at these multiples of the peak, with the damping ratio that Gustavsen & Semlyen advise for
/// smooth functions.
constexpr double k_lowest_start = 0.25, k_highest_start = 3, k_start_damping = 0.1;
/// Below this the bracket's constant d is held, and poles this close to the real axis are real.
constexpr double k_least_constant = 1e-8, k_real_pole = 1e-12;

Poles first_poles(int count, double peak) {
  Poles poles;
  const int pairs = count / 2;
  for (int k = 0; k < pairs; ++k) {
    const double share = pairs > 1 ? static_cast<double>(k) / (pairs - 1) : 0.5;
    const double w = peak * k_lowest_start * std::pow(k_highest_start / k_lowest_start, share);
    poles.pair.emplace_back(-k_start_damping * w, w);
  }
  if (count % 2 == 1) poles.real.push_back(-peak);
  return poles;
}

/// The zeros of d + sum c_k / (s - a_k), mirrored into the left half plane.
Poles zeros_of(const Poles& poles, const VecX& c, double d) {
  const Eigen::Index n = poles.count();
  MatX A = MatX::Zero(n, n);
  VecX b = VecX::Ones(n);
  Eigen::Index at = 0;
  for (const double p : poles.real) {
    A(at, at) = p;
    ++at;
  }
  for (const auto& p : poles.pair) {
    A.block<2, 2>(at, at) << p.real(), p.imag(), -p.imag(), p.real();
    b.segment<2>(at) << 2, 0;
    at += 2;
  }
  const Eigen::EigenSolver<MatX> solver(A - b * c.transpose() / d, false);
  Poles out;
  for (const std::complex<double>& zero : solver.eigenvalues()) {
    const double decay = -std::abs(zero.real());
    if (std::abs(zero.imag()) < k_real_pole * std::abs(zero))
      out.real.push_back(decay);
    else if (zero.imag() > 0)
      out.pair.emplace_back(decay, zero.imag());
  }
  std::sort(out.real.begin(), out.real.end());
  std::sort(out.pair.begin(), out.pair.end(), [](const auto& p, const auto& q) { return p.imag() < q.imag(); });
  return out;
}

/// Stacks real over imaginary parts.
MatX stacked(const MatXc& rows) {
  MatX both(2 * rows.rows(), rows.cols());
  both << rows.real(), rows.imag();
  return both;
}

/// The upper triangle that a QR factorisation leaves of the last columns, after the first `skip` are eliminated.
MatX remaining_triangle(MatX rows, Eigen::Index skip) {
  const Eigen::HouseholderQR<Eigen::Ref<MatX>> qr(rows);
  const Eigen::Index n = rows.cols();
  return rows.block(skip, skip, n - skip, n - skip).triangularView<Eigen::Upper>();
}

Poles relocated(const FrequencySamples& samples, const Poles& poles) {
  const auto rows = static_cast<Eigen::Index>(samples.frequency.size());
  const Eigen::Index n = poles.count(), m = samples.value.front().rows();
  MatXc fractions(rows, n);
  for (Eigen::Index l = 0; l < rows; ++l)
    fractions.row(l) = partial_fractions(poles, std::complex<double>(0, samples.frequency[l]));
  const Eigen::Index entries = m * (m + 1) / 2;
  MatX system = MatX::Zero(entries * (n + 1) + 1, n + 1);
  double size = 0;
  Eigen::Index at = 0;
  for (Eigen::Index i = 0; i < m; ++i)
    for (Eigen::Index j = i; j < m; ++j) {
      Eigen::VectorXcd h(rows);
      for (Eigen::Index l = 0; l < rows; ++l) h[l] = samples.value[l](i, j);
      MatXc equations(rows, 2 * n + 1);
      equations << fractions, -(h.asDiagonal() * fractions), -h;
      system.middleRows(at, n + 1) = remaining_triangle(stacked(samples.weight.asDiagonal() * equations), n);
      size += samples.weight.cwiseProduct(h.cwiseAbs()).squaredNorm();
      at += n + 1;
    }
  // The relaxed normalisation, at the size of the other equations.
  const double scale = std::sqrt(size) / static_cast<double>(rows);
  system.row(at).head(n) = scale * fractions.real().colwise().sum();
  system(at, n) = scale * static_cast<double>(rows);
  VecX rhs = VecX::Zero(system.rows());
  rhs[at] = system(at, n);
  const VecX column_size = system.colwise().norm().cwiseMax(std::numeric_limits<double>::min());
  const VecX found = (system * column_size.cwiseInverse().asDiagonal()).colPivHouseholderQr().solve(rhs);
  const VecX x = found.cwiseQuotient(column_size);
  const double d = std::abs(x[n]) < k_least_constant ? k_least_constant : x[n];
  return zeros_of(poles, x.head(n), d);
}

}  // namespace

Poles fit_poles(const FrequencySamples& samples, int count, double peak) {
  Poles poles = first_poles(count, peak);
  for (int k = 0; k < k_relocations; ++k) poles = relocated(samples, poles);
  return poles;
}

}  // namespace nilas::hydro
