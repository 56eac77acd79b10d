#pragma once
/// Sequential projected Gauss-Seidel on single rows: the baseline of game engines and of earlier ice simulators.
///
/// One sweep visits the contacts in their order and in each the rows N, T1, T2, with the velocities kept up to date:
///   r_N <- min(max(0, r_N - (u_N + c r_N)/(W_NN + c)), force_limit)
///   pyramid:  r_t <- clamp(r_t - u_t/W_tt, -mu r_N, mu r_N), first T1, then T2
///   coulomb:  r_T <- nearest point to r_T - u_T/max(W_11, W_22) in the disc |r_T| <= mu r_N; its fixed point is exact
///   frictionless: r_N alone
/// The rows of one contact see each other through its 3 x 3 block of W, which is the same as updating the velocities
/// after every row. In islands of 200 contacts or more, four that share no block are visited at once, with the same
/// bits (lanes/pgs_lanes.h). Cost per sweep O(nc). Visited one by one, a contact with impulse takes about 25 ns and an
/// open one 7 ns.
/// Contraction per sweep: cos^2(pi/2n) for a column of n equal bodies, M/(M + m) for M on m: use it for loose packings.
/// Sources: Jourdan, Alart, Jean 1998 (Gauss-Seidel for frictional contact); Catto 2005 (rows on velocities); the disc
/// is the norm clamp of Simbody and Bullet, both rows stepped at once.
///
/// Nominal tolerances: 1e-6 m/s in simulations, 1e-10 m/s in tests. Islands are solved apart, each to its own stop.
#include "contact/solvers/shared/sweep_loop.h"
#include "contact/solvers/solver.h"

namespace nilas::solvers {

using PgsSettings = SweepSettings;

class PgsSolver final : public ContactSolver {
 public:
  explicit PgsSolver(const PgsSettings& settings) : settings_(settings) {}
  using ContactSolver::solve;
  std::string name() const override { return "pgs"; }
  /// converged: every island's law_map_m_s is at most the tolerance, as `measure` finds it on the impulses returned.
  /// With tolerance 0 nothing is measured and the status is iteration_limit.
  /// numerical_error: something is not finite, or a contact closes whose sides cannot move and that has no force limit;
  /// then `message` says which, and that contact's impulse is zero.
  /// Throws InputError for a law other than pyramid, coulomb or frictionless, and for rolling or spinning friction.
  contact::ContactSolution solve(const contact::PreparedProblem& problem, const VecX& guess) const override;
  /// The same sweeps on the rows of W.
  contact::ContactSolution solve(const contact::LocalProblem& problem, const VecX& guess) const override;

 private:
  PgsSettings settings_;
};

}  // namespace nilas::solvers
