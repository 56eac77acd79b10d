#include "contact/solvers/block_lu.h"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

namespace nilas {

namespace {

/// The dense part begins where at least this share of the blocks to come are filled.
constexpr double k_dense_share = 0.6;
/// Fewer rows than this are not worth a dense part.
constexpr int k_smallest_tail = 8;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool usable(const Mat3& inverse) { return inverse.allFinite(); }

// The same operations in the same order in wider registers where the machine has them: the bits do not depend on it.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define NILAS_WIDE_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define NILAS_WIDE_CLONES
#endif

/// row[columns[j]] -= factor * blocks[j] for `count` blocks: where the time goes.
NILAS_WIDE_CLONES void subtract_products(const PaddedBlock& factor, const PaddedBlock* blocks, const int* columns,
                                         std::size_t count, PaddedBlock* row) {
  using Four = double __attribute__((vector_size(32)));
  Four f[3];
  std::memcpy(f, factor.column, sizeof f);
  for (std::size_t j = 0; j < count; ++j) {
    auto& target = row[columns[j]].column;
    const auto& block = blocks[j].column;
    for (int k = 0; k < 3; ++k) {
      Four sum;
      std::memcpy(&sum, target[k], sizeof sum);
      sum -= f[0] * block[k][0] + f[1] * block[k][1] + f[2] * block[k][2];
      std::memcpy(target[k], &sum, sizeof sum);
    }
  }
}

void add(const Mat3& m, PaddedBlock& to) { to = PaddedBlock(to.matrix() + m); }

}  // namespace

void BlockLu::analyse(const std::vector<int>& row_start, const std::vector<int>& column) {
  if (row_start == row_start_ && column == column_) return;
  row_start_ = row_start;
  column_ = column;
  order();
  find_fill();
  choose_tail();
  const std::size_t n = place_.size();
  upper_block_.resize(n);
  lower_block_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    upper_block_[i].resize(upper_[i].size());
    lower_block_[i].resize(lower_[i].size());
  }
  pivot_inverse_.resize(n);
  row_.assign(n, {});
}

void BlockLu::order() {
  const int n = static_cast<int>(row_start_.size()) - 1;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(column_.size());
  for (int i = 0; i < n; ++i)
    for (int k = row_start_[at(i)]; k < row_start_[at(i) + 1]; ++k) entries.emplace_back(i, column_[at(k)], 1.0);
  Eigen::SparseMatrix<double> pattern(n, n);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(pattern, permutation);
  // Eigen hands out the inverse permutation: entry k is the row that comes k-th
  source_.assign(permutation.indices().data(), permutation.indices().data() + n);
  place_.resize(at(n));
  for (int k = 0; k < n; ++k) place_[at(source_[at(k)])] = k;
}

/// upper(k) = neighbours of k that come later, and those of every row whose first later neighbour is k.
void BlockLu::find_fill() {
  const int n = size();
  upper_.assign(at(n), {});
  lower_.assign(at(n), {});
  for (int i = 0; i < n; ++i)
    for (int k = row_start_[at(i)]; k < row_start_[at(i) + 1]; ++k) {
      const int a = place_[at(i)], b = place_[at(column_[at(k)])];
      if (a != b) upper_[at(std::min(a, b))].push_back(std::max(a, b));
    }
  std::vector<std::vector<int>> children(at(n));
  std::vector<int> seen(at(n), -1);
  for (int k = 0; k < n; ++k) {
    auto& row = upper_[at(k)];
    std::vector<int> merged;
    seen[at(k)] = k;
    const auto take = [&](const std::vector<int>& list) {
      for (const int j : list)
        if (seen[at(j)] != k) {
          seen[at(j)] = k;
          merged.push_back(j);
        }
    };
    take(row);
    for (const int child : children[at(k)]) take(upper_[at(child)]);
    std::sort(merged.begin(), merged.end());
    row = std::move(merged);
    if (!row.empty()) children[at(row.front())].push_back(k);
    for (const int j : row) lower_[at(j)].push_back(k);
  }
}

void BlockLu::choose_tail() {
  const int n = size();
  tail_ = n;
  double filled = 0;
  for (int k = n - 1; k >= 0; --k) {
    filled += static_cast<double>(upper_[at(k)].size());
    const double rows = n - k;
    if (rows >= k_smallest_tail && filled >= k_dense_share * rows * (rows - 1) / 2) tail_ = k;
  }
  for (int i = tail_; i < n; ++i) {
    auto& row = lower_[at(i)];
    row.erase(std::lower_bound(row.begin(), row.end(), tail_), row.end());
  }
}

bool BlockLu::factorise(const std::vector<Mat3>& block) {
  const int n = size();
  dense_.setZero(3 * (n - tail_), 3 * (n - tail_));
  for (int i = 0; i < n; ++i) {
    const int source = source_[at(i)];
    for (int k = row_start_[at(source)]; k < row_start_[at(source) + 1]; ++k)
      add(block[at(k)], row_[at(place_[at(column_[at(k)])])]);
    for (std::size_t k = 0; k < lower_[at(i)].size(); ++k) {
      const std::size_t pivot = at(lower_[at(i)][k]);
      const PaddedBlock factor(row_[pivot].matrix() * pivot_inverse_[pivot]);
      row_[pivot] = {};
      lower_block_[at(i)][k] = factor;
      subtract_products(factor, upper_block_[pivot].data(), upper_[pivot].data(), upper_[pivot].size(), row_.data());
    }
    if (i < tail_) {
      pivot_inverse_[at(i)] = Mat3(row_[at(i)].matrix()).inverse();
      row_[at(i)] = {};
      if (!usable(pivot_inverse_[at(i)])) {
        row_.assign(row_.size(), {});
        return false;
      }
      for (std::size_t j = 0; j < upper_[at(i)].size(); ++j) {
        upper_block_[at(i)][j] = row_[at(upper_[at(i)][j])];
        row_[at(upper_[at(i)][j])] = {};
      }
    } else {
      for (int j = tail_; j < n; ++j) {
        dense_.block<3, 3>(3 * (i - tail_), 3 * (j - tail_)) = row_[at(j)].matrix();
        row_[at(j)] = {};
      }
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
  const int n = size();
  VecX y(3 * n);
  for (int i = 0; i < n; ++i) {
    Vec3 sum = x.segment<3>(3 * source_[at(i)]);
    for (std::size_t k = 0; k < lower_[at(i)].size(); ++k)
      sum -= lower_block_[at(i)][k].matrix() * y.segment<3>(3 * lower_[at(i)][k]);
    y.segment<3>(3 * i) = sum;
  }
  if (tail_ < n) y.tail(3 * (n - tail_)) = dense_lu_.solve(y.tail(3 * (n - tail_))).eval();
  for (int i = tail_ - 1; i >= 0; --i) {
    Vec3 sum = y.segment<3>(3 * i);
    for (std::size_t k = 0; k < upper_[at(i)].size(); ++k)
      sum -= upper_block_[at(i)][k].matrix() * y.segment<3>(3 * upper_[at(i)][k]);
    y.segment<3>(3 * i) = pivot_inverse_[at(i)] * sum;
  }
  for (int i = 0; i < n; ++i) x.segment<3>(3 * source_[at(i)]) = y.segment<3>(3 * i);
}

}  // namespace nilas
