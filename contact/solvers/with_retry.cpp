#include "contact/solvers/with_retry.h"

#include <cmath>

namespace nilas::solvers {

template <class Problem>
static contact::ContactSolution solve_with_both(const ContactSolver& first, const ContactSolver& second,
                                                const Problem& problem, const VecX& guess) {
  contact::ContactSolution solution = first.solve(problem, guess);
  if (solution.status == contact::SolveStatus::converged) return solution;
  contact::ContactSolution again = second.solve(problem, solution.r.allFinite() ? solution.r : VecX());
  const int iterations = solution.iterations + again.iterations;
  const double first_map = contact::measure(problem, solution.r).law_map_m_s,
               map = contact::measure(problem, again.r).law_map_m_s;
  const bool is_better = again.status == contact::SolveStatus::converged || map < first_map || std::isnan(first_map);
  if (is_better) solution = std::move(again);
  solution.iterations = iterations;
  solution.message = "retried with " + second.name() + (solution.message.empty() ? "" : ": " + solution.message);
  return solution;
}

contact::ContactSolution WithRetry::solve(const contact::PreparedProblem& problem, const VecX& guess) const {
  return solve_with_both(*first_, *second_, problem, guess);
}

contact::ContactSolution WithRetry::solve(const contact::LocalProblem& problem, const VecX& guess) const {
  return solve_with_both(*first_, *second_, problem, guess);
}

}  // namespace nilas::solvers
