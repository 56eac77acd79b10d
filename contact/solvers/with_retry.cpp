#include "contact/solvers/with_retry.h"

namespace nilas {

template <class Problem>
static ContactSolution solve_with_both(const ContactSolver& first, const ContactSolver& second, const Problem& problem,
                                       const VecX& guess) {
  ContactSolution solution = first.solve(problem, guess);
  if (solution.status == SolveStatus::converged) return solution;
  ContactSolution again = second.solve(problem, solution.r.allFinite() ? solution.r : VecX());
  const int iterations = solution.iterations + again.iterations;
  const bool is_better = again.status == SolveStatus::converged ||
                         !(measure(problem, solution.r).law_map_m_s <= measure(problem, again.r).law_map_m_s);
  if (is_better) solution = std::move(again);
  solution.iterations = iterations;
  solution.message = "retried with " + second.name() + (solution.message.empty() ? "" : ": " + solution.message);
  return solution;
}

ContactSolution WithRetry::solve(const ContactProblem& problem, const VecX& guess) const {
  return solve_with_both(*first_, *second_, problem, guess);
}

ContactSolution WithRetry::solve(const LocalProblem& problem, const VecX& guess) const {
  return solve_with_both(*first_, *second_, problem, guess);
}

}  // namespace nilas
