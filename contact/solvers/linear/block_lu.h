#pragma once
/// LU factors of a sparse matrix of 3 x 3 blocks: values need not be symmetric, the pattern is made so.
///
///   P K P^T = L U,   L unit lower, U upper, by 3 x 3 blocks; P from the approximate minimum degree of the block graph
///
/// Order, fill and dense last rows as in block_fill.h. Blocks are not exchanged: K must have good diagonal blocks in
/// the order chosen, as a Delassus operator with a proximal term has; only the dense part is factorised with pivoting.
/// Cost: the sum over rows k of (blocks right of k)^2, about 5 ns per pair of blocks. Eigen's SparseLU takes 7 to 14
/// times as long to the same residual: 1412 ms against 158 of 19800 contacts in a field of floes, 1789 against 273 of
/// 4752 in a heap (tests/bench/library_twins.cpp).
#include <vector>

#include "contact/problem/block_fill.h"
#include "contact/solvers/linear/padded_block.h"

namespace nilas::solvers {

class BlockLu {
 public:
  /// Plans for a pattern of n rows: row i has blocks at `column[row_start[i] .. row_start[i + 1])`. The plan of the
  /// last call is kept when the pattern is the same.
  void analyse(const std::vector<int>& row_start, const std::vector<int>& column);

  /// `block`: values in the order of the pattern. False when a diagonal block turned out singular.
  bool factorise(const std::vector<Mat3>& block);

  /// x <- K^-1 x, 3 n numbers.
  void solve(VecX& x) const;

 private:
  bool factorise_tail();

  std::vector<int> row_start_, column_;  ///< pattern as given
  contact::BlockFill fill_;
  std::vector<PaddedBlock> upper_block_, lower_block_;  ///< blocks beyond the diagonal, in the order of the fill
  std::vector<PaddedBlock> pivot_inverse_;
  std::vector<PaddedBlock> row_;  ///< the row that is eliminated, scattered
  MatX dense_;
  Eigen::PartialPivLU<MatX> dense_lu_;
};

}  // namespace nilas::solvers
