#pragma once
/// Block Gauss-Seidel: each contact in turn is solved exactly with all others held (contact/law/local_solve.h).
///
///   for each contact a in order:  b_a = u_a - A_aa r_a,   r_a <- the law's answer to u_a = A_aa r_a + b_a
///
/// On a problem with bodies the velocities v = M^-1 (f + H r) are kept up to date, so that a sweep costs O(nc); on a
/// local problem u_a is gathered over the row of W. W may be asymmetric. Contacts with b_N >= 0 that carry nothing cost
/// one row (all three for ccp). In islands of 1000 contacts or more, four with Coulomb's law that share no block are
/// solved at once, with the same bits (lanes/nsgs_lanes.h).
/// Contraction per sweep: cos^2(pi/2n) for a column of n equal bodies, M/(M + m) for M on m: a first stage and a solver
/// for loose fields; stacks, hyperstatic piles and heavy-on-light want another. Momentum (has_momentum) makes sweeps
/// several times fewer there (shared/sweep_momentum.h).
/// Sources: Jourdan, Alart, Jean 1998; Jean 1999 (non-smooth contact dynamics).
///
/// Laws: all. Nominal tolerances: 1e-6 m/s in simulations, 1e-10 m/s in tests. Islands are solved apart.
#include "contact/solvers/shared/sweep_loop.h"
#include "contact/solvers/solver.h"

namespace nilas::solvers {

using NsgsSettings = SweepSettings;

class NsgsSolver final : public ContactSolver {
 public:
  explicit NsgsSolver(const NsgsSettings& settings) : settings_(settings) {}
  using ContactSolver::solve;
  std::string name() const override { return "nsgs"; }
  /// converged: every island's law_map_m_s is at most the tolerance, as `measure` finds it on the impulses returned.
  /// stalled, iteration_limit: the impulses are the best that were measured. With tolerance 0 nothing is measured.
  /// numerical_error: something is not finite, or a contact closes whose sides cannot move and that has no force limit;
  /// `message` says which.
  /// Throws InputError for rolling or spinning friction with a law other than coulomb or pyramid.
  contact::ContactSolution solve(const contact::PreparedProblem& problem, const VecX& guess) const override;
  contact::ContactSolution solve(const contact::LocalProblem& problem, const VecX& guess) const override;
  /// Solves as a stage of a solve in progress, within `budget`.
  contact::ContactSolution solve(const contact::PreparedProblem& problem, const VecX& guess,
                                 const Budget& budget) const;
  contact::ContactSolution solve(const contact::LocalProblem& problem, const VecX& guess, const Budget& budget) const;

 private:
  NsgsSettings settings_;
};

}  // namespace nilas::solvers
