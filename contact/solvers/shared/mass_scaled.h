#pragma once
/// One island of a local problem in units of sqrt(J), where every contact has about the same inverse mass.
///
///   e_a = 1/sqrt(d_a),  r = e r',  u' = e u = W' r' + q',  W' = e (W + C) e,  q' = e q,
///   d_a = trace(W_aa + C_a)/3,  C the diagonal of compliances
///
/// Cones are unchanged, because e_a multiplies all three rows of a contact alike, and the natural map in m/s is
/// sqrt(d_a) |r'_a - P(r'_a - u'_a)|.
#include <Eigen/SparseCore>
#include <optional>
#include <vector>

#include "contact/problem/local_problem.h"
#include "contact/problem/problem.h"
#include "contact/problem/solution.h"

namespace nilas::solvers {

struct MassScaled {
  Law law = Law::coulomb;
  std::vector<double> scale;              ///< e_a [sqrt(kg)]
  Eigen::SparseMatrix<double> w;          ///< W' as stored
  Eigen::SparseMatrix<double> symmetric;  ///< (W' + W'^T)/2
  bool skew = false;                      ///< W' differs from its symmetric part by more than rounding
  VecX q;
  std::vector<double> mu;   ///< 0 for the frictionless law
  std::vector<double> cap;  ///< limit of r'_N [sqrt(J)]

  int num_contacts() const { return static_cast<int>(mu.size()); }
  VecX impulses(const VecX& scaled) const;    ///< r of r'
  VecX scaled_impulses(const VecX& r) const;  ///< r' of r
};

MassScaled mass_scaled(const contact::LocalProblem& island);

/// Residual of the convex law with velocities u' (any shift included): max sqrt(d_a) |r'_a - P(r'_a - u'_a)| [m/s].
double convex_map(const MassScaled& problem, const VecX& scaled, const VecX& velocity);

/// mu_a |u'_Ta| on the normal rows, 0 elsewhere: u' + this is De Saxce's velocity.
VecX de_saxce_shift(const MassScaled& problem, const VecX& velocity);

/// The solution of an island that holds a contact whose sides cannot move (W_aa = 0, no normal compliance): the limit
/// where it closes, else 0; numerical_error naming its key where it closes without a limit. Empty for all other
/// islands.
std::optional<contact::ContactSolution> solve_immovable(const contact::LocalProblem& island);

}  // namespace nilas::solvers
