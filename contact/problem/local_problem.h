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

namespace nilas {

struct LocalProblem {
  Law law = Law::coulomb;
  int facets = 8;  ///< of pyramid_k

  std::vector<int> row_start{0};    ///< nc + 1, into column and block
  std::vector<int> column;          ///< contact of each block of W, rising within a row; the diagonal is always there
  std::vector<Mat3> block;          ///< W_ab [1/kg]
  VecX q;                           ///< 3 nc [m/s]
  std::vector<double> mu;           ///< nc, kinetic friction coefficient
  std::vector<double> mu_static;    ///< nc, >= mu
  std::vector<double> force_limit;  ///< nc, largest normal impulse (infinite: none) [N s]
  std::vector<double> compliance;   ///< nc, u_N + c r_N replaces u_N [m/(s N s)]
  std::vector<std::uint64_t> key;   ///< nc, distinct

  int num_contacts() const { return static_cast<int>(row_start.size()) - 1; }
  const Mat3& diagonal(int a) const;  ///< W_aa
};

/// Throws ContractError naming the field when sizes, signs, order or finiteness are wrong.
void validate(const LocalProblem& problem);

/// u = W r + q.
VecX contact_velocities(const LocalProblem& problem, const VecX& r);

/// W = H^T M^-1 H and q = H^T M^-1 f + w. Every pair of contacts of one block gets a block of W: meant for up to about
/// 1e4 contacts.
LocalProblem reduce(const ContactProblem& problem);

/// Contacts joined by blocks of W that are not zero, each group in rising order, groups by their first contact.
std::vector<std::vector<int>> find_islands(const LocalProblem& problem);

/// The problem of some contacts (rising) with the others taken out.
LocalProblem select(const LocalProblem& problem, const std::vector<int>& contacts);

/// Largest |W_ab - W_ba^T| over the largest |W_ab| [-].
double asymmetry(const LocalProblem& problem);
/// W as a sparse matrix, 3 nc x 3 nc.
Eigen::SparseMatrix<double> sparse_matrix(const LocalProblem& problem);

}  // namespace nilas
