#include "core/vessel/tree/stiff_block.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/vessel/tree/exponential_mode.h"

namespace nilas::vessel {

namespace {

std::vector<int> others(int n, const std::vector<int>& some) {
  std::vector<int> rest;
  for (int i = 0; i < n; ++i)
    if (std::find(some.begin(), some.end(), i) == some.end()) rest.push_back(i);
  return rest;
}

Eigen::LLT<MatX> factor(const MatX& mass) {
  Eigen::LLT<MatX> llt(mass);
  if (llt.info() != Eigen::Success)
    throw SimulationError("the vessel's mass matrix in its joint coordinates is not positive definite");
  return llt;
}

struct Modes {
  MatX shape;  ///< n x n, mass-normalised
  VecX omega;  ///< n [rad/s]
};

/// The modes of a system. The free coordinates span the modes with zero frequency. The held coordinates carry the free
/// ones along, which makes them mass-orthogonal to these. Rounding of large stiffnesses therefore does not reach the
/// free modes.
Modes find_modes(const MatX& mass, const MatX& stiffness, const std::vector<int>& free) {
  const auto n = mass.rows();
  const auto n_free = static_cast<Eigen::Index>(free.size()), n_held = n - n_free;
  const std::vector<int> held = others(static_cast<int>(n), free);
  Modes modes{MatX::Zero(n, n), VecX::Zero(n)};
  MatX follow;
  if (n_free > 0) {
    const Eigen::LLT<MatX> free_mass = factor(mass(free, free));
    modes.shape(free, Eigen::seqN(0, n_free)) = MatX(free_mass.matrixU().solve(MatX::Identity(n_free, n_free)));
    if (n_held == 0) return modes;
    follow = free_mass.solve(MatX(mass(free, held)));
  }
  MatX held_mass = mass(held, held);
  if (n_free > 0) held_mass -= mass(held, free) * follow;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatX> eigen(stiffness(held, held), held_mass);
  if (eigen.info() != Eigen::Success || !(eigen.eigenvalues()[0] > 0))
    throw SimulationError("the force balance's stiffness or the vessel's mass matrix is not positive definite");
  modes.omega.tail(n_held) = eigen.eigenvalues().cwiseSqrt();
  modes.shape(held, Eigen::seqN(n_free, n_held)) = eigen.eigenvectors();
  if (n_free > 0) modes.shape(free, Eigen::seqN(n_free, n_held)) = -follow * eigen.eigenvectors();
  return modes;
}

/// X diag(weight) X^T, bitwise symmetric.
MatX weighted_square(const MatX& x, const VecX& weight) {
  MatX square = MatX::Zero(x.rows(), x.rows());
  square.selfadjointView<Eigen::Lower>().rankUpdate(x * weight.cwiseSqrt().asDiagonal());
  return square.selfadjointView<Eigen::Lower>();
}

StiffBlock solve_set(const MatX& mass, const MatX& stiffness, double damping_time, const std::vector<int>& free,
                     double h) {
  const Modes modes = find_modes(mass, stiffness, free);
  VecX kept(modes.omega.size()), response(modes.omega.size());
  for (Eigen::Index j = 0; j < modes.omega.size(); ++j) {
    const ExponentialMode mode = exponential_mode(modes.omega[j], damping_time, h);
    kept[j] = mode.decay + mode.response * h * damping_time * modes.omega[j] * modes.omega[j];
    response[j] = mode.response;
  }
  const MatX momentum = mass * modes.shape;
  return {weighted_square(momentum, response.cwiseInverse()), weighted_square(modes.shape, response),
          modes.shape * kept.asDiagonal() * momentum.transpose()};
}

bool couples(const MatX& a, int i, int j) {
  return std::abs(a(i, j)) > k_coupling_floor * std::sqrt(a(i, i)) * std::sqrt(a(j, j));
}

}  // namespace

std::vector<std::vector<int>> coupled_sets(const MatX& mass, const MatX& stiffness) {
  const int n = static_cast<int>(mass.rows());
  std::vector<std::vector<int>> sets;
  std::vector<bool> taken(static_cast<std::size_t>(n), false);
  for (int first = 0; first < n; ++first) {
    if (taken[first]) continue;
    std::vector<int> set{first};
    taken[first] = true;
    for (std::size_t k = 0; k < set.size(); ++k)
      for (int j = first + 1; j < n; ++j)
        if (!taken[j] && (couples(mass, set[k], j) || couples(stiffness, set[k], j))) {
          set.push_back(j);
          taken[j] = true;
        }
    std::sort(set.begin(), set.end());
    sets.push_back(std::move(set));
  }
  return sets;
}

StiffBlock stiff_block(const MatX& mass, const MatX& stiffness, double damping_time, const std::vector<int>& free,
                       double h) {
  const auto n = mass.rows();
  StiffBlock block{MatX::Zero(n, n), MatX::Zero(n, n), MatX::Zero(n, n)};
  for (const std::vector<int>& set : coupled_sets(mass, stiffness)) {
    std::vector<int> free_in_set;
    for (std::size_t k = 0; k < set.size(); ++k)
      if (std::find(free.begin(), free.end(), set[k]) != free.end()) free_in_set.push_back(static_cast<int>(k));
    const StiffBlock own = solve_set(mass(set, set), stiffness(set, set), damping_time, free_in_set, h);
    block.mass(set, set) = own.mass;
    block.response(set, set) = own.response;
    block.kept(set, set) = own.kept;
  }
  return block;
}

}  // namespace nilas::vessel
