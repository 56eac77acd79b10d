#pragma once
/// Transfer functions as sums of partial fractions with common poles.
#include <complex>
#include <vector>

#include "core/base/math.h"

namespace nilas::hydro {

using MatXc = Eigen::MatrixXcd;

/// The poles of a real transfer function [rad/s]: real ones, and of each conjugate pair the one above the real axis.
struct Poles {
  std::vector<double> real;
  std::vector<std::complex<double>> pair;

  int count() const { return static_cast<int>(real.size() + 2 * pair.size()); }
};

/// Partial fractions with real coefficients at s: 1 / (s - p) of each real pole; then of each pair
/// 1 / (s - p) + 1 / (s - p*) and i / (s - p) - i / (s - p*).
Eigen::RowVectorXcd partial_fractions(const Poles& poles, std::complex<double> s);

/// The residue at each pole (reals, then pairs) of real coefficients of partial_fractions(), one matrix each.
std::vector<MatXc> residues_of(const Poles& poles, const std::vector<MatX>& coefficients);

/// H(s) = sum R_k / (s - p_k), where a pair stands for both of its poles. It maps velocities of `modes` to loads.
struct RationalModel {
  std::vector<int> modes;  ///< indices of modes of the vessel, rising
  Poles poles;
  std::vector<MatXc> residues;  ///< reals, then pairs; symmetric

  int states() const { return poles.count() * static_cast<int>(modes.size()); }
  MatXc operator()(std::complex<double> s) const;
};

/// A state-space form x' = A x + B u, y = C x of a rational model, with real matrices.
struct StateMatrices {
  MatX A, B, C;
};
StateMatrices state_matrices(const RationalModel& model);

}  // namespace nilas::hydro
