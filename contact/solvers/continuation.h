#pragma once
/// Continuation in friction. Where newton does not converge at the full coefficients, the solution is followed from
/// small ones.
#include "contact/solvers/newton.h"

namespace nilas {

/// One island. iterations: factorisations and sweeps of all solves, at most those of the budget. The impulses
/// are those of the largest s that was solved; converged only at s = 1.
ContactSolution continue_in_friction(const LocalProblem& island, const NewtonSettings& settings, const Budget& budget);

}  // namespace nilas
