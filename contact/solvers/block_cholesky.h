#pragma once
/// Solves (P^-1 A P^-1 + D) y = b: A symmetric positive semidefinite of 3 x 3 blocks, P block diagonal and symmetric, D
/// block diagonal with eigenvalues of at least about 1.
///
/// It is (A + P D P) x = P b with y = P x, in the form whose eigenvalues are bounded from below however singular A is
/// and however far the blocks of P are apart, so that the factorisation does not break down. Dense or sparse (one
/// symbolic analysis for all), whichever is estimated cheaper.
#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <vector>

#include "core/base/math.h"

namespace nilas {

class BlockCholesky {
 public:
  /// `a` must keep all nine entries of every block; it must outlive this.
  explicit BlockCholesky(const Eigen::SparseMatrix<double>& a);
  /// `inverse`: P^-1, `added`: D. False when the matrix is not positive definite (not finite, or lost to rounding).
  bool factor(const std::vector<Mat3>& inverse, const std::vector<Mat3>& added);
  /// With one step of iterative refinement.
  VecX solve(const VecX& b) const;
  VecX solve_unrefined(const VecX& b) const;

 private:
  /// Tells what a factorisation costs, in multiply-adds.
  class Sparse : public Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> {
   public:
    double cost() const { return m_nonZerosPerCol.cast<double>().squaredNorm(); }
  };

  const Eigen::SparseMatrix<double>& a_;
  Eigen::SparseMatrix<double> scaled_;
  bool dense_ = false;
  Sparse sparse_factor_;
  Eigen::LLT<MatX> dense_factor_;
};

}  // namespace nilas
