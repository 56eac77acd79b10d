#pragma once
/// Continuation in friction. Where newton does not converge at the full coefficients, the solution is followed from
/// small ones.
///
///   s = 0.2:  200 sweeps of nsgs, then newton, with s mu for mu;  s <- s + h from the solution at s, h = 0.1 at first,
///   times 1.5 after a success and times 0.4 after a failure, until s = 1 or h < 1e-3
///
/// Small friction is easy: the law comes near a convex problem, and Gauss-Seidel and Newton agree on it. Cost: a few to
/// a few dozen solves by newton of some hundred factorisations each. For piles with large mu and redundant contacts.
/// Source: Allgower & Georg 1990 (numerical continuation).
#include "contact/solvers/newton.h"

namespace nilas::solvers {

/// One island. iterations: factorisations and sweeps of all solves, at most those of the budget. The impulses
/// are those of the largest s that was solved, or of the sweeps where newton fails at s = 0.2; converged only at s = 1.
contact::ContactSolution continue_in_friction(const contact::LocalProblem& island, const NewtonSettings& settings,
                                              const Budget& budget);

}  // namespace nilas::solvers
