#include "contact/solvers/newton_order_free.h"

#include "contact/solvers/eg.h"
#include "contact/solvers/newton.h"
#include "contact/solvers/shared/law_cone.h"
#include "contact/solvers/shared/order_free_velocities.h"

namespace nilas::solvers {

namespace {

/// Newton's systems then have a condition of 1e8 at most, where nothing else limits it [-].
constexpr double k_least_proximal_weight = 1e-8;

IslandSolve island_solve(const contact::SolverSettings& shared, const Budget& budget) {
  NewtonSettings settings;
  settings.shared = shared;
  settings.least_weight = k_least_proximal_weight;
  settings.order_free = true;
  return [settings, budget](const contact::LocalProblem& island, const VecX& start) {
    return newton_island(island, start, settings, budget);
  };
}

}  // namespace

contact::ContactSolution OrderFreeNewtonSolver::solve(const contact::PreparedProblem& problem,
                                                      const VecX& guess) const {
  demand_known("newton-order-free", k_convex_laws, problem.problem().law);
  demand_no_moments(name(), problem.problem());
  const Budget budget(shared_);
  const auto newton = [&](const VecX& start) {
    return solve_islands(problem, problem.islands(), start, island_solve(with_margin(shared_), budget));
  };
  contact::ContactSolution solution = newton(guess);
  // where not one step was taken the problem itself is at fault
  if (solution.status != contact::SolveStatus::converged &&
      (solution.status != contact::SolveStatus::numerical_error || solution.iterations > 0)) {
    const contact::ContactSolution nearer =
        EgSolver({.shared = shared_, .order_free = true}).solve(problem, solution.r, budget);
    const int done = solution.iterations + nearer.iterations;
    solution = newton(nearer.r);
    solution.iterations += done;
  }
  solution.v = order_free_velocities(problem, solution.r);
  solution.u = contact::contact_velocities(problem.problem(), solution.v);
  return solution;
}

contact::ContactSolution OrderFreeNewtonSolver::solve(const contact::LocalProblem& problem, const VecX& guess) const {
  demand_known("newton-order-free", k_convex_laws, problem.law);
  return solve_islands(problem, guess, island_solve(shared_, Budget(shared_)));
}

}  // namespace nilas::solvers
