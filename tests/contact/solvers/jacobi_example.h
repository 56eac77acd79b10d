#pragma once
/// Projected Jacobi: all contacts at once take one step against their velocities and return to their cones.
///
///   r+ = P_K(r - omega D^-1 (u + s)),  u = W r + q,  s_a = mu |u_Ta| n,  D = diag(d_a),  d_a = trace(W_aa)/3
///
/// The shift s is zero for ccp and frictionless. One product with W per iteration: O(nc) on a problem with bodies. For
/// these convex laws it converges where omega is below 2 over the largest eigenvalue of D^-1 W. That eigenvalue is at
/// most three times the largest number of contacts of one body. For coulomb there is no such bound; it converges in
/// practice where friction is moderate. Many iterations for stacks, whose small eigenvalues decide the rate.
/// Source: De Saxce, Feng 1998 (the projection that is iterated).
///
/// Laws: coulomb, ccp, frictionless. Nominal tolerance: 1e-6 m/s. Islands are solved apart.
#include "contact/solvers/solver.h"

namespace nilas::solvers {

struct JacobiSettings {
  contact::SolverSettings shared;
  double omega = 0.2;           ///< length of a step, as a share of D^-1 [-]
  int stall_iterations = 1000;  ///< window of the stall rule (best_impulses.h); share 0.999
};

class JacobiSolver final : public ContactSolver {
 public:
  explicit JacobiSolver(const JacobiSettings& settings) : settings_(settings) {}
  using ContactSolver::solve;
  std::string name() const override { return "jacobi"; }
  /// converged: law_map_m_s is at most the tolerance as `measure` finds it; else the best impulses measured. With
  /// tolerance 0 nothing is measured. numerical_error: input that is not finite, or a contact that cannot yield.
  /// Throws InputError for the laws pyramid and pyramid-k, and for rolling or spinning friction.
  contact::ContactSolution solve(const contact::PreparedProblem& problem, const VecX& guess) const override;
  contact::ContactSolution solve(const contact::LocalProblem& problem, const VecX& guess) const override;

 private:
  JacobiSettings settings_;
};

}  // namespace nilas::solvers
