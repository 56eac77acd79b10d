#include "hydro/radiation/passive_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/error.h"
#include "core/base/random.h"
#include "hydro/radiation/vector_fit.h"

namespace nilas::hydro {

namespace {

/// Frequencies of the fit: evenly spaced up to the highest with damping, then a tail with little.
constexpr int k_even_samples = 200, k_tail_samples = 11;
constexpr double k_tail_reach = 3;
constexpr int k_most_iterations = 60, k_most_trials = 12;
constexpr double k_first_damping = 1e-2, k_more_damping = 4, k_less_damping = 0.2, k_converged = 1e-6;
/// Size of the first guess of the scaled spectral factor, whose damping has the peak 1.
constexpr double k_first_size = 0.3;
constexpr int k_matrix_rows = 6;

std::vector<double> fit_frequencies(const RadiationDamping& damping) {
  std::vector<double> w;
  for (int k = 1; k <= k_even_samples; ++k) w.push_back(damping.high_frequency * k / k_even_samples);
  for (int k = 1; k <= k_tail_samples; ++k)
    w.push_back(damping.high_frequency * std::pow(k_tail_reach, static_cast<double>(k) / k_tail_samples));
  return w;
}

/// The samples of some modes.
FrequencySamples samples_of(const RadiationSamples& all, const std::vector<int>& modes) {
  FrequencySamples samples{all.frequency, {}, all.weight};
  const auto m = static_cast<Eigen::Index>(modes.size());
  for (Eigen::Index k = 0; k < all.value.rows(); ++k) {
    MatXc& part = samples.value.emplace_back(m, m);
    for (Eigen::Index i = 0; i < m; ++i)
      for (Eigen::Index j = 0; j < m; ++j) part(i, j) = all.value(k, modes[i] + k_matrix_rows * modes[j]);
  }
  return samples;
}

/// The spectral factor as W(i w) = sum_j F(w, j) phi_j with real m x m matrices phi_j.
class SpectralFactor {
 public:
  SpectralFactor(const FrequencySamples& samples, const Poles& poles)
      : poles_(poles), m_(samples.value.front().rows()), weight_(samples.weight) {
    const auto rows = static_cast<Eigen::Index>(samples.frequency.size());
    const Eigen::Index n = poles.count();
    MatXc fractions(rows, n);
    for (Eigen::Index l = 0; l < rows; ++l)
      fractions.row(l) = partial_fractions(poles, std::complex<double>(0, samples.frequency[l]));
    // Combinations that vanish at s = 0: the complement of the row of fractions there.
    const VecX at_zero = partial_fractions(poles, 0.0).real().transpose();
    const MatX q = Eigen::HouseholderQR<MatX>(at_zero).householderQ();
    MatX combination = q.rightCols(n - 1);
    // Their sizes and angles over the samples are made equal, which conditions the least squares.
    MatX both(2 * rows, n - 1);
    both << weight_.asDiagonal() * (fractions * combination).real(),
        weight_.asDiagonal() * (fractions * combination).imag();
    const Eigen::HouseholderQR<MatX> qr(both);
    const MatX R = qr.matrixQR().topRows(n - 1).triangularView<Eigen::Upper>();
    combination = R.triangularView<Eigen::Upper>().solve<Eigen::OnTheRight>(combination);
    F_ = fractions * combination;
    const double size = F_.cwiseAbs().maxCoeff();
    F_ /= size;
    combination_ = combination / size;
    for (Eigen::Index i = 0; i < m_; ++i)
      for (Eigen::Index j = i; j < m_; ++j) entries_.emplace_back(i, j);
    target_ = VecX(rows * static_cast<Eigen::Index>(entries_.size()));
    for (Eigen::Index l = 0; l < rows; ++l)
      for (std::size_t e = 0; e < entries_.size(); ++e)
        target_[row_of(l, e)] = weight_of(l, e) * samples.value[l](entries_[e].first, entries_[e].second).real();
  }

  Eigen::Index unknowns() const { return F_.cols() * m_ * m_; }
  const VecX& target() const { return target_; }

  /// 0.5 |W|^2 - B, weighted, and its derivatives with respect to phi where `jacobian` is given.
  VecX residual(const VecX& phi, MatX* jacobian = nullptr) const {
    VecX out(target_.size());
    for (Eigen::Index l = 0; l < F_.rows(); ++l) {
      const MatXc W = factor(phi, l);
      const MatX damping = 0.5 * (W.adjoint() * W).real();
      for (std::size_t e = 0; e < entries_.size(); ++e)
        out[row_of(l, e)] = weight_of(l, e) * damping(entries_[e].first, entries_[e].second) - target_[row_of(l, e)];
      if (jacobian) derive(W, l, *jacobian);
    }
    return out;
  }

  /// The coefficients of the partial fractions of W, one matrix per fraction.
  std::vector<MatX> coefficients(const VecX& phi) const {
    std::vector<MatX> out(poles_.count(), MatX::Zero(m_, m_));
    for (Eigen::Index c = 0; c < combination_.rows(); ++c)
      for (Eigen::Index j = 0; j < combination_.cols(); ++j) out[c] += combination_(c, j) * part(phi, j);
    return out;
  }

 private:
  Eigen::Index row_of(Eigen::Index l, std::size_t e) const {
    return l * static_cast<Eigen::Index>(entries_.size()) + static_cast<Eigen::Index>(e);
  }
  /// An entry off the diagonal stands for two.
  double weight_of(Eigen::Index l, std::size_t e) const {
    return weight_[l] * (entries_[e].first == entries_[e].second ? 1 : std::sqrt(2.0));
  }
  Eigen::Map<const MatX> part(const VecX& phi, Eigen::Index j) const {
    return Eigen::Map<const MatX>(phi.data() + j * m_ * m_, m_, m_);
  }
  MatXc factor(const VecX& phi, Eigen::Index l) const {
    MatXc W = MatXc::Zero(m_, m_);
    for (Eigen::Index j = 0; j < F_.cols(); ++j) W += F_(l, j) * part(phi, j);
    return W;
  }
  void derive(const MatXc& W, Eigen::Index l, MatX& jacobian) const {
    for (std::size_t e = 0; e < entries_.size(); ++e) {
      const auto [x, y] = entries_[e];
      const Eigen::Index row = row_of(l, e);
      for (Eigen::Index j = 0; j < F_.cols(); ++j)
        for (Eigen::Index a = 0; a < m_; ++a) {
          const Eigen::Index column = j * m_ * m_ + a;
          jacobian(row, column + x * m_) += 0.5 * weight_of(l, e) * (std::conj(F_(l, j)) * W(a, y)).real();
          jacobian(row, column + y * m_) += 0.5 * weight_of(l, e) * (std::conj(F_(l, j)) * W(a, x)).real();
        }
    }
  }

  Poles poles_;
  Eigen::Index m_;
  VecX weight_;
  MatXc F_;
  MatX combination_;
  std::vector<std::pair<Eigen::Index, Eigen::Index>> entries_;
  VecX target_;
};

VecX first_guess(Eigen::Index size) {
  RandomStream random(0, "first guess of a spectral factor");
  VecX phi(size);
  for (double& x : phi) x = k_first_size * random.normal();
  return phi;
}

/// Levenberg-Marquardt from a first guess that is the same in every run.
VecX least_squares(const SpectralFactor& factor) {
  VecX phi = first_guess(factor.unknowns());
  double damping = k_first_damping;
  for (int iteration = 0; iteration < k_most_iterations; ++iteration) {
    MatX J = MatX::Zero(factor.target().size(), factor.unknowns());
    const VecX e = factor.residual(phi, &J);
    const MatX JJ = J.transpose() * J;
    const VecX g = J.transpose() * e;
    const double before = e.squaredNorm();
    double after = before;
    for (int trial = 0; trial < k_most_trials && !(after < before); ++trial) {
      MatX damped = JJ;
      damped.diagonal() += damping * (JJ.diagonal().array() + std::numeric_limits<double>::epsilon()).matrix();
      const VecX next = phi - damped.ldlt().solve(g);
      const double squares = factor.residual(next).squaredNorm();
      if (squares < before) {
        phi = next;
        after = squares;
        damping *= k_less_damping;
      } else {
        damping *= k_more_damping;
      }
    }
    if (!(before - after > k_converged * before)) break;
  }
  return phi;
}

/// H(s) of H(s) + H(-s)^T = W(-s)^T W(s): the residue at p is W(-p)^T times the residue of W.
std::vector<MatXc> residues_of_model(const Poles& poles, const std::vector<MatX>& coefficients) {
  std::vector<MatXc> of_factor = residues_of(poles, coefficients), out;
  const auto add = [&](std::complex<double> p) {
    const Eigen::RowVectorXcd fractions = partial_fractions(poles, -p);
    MatXc mirrored = MatXc::Zero(coefficients.front().rows(), coefficients.front().cols());
    for (std::size_t c = 0; c < coefficients.size(); ++c) mirrored += fractions[c] * coefficients[c];
    const MatXc residue = mirrored.transpose() * of_factor[out.size()];
    out.emplace_back(0.5 * (residue + residue.transpose()));
  };
  for (const double p : poles.real) add(p);
  for (const auto& p : poles.pair) add(p);
  return out;
}

/// Evenly spaced orders, ever fewer, of which a first one that is good enough is sought.
constexpr std::array k_orders{2, 3, 4, 5, 6, 8, 10, 12, 16, 20, k_most_poles};

}  // namespace

RadiationSamples radiation_samples(const RadiationDamping& damping, const Retardation& kernel) {
  RadiationSamples samples{fit_frequencies(damping), {}, {}, damping.peak_frequency};
  const auto& w = samples.frequency;
  const auto n = static_cast<Eigen::Index>(w.size());
  samples.weight.resize(n);
  samples.value.resize(n, k_matrix_rows * k_matrix_rows);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double below = k > 0 ? w[k - 1] : 0, above = k + 1 < n ? w[k + 1] : w[k];
    samples.weight[k] = std::sqrt(0.5 * (above - below));
    samples.value.row(k).real() = damping.scaled(w[k]).transpose();
    samples.value.row(k).imag() = -kernel.scaled.fourier(w[k]).imag().transpose();
  }
  return samples;
}

PassiveFit passive_fit(const RadiationSamples& samples, const std::vector<int>& modes, int order) {
  NILAS_DEMAND(order > 1 && order <= k_most_poles && !modes.empty());
  const FrequencySamples of_modes = samples_of(samples, modes);
  PassiveFit out;
  out.model.modes = modes;
  out.model.poles = fit_poles(of_modes, order, samples.peak);
  const SpectralFactor factor(of_modes, out.model.poles);
  const VecX phi = least_squares(factor);
  out.model.residues = residues_of_model(out.model.poles, factor.coefficients(phi));
  out.error = std::sqrt(factor.residual(phi).squaredNorm() / factor.target().squaredNorm());
  return out;
}

PassiveFit chosen_fit(const RadiationSamples& samples, const std::vector<int>& modes, double error,
                      std::optional<int> order) {
  if (order) return passive_fit(samples, modes, *order);
  std::optional<PassiveFit> best;
  for (const int poles : k_orders) {
    PassiveFit fit = passive_fit(samples, modes, poles);
    if (!best || fit.error < best->error) best = std::move(fit);
    if (best->error < error) return *best;
  }
  throw InputError(
      fmt::format("a state space with up to {} poles fits the radiation with an error of {:.2g} only; "
                  "allowed: a larger error, a lower highest frequency, or the convolution",
                  k_most_poles, best->error));
}

}  // namespace nilas::hydro
