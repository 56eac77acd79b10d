#include "hydro/radiation/rational.h"

namespace nilas::hydro {

static constexpr std::complex<double> k_imaginary_unit(0, 1);

Eigen::RowVectorXcd partial_fractions(const Poles& poles, std::complex<double> s) {
  Eigen::RowVectorXcd row(poles.count());
  Eigen::Index at = 0;
  for (const double p : poles.real) row[at++] = 1.0 / (s - p);
  for (const auto& p : poles.pair) {
    const std::complex<double> upper = 1.0 / (s - p), lower = 1.0 / (s - std::conj(p));
    row[at++] = upper + lower;
    row[at++] = k_imaginary_unit * (upper - lower);
  }
  return row;
}

std::vector<MatXc> residues_of(const Poles& poles, const std::vector<MatX>& coefficients) {
  std::vector<MatXc> residues;
  const std::size_t reals = poles.real.size();
  for (std::size_t k = 0; k < reals; ++k) residues.emplace_back(coefficients[k].cast<std::complex<double>>());
  for (std::size_t k = 0; k < poles.pair.size(); ++k)
    residues.emplace_back(coefficients[reals + 2 * k] + k_imaginary_unit * coefficients[reals + 2 * k + 1]);
  return residues;
}

MatXc RationalModel::operator()(std::complex<double> s) const {
  const auto m = static_cast<Eigen::Index>(modes.size());
  MatXc sum = MatXc::Zero(m, m);
  std::size_t at = 0;
  for (const double p : poles.real) sum += residues[at++] / (s - p);
  for (const auto& p : poles.pair) {
    sum += residues[at] / (s - p) + residues[at].conjugate() / (s - std::conj(p));
    ++at;
  }
  return sum;
}

StateMatrices state_matrices(const RationalModel& model) {
  const auto m = static_cast<Eigen::Index>(model.modes.size());
  const Eigen::Index n = model.states();
  const MatX one = MatX::Identity(m, m);
  StateMatrices out{MatX::Zero(n, n), MatX::Zero(n, m), MatX::Zero(m, n)};
  Eigen::Index at = 0;
  std::size_t residue = 0;
  for (const double p : model.poles.real) {
    out.A.block(at, at, m, m) = p * one;
    out.B.middleRows(at, m) = one;
    out.C.middleCols(at, m) = model.residues[residue++].real();
    at += m;
  }
  for (const auto& p : model.poles.pair) {
    // The state of the upper pole is x + i y; the load is twice the real part of its residue times that.
    out.A.block(at, at, m, m) = p.real() * one;
    out.A.block(at, at + m, m, m) = -p.imag() * one;
    out.A.block(at + m, at, m, m) = p.imag() * one;
    out.A.block(at + m, at + m, m, m) = p.real() * one;
    out.B.middleRows(at, m) = one;
    out.C.middleCols(at, m) = 2 * model.residues[residue].real();
    out.C.middleCols(at + m, m) = -2 * model.residues[residue].imag();
    ++residue;
    at += 2 * m;
  }
  return out;
}

}  // namespace nilas::hydro
