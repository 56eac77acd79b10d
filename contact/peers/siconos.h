#pragma once
/// Solvers of Siconos numerics (Inria), for comparison only; built with NILAS_PEER_SOLVERS.
///
/// The whole problem goes over, as its users have it: W (as stored, with the compliances on its diagonal), q, mu;
/// law coulomb. Siconos stops on residuals relative to the largest number of the problem, so each solver is run down a
/// ladder of relative tolerances, 1e-4 to 1e-16, always from the guess, until `measure` finds law_map_m_s at most the
/// tolerance of `shared`. Source: Acary, Bremond, Huber 2018; the library is Debian's libsiconos-numerics.
#include "contact/solvers/solver.h"

namespace nilas::contact {

enum class SiconosMethod { nsgs, nsn_ac, prox, admm };

struct SiconosSettings {
  SolverSettings shared;  ///< max_iterations of each run; max_seconds is looked at between runs only
  SiconosMethod method = SiconosMethod::nsgs;
  double relative_tolerance = 0;  ///< Siconos' own, for a single run; 0: the ladder
};

class SiconosSolver final : public solvers::ContactSolver {
 public:
  explicit SiconosSolver(const SiconosSettings& settings) : settings_(settings) {}
  std::string name() const override;
  /// converged: law_map_m_s is at most the tolerance, whatever Siconos says. message: the relative tolerance that did
  /// it. numerical_error: a finite force limit, which Siconos does not know, or impulses that are not finite.
  using solvers::ContactSolver::solve;
  ContactSolution solve(const PreparedProblem& problem, const VecX& guess) const override;
  ContactSolution solve(const LocalProblem& problem, const VecX& guess) const override;

 private:
  SiconosSettings settings_;
};

}  // namespace nilas::contact
