#pragma once
/// Accelerated projected gradient with restart, in mass-scaled variables; Coulomb by De Saxce's outer loop.
///
///   inner (shifts s fixed, s = 0 for ccp): minimise r.W r/2 + (q + s n).r over K by Nesterov's steps
///     r+ = P_K(y - D^-1 (W y + q + s n)/L),  y = r+ + beta (r+ - r),  D = diag(d_a), d_a = trace(W_aa)/3
///     L grows until (r+ - y).W (r+ - y) <= L |r+ - y|_D^2 and is let fall by 2 % per iteration;
///     beta from theta+^2 = (1 - theta+) theta^2; restart (theta = 1) where the gradient at y points along r+ - r
///   outer: s <- mu |u_T| when the inner residual is a tenth of the outer one, with less weight when that made it worse
///
/// One product with W per iteration (W y is combined from those of r): O(nc) on a problem with bodies. Iterations grow
/// with sqrt(cond(W)) times the number of outer rounds. The outer loop contracts for small mu only; it is stalled
/// otherwise. A slightly asymmetric W is used as it is: the fixed points are those of the law.
/// Sources: Nesterov 1983; O'Donoghue, Candes 2015 (restart); Mazhar et al. 2015 (APGD); Acary, Bremond, Huber 2018
/// (the outer loop).
///
/// Laws: ccp, coulomb, pyramid-k, frictionless. Nominal tolerance 1e-8 m/s. Islands are solved apart.
#include "contact/solvers/solver.h"

namespace nilas::solvers {

struct ApgdSettings {
  contact::SolverSettings shared;
  int stall_iterations = 5000;  ///< window of the stall rule (best_impulses.h); share 0.999
};

class ApgdSolver final : public ContactSolver {
 public:
  explicit ApgdSolver(const ApgdSettings& settings) : settings_(settings) {}
  using ContactSolver::solve;
  std::string name() const override { return "apgd"; }
  /// Solves with the statuses and errors of EgSolver::solve.
  contact::ContactSolution solve(const contact::PreparedProblem& problem, const VecX& guess) const override;
  contact::ContactSolution solve(const contact::LocalProblem& problem, const VecX& guess) const override;
  /// Solves as a stage of a solve in progress, within `budget`.
  contact::ContactSolution solve(const contact::PreparedProblem& problem, const VecX& guess,
                                 const Budget& budget) const;

 private:
  ApgdSettings settings_;
};

}  // namespace nilas::solvers
