#include "contact/solvers/linear/block_cholesky.h"

#include "contact/problem/inverse_root.h"
#include "contact/problem/row_of.h"

namespace nilas::solvers {

BlockCholesky::BlockCholesky(const Eigen::SparseMatrix<double>& a) : a_(a) {
  const int* const outer = a.outerIndexPtr();
  row_start_.push_back(0);
  for (Eigen::Index i = 0; i < a.cols() / 3; ++i) {
    for (int k = outer[3 * i]; k < outer[3 * i + 1]; k += 3) column_.push_back(a.innerIndexPtr()[k] / 3);
    row_start_.push_back(static_cast<int>(column_.size()));
  }
  value_.resize(column_.size());
  fill_ = contact::block_fill(row_start_, column_);
  const std::size_t n = fill_.size();
  upper_block_.resize(fill_.upper.columns.size());
  inverse_root_.resize(n);
  row_.resize(n);
}

/// A is symmetric: its columns are its rows.
void BlockCholesky::set_values(const std::vector<Mat3>& inverse, const std::vector<Mat3>& added) {
  const int* const outer = a_.outerIndexPtr();
  for (Eigen::Index i = 0; i < a_.cols() / 3; ++i)
    for (int k = row_start_[i]; k < row_start_[i + 1]; ++k) {
      const int j = column_[k], in_column = 3 * (k - row_start_[i]);
      Mat3 block;
      for (int c = 0; c < 3; ++c) block.row(c) = Eigen::Map<const Vec3>(a_.valuePtr() + outer[3 * i + c] + in_column);
      value_[k].noalias() = inverse[i] * (block * inverse[j]).eval();
      if (i == j) value_[k] += added[i];
    }
}

/// Leaves row i of the matrix less what the rows before take from it, from the diagonal on, in row_.
void BlockCholesky::eliminate(int i) {
  const int source = fill_.source[i];
  for (int k = row_start_[source]; k < row_start_[source + 1]; ++k) {
    const int j = fill_.place[column_[k]];
    if (j >= i) row_[j] = PaddedBlock(value_[k]);
  }
  for (const int pivot : fill_.lower[i]) {
    const std::size_t here = next_[pivot]++, end = fill_.upper.first(pivot + 1);
    const PaddedBlock* const blocks = upper_block_.data() + here;
    const PaddedBlock factor(blocks->matrix().transpose());
    subtract_products(factor, blocks, fill_.upper.columns.data() + here, end - here, row_.data());
  }
}

/// Makes row_ row i of V and clears it; false where its diagonal block is not positive definite.
bool BlockCholesky::keep_row(int i) {
  const int n = fill_.size();
  if (i >= fill_.tail) {
    for (int j = i; j < n; ++j) {
      dense_.block<3, 3>(contact::row_of(i - fill_.tail), contact::row_of(j - fill_.tail)) = row_[j].matrix();
      row_[j] = {};
    }
    return true;
  }
  const Mat3 root = contact::inverse_root(row_[i].matrix());
  row_[i] = {};
  inverse_root_[i] = PaddedBlock(root);
  PaddedBlock* kept = upper_block_.data() + fill_.upper.first(i);
  for (const int j : fill_.upper[i]) {
    *kept++ = product(inverse_root_[i], row_[j]);
    row_[j] = {};
  }
  return root.allFinite() && root.diagonal().minCoeff() > 0;
}

bool BlockCholesky::factor(const std::vector<Mat3>& inverse, const std::vector<Mat3>& added) {
  set_values(inverse, added);
  const int n = fill_.size();
  next_.assign(fill_.upper.start.begin(), fill_.upper.start.end() - 1);
  dense_.resize(contact::row_of(n - fill_.tail), contact::row_of(n - fill_.tail));
  for (int i = 0; i < n; ++i) {
    eliminate(i);
    if (!keep_row(i)) return false;
  }
  if (dense_.rows() == 0) return true;
  dense_factor_.compute(dense_);
  return dense_factor_.info() == Eigen::Success && dense_factor_.matrixLLT().diagonal().allFinite();
}

VecX BlockCholesky::solve_unrefined(const VecX& b) const {
  const int n = fill_.size(), tail = fill_.tail;
  VecX y(contact::row_of(n));
  for (int i = 0; i < n; ++i) y.segment<3>(contact::row_of(i)) = b.segment<3>(contact::row_of(fill_.source[i]));
  for (int i = 0; i < tail; ++i) {
    const Vec3 scaled = inverse_root_[i].matrix() * y.segment<3>(contact::row_of(i));
    y.segment<3>(contact::row_of(i)) = scaled;
    const PaddedBlock* block = upper_block_.data() + fill_.upper.first(i);
    for (const int j : fill_.upper[i])
      y.segment<3>(contact::row_of(j)).noalias() -= (block++)->matrix().transpose() * scaled;
  }
  if (tail < n) y.tail(contact::row_of(n - tail)) = dense_factor_.solve(y.tail(contact::row_of(n - tail))).eval();
  for (int i = tail - 1; i >= 0; --i) {
    Vec3 sum = y.segment<3>(contact::row_of(i));
    const PaddedBlock* block = upper_block_.data() + fill_.upper.first(i);
    for (const int j : fill_.upper[i]) sum.noalias() -= (block++)->matrix() * y.segment<3>(contact::row_of(j));
    y.segment<3>(contact::row_of(i)) = inverse_root_[i].matrix().transpose() * sum;
  }
  VecX x(contact::row_of(n));
  for (int i = 0; i < n; ++i) x.segment<3>(contact::row_of(fill_.source[i])) = y.segment<3>(contact::row_of(i));
  return x;
}

VecX BlockCholesky::times(const VecX& y) const {
  VecX out(y.size());
  for (Eigen::Index i = 0; i < y.size() / 3; ++i) {
    Vec3 sum = Vec3::Zero();
    for (int k = row_start_[i]; k < row_start_[i + 1]; ++k)
      sum.noalias() += value_[k] * y.segment<3>(contact::row_of(column_[k]));
    out.segment<3>(3 * i) = sum;
  }
  return out;
}

VecX BlockCholesky::solve(const VecX& b) const {
  const VecX y = solve_unrefined(b);
  return y + solve_unrefined(b - times(y));
}

}  // namespace nilas::solvers
