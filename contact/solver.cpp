#include "contact/solver.h"

#include <algorithm>

#include "core/base/error.h"

namespace nilas {

const char* to_string(SolveStatus status) {
  switch (status) {
    case SolveStatus::converged:
      return "converged";
    case SolveStatus::iteration_limit:
      return "iteration_limit";
    case SolveStatus::stalled:
      return "stalled";
    case SolveStatus::numerical_error:
      return "numerical_error";
  }
  return "unknown";
}

namespace {

/// Adds one island's outcome to the whole.
void take_over(const ContactSolution& part, const std::vector<int>& contacts, ContactSolution& whole) {
  for (std::size_t i = 0; i < contacts.size(); ++i)
    whole.r.segment<3>(3 * static_cast<Eigen::Index>(contacts[i])) =
        part.r.segment<3>(3 * static_cast<Eigen::Index>(i));
  whole.status = worse(whole.status, part.status);
  whole.iterations = std::max(whole.iterations, part.iterations);
  if (!part.message.empty()) whole.message += (whole.message.empty() ? "" : "; ") + part.message;
  // an island that stopped early keeps its last value
  const double last = whole.history.empty() ? 0 : whole.history.back();
  whole.history.resize(std::max(whole.history.size(), part.history.size()), last);
  for (std::size_t k = 0; k < whole.history.size() && !part.history.empty(); ++k)
    whole.history[k] = std::max(whole.history[k], part.history[std::min(k, part.history.size() - 1)]);
}

VecX part_of(const VecX& guess, const std::vector<int>& contacts) {
  if (guess.size() == 0) return {};
  VecX part(3 * static_cast<Eigen::Index>(contacts.size()));
  for (std::size_t i = 0; i < contacts.size(); ++i)
    part.segment<3>(3 * static_cast<Eigen::Index>(i)) = guess.segment<3>(3 * static_cast<Eigen::Index>(contacts[i]));
  return part;
}

ContactSolution nothing_solved(int num_contacts) {
  ContactSolution whole;
  whole.r = VecX::Zero(3 * static_cast<Eigen::Index>(num_contacts));
  whole.status = SolveStatus::converged;
  return whole;
}

}  // namespace

ContactSolution solve_islands(const LocalProblem& problem, const VecX& guess, const IslandSolve& solve) {
  ContactSolution whole = nothing_solved(problem.num_contacts());
  const auto islands = find_islands(problem);
  if (islands.size() == 1)
    take_over(solve(problem, guess), islands.front(), whole);
  else
    for (const auto& island : islands) take_over(solve(select(problem, island), part_of(guess, island)), island, whole);
  whole.u = contact_velocities(problem, whole.r);
  return whole;
}

ContactSolution solve_islands(const ContactProblem& problem, const VecX& guess, const IslandSolve& solve) {
  ContactSolution whole = solve_islands(reduce(problem), guess, solve);
  whole.v = velocities(problem, whole.r);
  whole.u = contact_velocities(problem, whole.v);
  return whole;
}

void demand_known(const char* solver, std::initializer_list<Law> known, Law law) {
  if (std::find(known.begin(), known.end(), law) != known.end()) return;
  std::string laws;
  for (const Law one : known) laws += (laws.empty() ? "" : ", ") + std::string(to_string(one));
  throw InputError("solver '" + std::string(solver) + "' knows the laws " + laws + "; choose one of them");
}

ContactSolution IslandSolver::solve(const LocalProblem& problem, const VecX& guess) const {
  NILAS_DEMAND(guess.size() == 0 || guess.size() == problem.q.size());
  demand_law(problem.law);
  return solve_islands(problem, guess,
                       [this](const LocalProblem& island, const VecX& start) { return solve_island(island, start); });
}

ContactSolution IslandSolver::solve(const ContactProblem& problem, const VecX& guess) const {
  NILAS_DEMAND(guess.size() == 0 || guess.size() == 3 * problem.num_contacts());
  demand_law(problem.law);
  return solve_islands(problem, guess,
                       [this](const LocalProblem& island, const VecX& start) { return solve_island(island, start); });
}

}  // namespace nilas
