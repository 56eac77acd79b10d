#pragma once
/// Small dense convex quadratic programs, by ALGLIB (QuickQP for bounds alone, its interior point method otherwise).
#include <string>

#include "core/base/math.h"

namespace nilas::numerics {

/// min 1/2 x^T H x + g^T x  subject to  lower <= x <= upper  and  least <= A x <= most. H is symmetric positive
/// definite. Unknowns are scaled so that 1 is a large change. `rows` may have no rows.
struct QuadraticProgram {
  MatX H;
  VecX g;
  VecX lower, upper;
  MatX rows;         ///< A
  VecX least, most;  ///< as many as rows of A; entries may be infinite
};

struct QuadraticSolution {
  VecX x;
  bool converged = false;
  std::string message;  ///< the solver's message where it did not converge
};

/// Never throws for non-convergence; throws ContractError where sizes do not fit or a lower bound exceeds the upper.
/// The same input gives the same bits on one machine. Cost: O(n^3) in about 5 to 30 iterations.
QuadraticSolution solve_quadratic_program(const QuadraticProgram& program);

/// 1/2 x^T H x + g^T x.
double objective(const QuadraticProgram& program, const VecX& x);

}  // namespace nilas::numerics
