#pragma once
/// newton with bits that do not depend on the order of contacts and bodies nor, but for the sign, on a mirror.
///
/// Sums over contacts are OrderFreeSums, Newton's steps are solved to so many digits that rounding them forgets the
/// order of elimination (rounded_solve.h), and the residual is its own. Where Newton stops above the tolerance,
/// eg-order-free continues from there, and then Newton once more. The proximal weight does not fall below 1e-8, so that
/// the systems of hyperstatic contact stay regular enough for that.
///
/// Laws: coulomb, ccp, pyramid-k, frictionless. Nominal tolerance 1e-6 m/s. Islands are solved apart; cost per
/// iteration about three times that of newton.
#include "contact/solvers/solver.h"

namespace nilas::solvers {

class OrderFreeNewtonSolver final : public ContactSolver {
 public:
  explicit OrderFreeNewtonSolver(const contact::SolverSettings& shared) : shared_(shared) {}
  using ContactSolver::solve;
  std::string name() const override { return "newton-order-free"; }
  /// Solves with the statuses of newton. Throws InputError for the law pyramid and for rolling or spinning friction.
  /// iterations: factorisations of the island that took most, and steps of eg-order-free.
  contact::ContactSolution solve(const contact::PreparedProblem& problem, const VecX& guess) const override;
  /// The order of contacts does not show here either; Newton alone.
  contact::ContactSolution solve(const contact::LocalProblem& problem, const VecX& guess) const override;

 private:
  contact::SolverSettings shared_;
};

}  // namespace nilas::solvers
