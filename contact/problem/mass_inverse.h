#pragma once
/// Inverses of the mass blocks of a contact problem.
#include <optional>
#include <vector>

#include "contact/problem/problem.h"

namespace nilas::contact {

/// M_k^-1 per block. A symmetric 6x6 block of the form diag(m I, I_G) is kept as 1/m and I_G^-1 with their roots, any
/// other by its Cholesky factor. A block that is asymmetric beyond rounding (masses of files) also has its LU factors.
class MassInverse {
 public:
  explicit MassInverse(const ContactProblem& problem);

  /// First block that is not finite or not positive definite, -1 when all are good. The inverse of a bad block is NaN.
  int first_bad_block() const { return first_bad_block_; }
  /// velocity = M_k^-1 momentum, block_size(k) numbers each; the two may be the same array.
  void apply(int k, const double* momentum, double* velocity) const;
  /// x^T M_k^-1 x, x of block_size(k) numbers.
  double square(int k, const double* x) const;
  /// False for a block that is asymmetric beyond rounding, which has no root.
  bool has_root(int k) const;
  /// scaled = L^-1 momentum with M_k = L L^T: the mass-scaled velocity L^T v of M_k v. NaN for a bad block.
  void apply_root(int k, const double* momentum, double* scaled) const;

 private:
  struct RigidBody {
    double inverse_mass = 0;
    Mat3 inverse_inertia = Mat3::Zero();
    double root_mass = 0;              ///< 1/sqrt(m)
    Mat3 root_inertia = Mat3::Zero();  ///< lower triangle, root^T root = I_G^-1
  };
  struct General {
    Eigen::LLT<MatX> cholesky;  ///< factor of the lower triangle
    std::optional<Eigen::PartialPivLU<MatX>> lu;
  };
  void add_rigid_body(const ContactProblem::ConstMatrix& mass, int block);
  void add_general(const ContactProblem::ConstMatrix& mass, int block);
  void mark_bad(int block);

  std::vector<int> slot_;  ///< slot of each block: k >= 0 in rigid_bodies_, ~k in general_
  std::vector<RigidBody> rigid_bodies_;
  std::vector<General> general_;
  int first_bad_block_ = -1;
};

}  // namespace nilas::contact
