#pragma once
/// Small dense systems of nonlinear equations, by KINSOL: Newton's method with line search.
#include <functional>
#include <string>

#include "core/base/math.h"

namespace nilas::numerics {

/// f(x) = 0 with as many equations as unknowns, both scaled so that 1 is a large change.
using NonlinearEquations = std::function<void(const VecX& x, VecX& f)>;

struct NonlinearSettings {
  double tolerance = 1e-13;  ///< limit of the largest |f_i|
  double accepted = 1e-10;   ///< limit where rounding prevents steps to `tolerance`
  double longest_step = 1;   ///< largest step of |x| in one iteration
  int max_iterations = 200;
};

struct NonlinearSolution {
  VecX x;
  double residual = 0;  ///< largest |f_i| at x
  bool converged = false;
  int iterations = 0;
  std::string message;  ///< the solver's message where it did not converge
};

/// Newton's method from `start`, the Jacobian by differences. Never throws for non-convergence; throws ContractError
/// for an empty start.
NonlinearSolution solve_nonlinear(const NonlinearEquations& equations, const VecX& start,
                                  const NonlinearSettings& settings = {});

}  // namespace nilas::numerics
