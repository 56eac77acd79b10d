#include "contact/static_friction.h"

#include <algorithm>
#include <cmath>

#include "contact/law/law_map.h"
#include "contact/problem/row_of.h"

namespace nilas::contact {

static double slip_of(const ContactProblem& problem, const ContactSolution& solution, std::size_t c) {
  const auto first = row_of(c);
  const Vec3 u =
      compliant_velocity(problem, static_cast<int>(c), solution.r.segment<3>(first), solution.u.segment<3>(first));
  return std::hypot(u[1], u[2]);
}

static SlippingContacts slipping_contacts(const StaticFriction& friction, const ContactProblem& problem,
                                          const ContactSolution& solution) {
  SlippingContacts slipping;
  for (std::size_t c = 0; c < problem.key.size(); ++c)
    if (slip_of(problem, solution, c) > friction.slip_speed) slipping.push_back(problem.key[c]);
  std::sort(slipping.begin(), slipping.end());
  return slipping;
}

StaticFrictionSolution solve_with_static_friction(const StaticFriction& friction, const solvers::ContactSolver& solver,
                                                  const VecX& guess, const SlippingContacts& slipped,
                                                  ContactProblem& problem, const PreparedProblem& prepared) {
  const std::vector<double> kinetic = problem.mu;
  for (std::size_t c = 0; c < kinetic.size(); ++c)
    if (!std::binary_search(slipped.begin(), slipped.end(), problem.key[c])) problem.mu[c] = problem.mu_static[c];
  StaticFrictionSolution out;
  VecX start = guess;
  int iterations = 0;
  bool settled = false;
  while (out.rounds < StaticFriction::k_most_rounds && !settled) {
    ++out.rounds;
    out.solution = solver.solve(prepared, start);
    iterations += out.solution.iterations;
    if (out.solution.status == SolveStatus::numerical_error) break;
    start = out.solution.r;
    std::vector<std::size_t> loose;
    for (std::size_t c = 0; c < kinetic.size(); ++c)
      if (problem.mu[c] > kinetic[c] && slip_of(problem, out.solution, c) > friction.slip_speed) loose.push_back(c);
    settled = loose.empty();
    if (out.rounds < StaticFriction::k_most_rounds)
      for (const std::size_t c : loose) problem.mu[c] = kinetic[c];
  }
  out.solution.iterations = iterations;
  if (!settled) out.solution.status = worse(out.solution.status, SolveStatus::stalled);
  out.slipping = slipping_contacts(friction, problem, out.solution);
  return out;
}

StaticFrictionSolution solve_with_static_friction(const StaticFriction& friction, const solvers::ContactSolver& solver,
                                                  const VecX& guess, const SlippingContacts& slipped,
                                                  ContactProblem& problem) {
  return solve_with_static_friction(friction, solver, guess, slipped, problem, PreparedProblem(problem));
}

}  // namespace nilas::contact
