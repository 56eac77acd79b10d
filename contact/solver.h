#pragma once
/// What every contact solver is: a pure function from a problem and a guess to a solution.
#include <chrono>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/local_problem.h"
#include "contact/measure.h"
#include "contact/problem.h"

namespace nilas {

enum class SolveStatus { converged, iteration_limit, stalled, numerical_error };
const char* to_string(SolveStatus status);

struct ContactSolution {
  VecX r;  ///< 3 nc impulses on body B in the contact frame [N s]
  VecX v;  ///< nv velocities with r applied
  VecX u;  ///< 3 nc, H^T v + w [m/s]
  SolveStatus status = SolveStatus::numerical_error;
  int iterations = 0;
  std::vector<double> history;  ///< law_map_m_s after each iteration, when asked for
  std::string message;          ///< what failed and at which contact key; for auto what it used; else empty
};

/// Settings that all solvers share; a solver's own settings are a struct in its header.
struct SolverSettings {
  using Clock = std::chrono::steady_clock;

  double tolerance = 1e-6;  ///< on law_map_m_s [m/s]; 0: sweeps do all max_iterations, others go on until they stall
  int max_iterations = 1000;
  double max_seconds = 0;  ///< stop with iteration_limit after this wall time; 0: no limit [s]
  bool keep_history = false;
  int threads = 1;
  std::optional<Clock::time_point> deadline{};  ///< of a solve that runs; its islands and stages share it

  /// These settings for a solve that begins now, unless it has begun already.
  SolverSettings started() const;
  bool out_of_time() const { return deadline && Clock::now() >= *deadline; }
};

class ContactSolver {
 public:
  virtual ~ContactSolver() = default;
  virtual std::string name() const = 0;
  /// Same arguments, same bits. Never throws for non-convergence. `guess`: 3 nc impulses, or empty.
  virtual ContactSolution solve(const ContactProblem& problem, const VecX& guess) const = 0;
  /// The same for a problem without bodies; `v` stays empty.
  virtual ContactSolution solve(const LocalProblem& problem, const VecX& guess) const = 0;
};

/// Solves one connected local problem.
using IslandSolve = std::function<ContactSolution(const LocalProblem& island, const VecX& guess)>;

/// Solves the islands of a problem apart and puts them together: the worst status, the most iterations, the sum of
/// messages. `v` (of a problem with bodies) is M^-1 (f + H r), `u` follows from it or from W. numerical_error without
/// calling `solve` where problem or guess hold numbers that are not finite, a mass that is not positive definite or a
/// negative diagonal of W. Throws ContractError for a guess of the wrong size.
ContactSolution solve_islands(const LocalProblem& problem, const VecX& guess, const IslandSolve& solve);
/// Of a problem with bodies only the islands given (contact/islands.h) are reduced, one at a time, and solved; all
/// other contacts keep the impulses of `guess`.
ContactSolution solve_islands(const ContactProblem& problem, const std::vector<std::vector<int>>& islands,
                              const VecX& guess, const IslandSolve& solve);

/// Throws InputError naming the laws that a solver knows where `law` is none of them.
void demand_known(const char* solver, std::initializer_list<Law> known, Law law);

/// Throws InputError naming the solvers that take rolling and spinning friction where the problem has it.
void demand_no_moments(const std::string& solver, const ContactProblem& problem);

/// A solver that reduces every problem to its islands' local form. It says converged only of what `measure` confirms on
/// the whole problem.
class IslandSolver : public ContactSolver {
 public:
  explicit IslandSolver(const SolverSettings& shared) : shared_(shared) {}
  ContactSolution solve(const ContactProblem& problem, const VecX& guess) const final;
  ContactSolution solve(const LocalProblem& problem, const VecX& guess) const final;

 private:
  /// Throws InputError for a law it does not know.
  virtual void demand_law(Law) const {}
  /// `shared`: to be used in place of the solver's own.
  virtual ContactSolution solve_island(const LocalProblem& island, const VecX& guess,
                                       const SolverSettings& shared) const = 0;

  SolverSettings shared_;
};

/// A tolerance a thousandth tighter, for problems with bodies that are solved on their reduced form: the two forms
/// differ by rounding.
SolverSettings with_margin(SolverSettings shared);

/// The graver of two statuses, in the order of the enumeration.
inline SolveStatus worse(SolveStatus a, SolveStatus b) { return a < b ? b : a; }

}  // namespace nilas
