#pragma once
/// The interface of all contact solvers: a pure function from a problem and a guess to a solution.
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "contact/measure/measure.h"
#include "contact/problem/local_problem.h"
#include "contact/problem/problem.h"
#include "contact/problem/solution.h"
#include "contact/solvers/shared/budget.h"

namespace nilas::solvers {

class ContactSolver {
 public:
  virtual ~ContactSolver() = default;
  virtual std::string name() const = 0;
  /// Same arguments, same bits. Never throws for non-convergence. `guess`: 3 nc impulses, or empty.
  virtual contact::ContactSolution solve(const contact::PreparedProblem& problem, const VecX& guess) const = 0;
  /// The same for a problem without bodies; `v` stays empty.
  virtual contact::ContactSolution solve(const contact::LocalProblem& problem, const VecX& guess) const = 0;
  /// Prepares the problem and solves it.
  contact::ContactSolution solve(const contact::ContactProblem& problem, const VecX& guess) const {
    return solve(contact::PreparedProblem(problem), guess);
  }
};

/// Solves one connected local problem.
using IslandSolve = std::function<contact::ContactSolution(const contact::LocalProblem& island, const VecX& guess)>;

/// Solves the islands of a problem apart and puts them together: the worst status, the most iterations, the sum of
/// messages. `v` (of a problem with bodies) is M^-1 (f + H r), `u` follows from it or from W. numerical_error without
/// calling `solve` where problem or guess hold numbers that are not finite, a mass that is not positive definite or a
/// negative diagonal of W. Throws ContractError for a guess of the wrong size.
contact::ContactSolution solve_islands(const contact::LocalProblem& problem, const VecX& guess,
                                       const IslandSolve& solve);
/// Solves a problem with bodies. Only the islands given (contact/problem/islands.h) are reduced, one at a time, and
/// solved. All other contacts keep the impulses of `guess`. So does an island that is not reducible
/// (contact/problem/reducible.h), whose status is numerical_error.
contact::ContactSolution solve_islands(const contact::PreparedProblem& problem,
                                       const std::vector<std::vector<int>>& islands, const VecX& guess,
                                       const IslandSolve& solve);

/// Merges the history of one island into that of the whole: the larger residual of each iteration, where an island that
/// stopped early keeps its last one.
void merge_history(const std::vector<double>& part, std::vector<double>& whole);

/// Throws InputError naming the laws that a solver knows where `law` is none of them.
void demand_known(const char* solver, std::span<const Law> known, Law law);

/// Throws InputError naming the solvers that take rolling and spinning friction where the problem has it.
void demand_no_moments(const std::string& solver, const contact::ContactProblem& problem);

/// A solver that reduces every problem to its islands' local form. It says converged only of what `measure` confirms on
/// the whole problem. Throws InputError for rolling or spinning friction.
class IslandSolver : public ContactSolver {
 public:
  explicit IslandSolver(const contact::SolverSettings& shared) : shared_(shared) {}
  using ContactSolver::solve;
  contact::ContactSolution solve(const contact::PreparedProblem& problem, const VecX& guess) const final;
  contact::ContactSolution solve(const contact::LocalProblem& problem, const VecX& guess) const final;
  /// Solves as a stage of a solve in progress, within `budget`.
  contact::ContactSolution solve(const contact::LocalProblem& problem, const VecX& guess, const Budget& budget) const;

 private:
  /// Throws InputError for a law it does not know.
  virtual void demand_law(Law) const {}
  /// `shared`: to be used in place of the solver's own, `budget` in place of its limits.
  virtual contact::ContactSolution solve_island(const contact::LocalProblem& island, const VecX& guess,
                                                const contact::SolverSettings& shared, const Budget& budget) const = 0;

  contact::SolverSettings shared_;
};

/// A tolerance a thousandth tighter, for problems with bodies that are solved on their reduced form: the two forms
/// differ by rounding.
contact::SolverSettings with_margin(contact::SolverSettings shared);

}  // namespace nilas::solvers
