#include "contact/solvers/block_cholesky.h"

namespace nilas {

namespace {

/// A multiply-add of the sparse factorisation takes this many times one of the blocked dense factorisation.
constexpr double k_sparse_penalty = 4;
/// Beyond this many rows a dense matrix takes more than 1 GB, whatever it saves.
constexpr Eigen::Index k_most_dense_rows = 11000;
std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

}  // namespace

BlockCholesky::BlockCholesky(const Eigen::SparseMatrix<double>& a) : a_(a), scaled_(a) {
  const auto n = static_cast<double>(a.rows());
  sparse_factor_.analyzePattern(a);
  dense_ = a.rows() <= k_most_dense_rows && k_sparse_penalty * sparse_factor_.cost() > n * n * n / 3;
}

bool BlockCholesky::factor(const std::vector<Mat3>& inverse, const std::vector<Mat3>& added) {
  const int* const outer = a_.outerIndexPtr();
  for (Eigen::Index b = 0; b < a_.cols() / 3; ++b)
    for (int k = 0; k < outer[3 * b + 1] - outer[3 * b]; k += 3) {
      const Eigen::Index a = a_.innerIndexPtr()[outer[3 * b] + k] / 3;
      Mat3 value;
      for (int j = 0; j < 3; ++j) value.col(j) = Eigen::Map<const Vec3>(a_.valuePtr() + outer[3 * b + j] + k);
      value = (inverse[at(a)] * value * inverse[at(b)]).eval();
      if (a == b) value += added[at(a)];
      for (int j = 0; j < 3; ++j) Eigen::Map<Vec3>(scaled_.valuePtr() + outer[3 * b + j] + k) = value.col(j);
    }
  if (dense_) {
    dense_factor_.compute(MatX(scaled_));
    return dense_factor_.info() == Eigen::Success;
  }
  sparse_factor_.factorize(scaled_);
  return sparse_factor_.info() == Eigen::Success;
}

VecX BlockCholesky::solve_unrefined(const VecX& b) const {
  return dense_ ? VecX(dense_factor_.solve(b)) : VecX(sparse_factor_.solve(b));
}

VecX BlockCholesky::solve(const VecX& b) const {
  const VecX y = solve_unrefined(b);
  return y + solve_unrefined(b - scaled_ * y);
}

}  // namespace nilas
