#pragma once
/// The local (reduced) form of a contact problem, FCLIB's local form: u = W r + q with no bodies behind it.
///
///   u = W r + q,   u_hat = u + mu |u_T| n,   K* contains u_hat, perpendicular to r in K
///
/// Ordering and signs as in ContactProblem, normal first. W is kept as given: a file's may be slightly asymmetric.
#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "contact/problem/problem.h"

namespace nilas::contact {

/// ContactCoefficients adds the law and, per contact, friction, force limit, compliance and key.
struct LocalProblem : ContactCoefficients {
  std::vector<int> row_start{0};  ///< nc + 1, into column and block
  std::vector<int> column;        ///< contact of each block of W, rising within a row; the diagonal is always there
  std::vector<Mat3> block;        ///< W_ab [1/kg]
  VecX q;                         ///< 3 nc [m/s]

  int num_contacts() const { return static_cast<int>(row_start.size()) - 1; }
  const Mat3& diagonal(int a) const;  ///< W_aa

  bool operator==(const LocalProblem&) const = default;
};

/// Throws ContractError naming the field when sizes, signs, order or finiteness are wrong.
void validate(const LocalProblem& problem);

/// u = W r + q.
VecX contact_velocities(const LocalProblem& problem, const VecX& r);

/// W = H^T M^-1 H and q = H^T M^-1 f + w. Every pair of contacts of one block gets a block of W: meant for up to about
/// 1e4 contacts. Throws ContractError for a problem with moments.
LocalProblem reduce(const ContactProblem& problem);

/// Largest |W_ab - W_ba^T| over the largest |W_ab| [-].
double asymmetry(const LocalProblem& problem);
/// W as a sparse matrix, 3 nc x 3 nc.
Eigen::SparseMatrix<double> sparse_matrix(const LocalProblem& problem);

}  // namespace nilas::contact
