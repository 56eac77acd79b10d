#include "contact/solvers/linear/block_lu.h"

namespace nilas::solvers {

static void add(const Mat3& m, PaddedBlock& to) { to = PaddedBlock(to.matrix() + m); }

void BlockLu::analyse(const std::vector<int>& row_start, const std::vector<int>& column) {
  if (row_start == row_start_ && column == column_) return;
  row_start_ = row_start;
  column_ = column;
  fill_ = contact::block_fill(row_start, column);
  upper_block_.resize(fill_.upper.columns.size());
  lower_block_.resize(fill_.lower.columns.size());
  pivot_inverse_.resize(fill_.size());
  row_.assign(fill_.size(), {});
}

bool BlockLu::factorise(const std::vector<Mat3>& block) {
  const int n = fill_.size();
  dense_.setZero(3 * (n - fill_.tail), 3 * (n - fill_.tail));
  for (int i = 0; i < n; ++i) {
    const int source = fill_.source[i];
    for (int k = row_start_[source]; k < row_start_[source + 1]; ++k) add(block[k], row_[fill_.place[column_[k]]]);
    PaddedBlock* factor = lower_block_.data() + fill_.lower.first(i);
    for (const int pivot : fill_.lower[i]) {
      *factor = product(row_[pivot], pivot_inverse_[pivot]);
      row_[pivot] = {};
      const auto columns = fill_.upper[pivot];
      subtract_products(*factor, upper_block_.data() + fill_.upper.first(pivot), columns.data(), columns.size(),
                        row_.data());
      ++factor;
    }
    if (i >= fill_.tail) {
      for (int j = fill_.tail; j < n; ++j) {
        dense_.block<3, 3>(3 * (i - fill_.tail), 3 * (j - fill_.tail)) = row_[j].matrix();
        row_[j] = {};
      }
      continue;
    }
    const Mat3 inverse = Mat3(row_[i].matrix()).inverse();
    pivot_inverse_[i] = PaddedBlock(inverse);
    row_[i] = {};
    if (!inverse.allFinite()) {
      row_.assign(row_.size(), {});
      return false;
    }
    PaddedBlock* kept = upper_block_.data() + fill_.upper.first(i);
    for (const int j : fill_.upper[i]) {
      *kept++ = row_[j];
      row_[j] = {};
    }
  }
  return factorise_tail();
}

bool BlockLu::factorise_tail() {
  if (dense_.rows() == 0) return true;
  dense_lu_.compute(dense_);
  const auto pivots = dense_lu_.matrixLU().diagonal();
  return pivots.allFinite() && pivots.cwiseAbs().minCoeff() > 0;
}

void BlockLu::solve(VecX& x) const {
  const int n = fill_.size();
  VecX y(3 * n);
  for (int i = 0; i < n; ++i) {
    Vec3 sum = x.segment<3>(3 * fill_.source[i]);
    const PaddedBlock* block = lower_block_.data() + fill_.lower.first(i);
    for (const int j : fill_.lower[i]) sum -= (block++)->matrix() * y.segment<3>(3 * j);
    y.segment<3>(3 * i) = sum;
  }
  if (fill_.tail < n) y.tail(3 * (n - fill_.tail)) = dense_lu_.solve(y.tail(3 * (n - fill_.tail))).eval();
  for (int i = fill_.tail - 1; i >= 0; --i) {
    Vec3 sum = y.segment<3>(3 * i);
    const PaddedBlock* block = upper_block_.data() + fill_.upper.first(i);
    for (const int j : fill_.upper[i]) sum -= (block++)->matrix() * y.segment<3>(3 * j);
    y.segment<3>(3 * i) = pivot_inverse_[i].matrix() * sum;
  }
  for (int i = 0; i < n; ++i) x.segment<3>(3 * fill_.source[i]) = y.segment<3>(3 * i);
}

}  // namespace nilas::solvers
