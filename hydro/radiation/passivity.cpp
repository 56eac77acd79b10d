#include "hydro/radiation/passivity.h"

#include <algorithm>

#include "core/base/error.h"

namespace nilas::hydro {

std::vector<double> crossings(const RationalModel& model, double margin) {
  NILAS_DEMAND(margin > 0);
  // Eigenvalues of a Hamiltonian matrix mirror at the imaginary axis; one that is off it by rounding lies on it.
  constexpr double k_on_the_axis = 1e-7;
  const StateMatrices of = state_matrices(model);
  const Eigen::Index n = of.A.rows();
  // H + H^T of the shifted system has the feedthrough 2 margin.
  const double inverse = 1 / (2 * margin);
  MatX hamiltonian(2 * n, 2 * n);
  hamiltonian << of.A - inverse * of.B * of.C, -inverse * of.B * of.B.transpose(), inverse * of.C.transpose() * of.C,
      -of.A.transpose() + inverse * of.C.transpose() * of.B.transpose();
  const Eigen::EigenSolver<MatX> solver(hamiltonian, false);
  std::vector<double> found;
  for (const std::complex<double>& value : solver.eigenvalues())
    if (value.imag() > 0 && std::abs(value.real()) < k_on_the_axis * std::abs(value)) found.push_back(value.imag());
  std::sort(found.begin(), found.end());
  return found;
}

double lowest_damping(const RationalModel& model, double w) {
  const MatXc H = model(std::complex<double>(0, w));
  const MatXc hermitian = 0.5 * (H + H.adjoint());
  return Eigen::SelfAdjointEigenSolver<MatXc>(hermitian, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

bool is_passive(const RationalModel& model, double margin) {
  const double somewhere = model.poles.pair.empty() ? -model.poles.real.front() : std::abs(model.poles.pair.front());
  return lowest_damping(model, somewhere) > -margin && crossings(model, margin).empty();
}

}  // namespace nilas::hydro
