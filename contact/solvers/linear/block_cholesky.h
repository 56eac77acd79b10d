#pragma once
/// Solves (P^-1 A P^-1 + D) y = b: A symmetric positive semidefinite of 3 x 3 blocks, P and D block diagonal, symmetric
/// and positive definite.
///
/// It is (A + P D P) x = P b with y = P x, in the form whose eigenvalues are at least those of D however singular A is
/// and however far the blocks of P are apart (in ipm D is about 1, in admm P is 1 and D the penalty), so that the
/// factorisation V^T V, V upper triangular, does not break down. One plan (block_fill.h) serves all; its dense last
/// rows go to a dense Cholesky factor. Cost of a factorisation: half of BlockLu's.
///
/// Eigen's SimplicialLLT, which goes entry by entry, takes 4 to 5 times as long to the same residual: 499 ms against
/// 106 of 19800 contacts in a field of floes, 843 against 155 of 4752 in a heap (tests/bench/library_twins.cpp).
#include <Eigen/Cholesky>
#include <Eigen/SparseCore>
#include <vector>

#include "contact/problem/block_fill.h"
#include "contact/solvers/linear/padded_block.h"

namespace nilas::solvers {

class BlockCholesky {
 public:
  /// `a` must keep all nine entries of every block; it must outlive this.
  explicit BlockCholesky(const Eigen::SparseMatrix<double>& a);
  /// `inverse`: P^-1, `added`: D. False when the matrix is not positive definite (not finite, or lost to rounding).
  bool factor(const std::vector<Mat3>& inverse, const std::vector<Mat3>& added);
  /// Solves with one step of iterative refinement.
  VecX solve(const VecX& b) const;
  VecX solve_unrefined(const VecX& b) const;

 private:
  void set_values(const std::vector<Mat3>& inverse, const std::vector<Mat3>& added);
  void eliminate(int i);
  bool keep_row(int i);
  VecX times(const VecX& y) const;

  const Eigen::SparseMatrix<double>& a_;
  std::vector<int> row_start_, column_;  ///< pattern of the blocks, row by row
  std::vector<Mat3> value_;              ///< values of the matrix to factorise, in that order
  contact::BlockFill fill_;
  std::vector<PaddedBlock> upper_block_;   ///< V right of the diagonal, in the order of the fill
  std::vector<PaddedBlock> inverse_root_;  ///< inverse of V's diagonal blocks, transposed
  std::vector<std::size_t> next_;          ///< first block of each row of V that is not yet used as a factor
  std::vector<PaddedBlock> row_;           ///< the row that is eliminated, scattered
  MatX dense_;
  Eigen::LLT<MatX, Eigen::Upper> dense_factor_;
};

}  // namespace nilas::solvers
