#include "contact/static_friction.h"

#include <algorithm>
#include <cmath>

namespace nilas {

static double slip_of(const ContactSolution& solution, std::size_t c) {
  const auto first = 3 * static_cast<Eigen::Index>(c);
  return std::hypot(solution.u[first + 1], solution.u[first + 2]);
}

ContactSolution StaticFriction::solve(const ContactSolver& solver, const VecX& guess, ContactProblem& problem) {
  const std::vector<double> kinetic = problem.mu;
  for (std::size_t c = 0; c < kinetic.size(); ++c)
    if (!std::binary_search(slipped_.begin(), slipped_.end(), problem.key[c])) problem.mu[c] = problem.mu_static[c];
  ContactSolution solution;
  VecX start = guess;
  int iterations = 0;
  bool settled = false;
  for (rounds_ = 0; rounds_ < k_most_rounds && !settled;) {
    ++rounds_;
    solution = solver.solve(problem, start);
    iterations += solution.iterations;
    if (solution.status == SolveStatus::numerical_error) break;
    start = solution.r;
    std::vector<std::size_t> loose;
    for (std::size_t c = 0; c < kinetic.size(); ++c)
      if (problem.mu[c] > kinetic[c] && slip_of(solution, c) > slip_speed_) loose.push_back(c);
    settled = loose.empty();
    if (rounds_ < k_most_rounds)
      for (const std::size_t c : loose) problem.mu[c] = kinetic[c];
  }
  solution.iterations = iterations;
  if (!settled) solution.status = worse(solution.status, SolveStatus::stalled);
  slipped_.clear();
  for (std::size_t c = 0; c < kinetic.size(); ++c)
    if (slip_of(solution, c) > slip_speed_) slipped_.push_back(problem.key[c]);
  std::sort(slipped_.begin(), slipped_.end());
  return solution;
}

}  // namespace nilas
