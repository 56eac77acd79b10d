#pragma once
/// Self-adaptive extragradient on contact as a variational inequality, in mass-scaled variables.
///
///   F(r) = u + shift(u) n,  u = W r + q;  shift = mu |u_T| (coulomb), 0 (ccp, frictionless)
///   r- = P_K(r - rho D^-1 F(r)),   r <- P_K(r - rho D^-1 F(r-)),   D = diag(d_a), d_a = trace(W_aa)/3
///   r- is accepted when rho |F(r) - F(r-)|_{D^-1} <= 0.9 |r - r-|_D, else rho shrinks by 2/3 and r- is made anew;
///   rho grows by 3/2 when the ratio is below 0.3
///
/// Two products with W per iteration, O(nc) on a problem with bodies, O(blocks of W) on a local one; iterations grow
/// with the condition of W: for sliding ice and as a start for Newton's method, slow for stacks. W may be asymmetric.
/// Sources: Korpelevich 1976; Khobotov 1987 (the step); Acary, Bremond, Huber 2018 (the constants in friction).
///
/// Both products visit blocks and contacts independently, so large islands use all threads. With `order_free` every sum
/// is an OrderFreeSum: on problems with bodies, permuted contacts or bodies, swapped sides, mirror images and any
/// number of threads then give the same r, v and u to the last bit.
///
/// Laws: coulomb, ccp, pyramid-k, frictionless. Nominal tolerance 1e-8 m/s. Islands are solved apart.
#include "contact/solvers/solver.h"

namespace nilas::solvers {

struct EgSettings {
  contact::SolverSettings shared;
  int stall_iterations = 2000;  ///< window of the stall rule (best_impulses.h); share 0.999
  bool order_free = false;
};

class EgSolver final : public ContactSolver {
 public:
  explicit EgSolver(const EgSettings& settings) : settings_(settings) {}
  using ContactSolver::solve;
  std::string name() const override { return settings_.order_free ? "eg-order-free" : "eg"; }
  /// converged: law_map_m_s is at most the tolerance as `measure` finds it; else the best impulses measured. With
  /// tolerance 0 nothing is measured. numerical_error: input that is not finite, or a contact that cannot yield.
  /// Throws InputError for the law pyramid, whose bounds depend on r_N, and for rolling or spinning friction.
  contact::ContactSolution solve(const contact::PreparedProblem& problem, const VecX& guess) const override;
  contact::ContactSolution solve(const contact::LocalProblem& problem, const VecX& guess) const override;
  /// Solves as a stage of a solve in progress, within `budget`.
  contact::ContactSolution solve(const contact::PreparedProblem& problem, const VecX& guess,
                                 const Budget& budget) const;

 private:
  EgSettings settings_;
};

}  // namespace nilas::solvers
