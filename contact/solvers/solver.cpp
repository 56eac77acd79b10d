#include "contact/solvers/solver.h"

#include <algorithm>
#include <cmath>

#include "contact/problem/islands.h"
#include "contact/problem/operators.h"
#include "contact/problem/reducible.h"
#include "contact/problem/row_of.h"
#include "core/base/error.h"

namespace nilas::solvers {

namespace {

/// Adds one island's outcome to the whole.
void take_over(const contact::ContactSolution& part, const std::vector<int>& contacts,
               contact::ContactSolution& whole) {
  for (std::size_t i = 0; i < contacts.size(); ++i)
    whole.r.segment<3>(contact::row_of(contacts[i])) = part.r.segment<3>(contact::row_of(i));
  whole.status = contact::worse(whole.status, part.status);
  whole.iterations = std::max(whole.iterations, part.iterations);
  // islands that failed alike are named once
  if (whole.message.find(part.message) == std::string::npos)
    whole.message += (whole.message.empty() ? "" : "; ") + part.message;
  merge_history(part.history, whole.history);
}

VecX part_of(const VecX& guess, const std::vector<int>& contacts) {
  if (guess.size() == 0) return {};
  VecX part(contact::row_of(contacts.size()));
  for (std::size_t i = 0; i < contacts.size(); ++i)
    part.segment<3>(contact::row_of(i)) = guess.segment<3>(contact::row_of(contacts[i]));
  return part;
}

contact::ContactSolution nothing_solved(int num_contacts) {
  contact::ContactSolution whole;
  whole.r = VecX::Zero(contact::row_of(num_contacts));
  whole.status = contact::SolveStatus::converged;
  return whole;
}

/// Returns what makes a problem unfit for any solver; empty for a fit one.
std::string unfit(const contact::LocalProblem& problem, const VecX& guess) {
  bool finite = problem.q.allFinite() && guess.allFinite();
  for (const Mat3& block : problem.block) finite = finite && block.allFinite();
  for (std::size_t a = 0; a < problem.mu.size(); ++a) {
    finite = finite && std::isfinite(problem.mu[a]) && std::isfinite(problem.compliance[a]) &&
             std::isfinite(problem.tangential_compliance[a]);
    if (std::isnan(problem.force_limit[a])) return "a force limit is not a number";
  }
  if (!finite) return "the problem or the guess holds numbers that are not finite";
  for (int a = 0; a < problem.num_contacts(); ++a)
    if (problem.diagonal(a).trace() < 0)
      return "contact " + std::to_string(problem.key[a]) + " has a negative inverse mass";
  return "";
}

contact::ContactSolution failed(int num_contacts, const std::string& message) {
  contact::ContactSolution whole = nothing_solved(num_contacts);
  whole.status = contact::SolveStatus::numerical_error;
  whole.message = message;
  return whole;
}

contact::ContactSolution left_alone(const VecX& guess, const std::string& reason) {
  contact::ContactSolution part;
  part.r = guess;
  part.message = reason;
  return part;
}

/// Demotes a claim that does not hold on the problem itself: W r + q and M^-1 (f + H r) differ by rounding.
template <class Problem>
void confirm(const Problem& problem, double tolerance, contact::ContactSolution& solution) {
  if (solution.status == contact::SolveStatus::converged &&
      !(contact::measure(problem, solution.r).law_map_m_s <= tolerance))
    solution.status = contact::SolveStatus::stalled;
}

/// Sorts the islands by size, so that the hardest island is the one left unsolved when time runs out.
std::vector<std::vector<int>> smallest_first(std::vector<std::vector<int>> islands) {
  std::stable_sort(islands.begin(), islands.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  return islands;
}

}  // namespace

void merge_history(const std::vector<double>& part, std::vector<double>& whole) {
  const double last = whole.empty() ? 0 : whole.back();
  whole.resize(std::max(whole.size(), part.size()), last);
  for (std::size_t k = 0; k < whole.size() && !part.empty(); ++k)
    whole[k] = std::max(whole[k], part[std::min(k, part.size() - 1)]);
}

contact::SolverSettings with_margin(contact::SolverSettings shared) {
  constexpr double k_margin = 1e-3;
  shared.tolerance *= 1 - k_margin;
  return shared;
}

contact::ContactSolution solve_islands(const contact::LocalProblem& problem, const VecX& guess,
                                       const IslandSolve& solve) {
  NILAS_DEMAND(guess.size() == 0 || guess.size() == problem.q.size());
  if (const std::string reason = unfit(problem, guess); !reason.empty()) {
    contact::ContactSolution whole = failed(problem.num_contacts(), reason);
    whole.u = contact::contact_velocities(problem, whole.r);
    return whole;
  }
  contact::ContactSolution whole = nothing_solved(problem.num_contacts());
  const auto islands = smallest_first(contact::find_islands(problem));
  if (islands.size() == 1)
    take_over(solve(problem, guess), islands.front(), whole);
  else
    for (const auto& island : islands)
      take_over(solve(contact::select(problem, island), part_of(guess, island)), island, whole);
  whole.u = contact::contact_velocities(problem, whole.r);
  return whole;
}

contact::ContactSolution solve_islands(const contact::PreparedProblem& prepared,
                                       const std::vector<std::vector<int>>& islands, const VecX& guess,
                                       const IslandSolve& solve) {
  const contact::ContactProblem& problem = prepared.problem();
  const contact::MassInverse& masses = prepared.masses();
  NILAS_DEMAND(guess.size() == 0 || guess.size() == 3 * problem.num_contacts());
  contact::ContactSolution whole = nothing_solved(problem.num_contacts());
  if (masses.first_bad_block() >= 0) {
    whole = failed(problem.num_contacts(),
                   "mass block " + std::to_string(masses.first_bad_block()) + " is not positive definite");
  } else if (!problem.f.allFinite()) {
    whole = failed(problem.num_contacts(), "the momenta hold numbers that are not finite");
  } else {
    if (guess.size() > 0) whole.r = guess;
    for (const auto& island : smallest_first(islands))
      take_over(contact::is_reducible(problem, island)
                    ? solve_islands(contact::reduce(contact::select(problem, island)), part_of(guess, island), solve)
                    : left_alone(part_of(whole.r, island), contact::not_reducible_message(island)),
                island, whole);
  }
  whole.v = contact::velocities(prepared, whole.r);
  whole.u = contact::contact_velocities(problem, whole.v);
  return whole;
}

void demand_known(const char* solver, std::span<const Law> known, Law law) {
  if (std::find(known.begin(), known.end(), law) != known.end()) return;
  std::string laws;
  for (const Law one : known) laws += (laws.empty() ? "" : ", ") + std::string(contact::to_string(one));
  throw InputError("solver '" + std::string(solver) + "' knows the laws " + laws + "; choose one of them");
}

void demand_no_moments(const std::string& solver, const contact::ContactProblem& problem) {
  if (problem.has_moments())
    throw InputError("solver '" + solver + "' does not take rolling and spinning friction; nsgs and auto do");
}

contact::ContactSolution IslandSolver::solve(const contact::LocalProblem& problem, const VecX& guess) const {
  return solve(problem, guess, Budget(shared_));
}

contact::ContactSolution IslandSolver::solve(const contact::LocalProblem& problem, const VecX& guess,
                                             const Budget& budget) const {
  demand_law(problem.law);
  contact::ContactSolution solution =
      solve_islands(problem, guess, [&](const contact::LocalProblem& island, const VecX& start) {
        return solve_island(island, start, shared_, budget);
      });
  confirm(problem, shared_.tolerance, solution);
  return solution;
}

contact::ContactSolution IslandSolver::solve(const contact::PreparedProblem& problem, const VecX& guess) const {
  demand_law(problem.problem().law);
  demand_no_moments(name(), problem.problem());
  const contact::SolverSettings shared = with_margin(shared_);
  const Budget budget(shared_);
  contact::ContactSolution solution =
      solve_islands(problem, problem.islands(), guess, [&](const contact::LocalProblem& island, const VecX& start) {
        return solve_island(island, start, shared, budget);
      });
  confirm(problem, shared_.tolerance, solution);
  return solution;
}

}  // namespace nilas::solvers
