#pragma once
/// The islands of a problem with bodies solved apart on its rows, without ever forming W: a product costs O(nc).
#include <functional>

#include "contact/problem/prepared_problem.h"
#include "contact/problem/solution.h"
#include "contact/solvers/shared/pgs_rows.h"
#include "contact/solvers/shared/row_residual.h"

namespace nilas::solvers {

/// The data that a solver gets of one island. It leaves its impulses in rows.contacts of the island.
struct RowIsland {
  const contact::ContactProblem& problem;
  const contact::MassInverse& masses;
  PgsRows& rows;
  const PgsIsland& island;
  RowResidual& residual;
  int threads;  ///< threads for work within the island
};

/// A solver of one island; `r`, `v` and `u` of its solution are not read.
using RowSolve = std::function<contact::ContactSolution(const RowIsland& island)>;

/// Sets the rows up with the guess made admissible, calls `solve` for every island (in parallel, each with its own
/// data) and gathers: the worst status, the most iterations, the first message. numerical_error where input or
/// impulses are not finite, a mass is not positive definite, or a contact closes whose sides cannot move and that has
/// no force limit. Throws ContractError for a guess of the wrong size.
contact::ContactSolution solve_row_islands(const contact::PreparedProblem& prepared, const VecX& guess,
                                           const contact::SolverSettings& shared, RowOrder order,
                                           const RowSolve& solve);

}  // namespace nilas::solvers
