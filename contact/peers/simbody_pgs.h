#pragma once
/// Simbody's PGSImpulseSolver (over-relaxed projected Gauss-Seidel on a cone), for comparison only; built with
/// NILAS_PEER_SOLVERS. It works on a dense W, symmetric: islands above 1000 contacts are refused.
///
///   [A + D] pi = verr,  pi = -r,  verr = q,  A = (W + W^T)/2,  D the compliances;  law coulomb
/// Its own stop is a change of the iterate; `measure` decides what is converged. Library: Simbody 3.7.
#include "contact/solvers/solver.h"

namespace nilas::contact {

struct SimbodyPgsSettings {
  SolverSettings shared;
};

class SimbodyPgsSolver final : public solvers::IslandSolver {
 public:
  explicit SimbodyPgsSolver(const SimbodyPgsSettings& settings) : solvers::IslandSolver(settings.shared) {}
  std::string name() const override { return "simbody-pgs"; }
  /// It starts from zero: `guess` is not used. numerical_error: a finite force limit or too many contacts.
  ContactSolution solve_island(const LocalProblem& island, const VecX& guess, const SolverSettings& shared,
                               const solvers::Budget& budget) const override;

 private:
  void demand_law(Law law) const override;
};

}  // namespace nilas::contact
