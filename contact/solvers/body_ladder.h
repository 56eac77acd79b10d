#pragma once
/// The rungs of auto that work on the bodies of one island: interior point, then Newton from where it ends, or
/// sweeps where the tolerance is loose.
#include <optional>

#include "contact/problem/prepared_problem.h"
#include "contact/solvers/shared/budget.h"

namespace nilas::solvers {

/// Whether an island can be solved on its bodies: laws coulomb, ccp and frictionless, masses that have a root, numbers
/// that are finite, no contact whose two sides cannot move, and no tangential compliance.
bool fits_bodies(const contact::PreparedProblem& island);

struct BodyOutcome {
  VecX r;                       ///< the best impulses, those given included
  double law_map_m_s = 0;       ///< their residual
  int interior = 0;             ///< iterations of the interior point
  int sweeps = 0;               ///< of nsgs from where the interior point ended
  int newton = 0;               ///< factorisations of Newton
  std::vector<double> history;  ///< residual after each of them, when asked for [m/s]
  bool has_converged = false;
};

/// Islands of fewer contacts than this use one thread, and are solved at the same time as each other [-].
constexpr int k_large_on_bodies = 1000;

/// `guess`: 3 nc impulses, or empty. Nothing for an island that does not fit, whose factors would be too large
/// (node_plan.h), or that W takes in less time, since few of its contacts close.
std::optional<BodyOutcome> solve_on_bodies(const contact::PreparedProblem& island, const VecX& guess,
                                           const contact::SolverSettings& settings, const Budget& budget);

}  // namespace nilas::solvers
