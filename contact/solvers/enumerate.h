#pragma once
/// Brute force over the states of at most 8 contacts: an oracle for tests, slow and sure in what it accepts.
///
///   open: r = 0;   stick: u = 0;   slip: u_N = 0 (ccp: u_N = mu |u_T|),  mu r_N u_T + |u_T| r_T = 0
///   with a force limit also stick and slip at r_N = limit, where u_N <= 0 is free; frictionless: open or u_N = 0
///
/// Every combination is a square system in the impulses of its closed contacts, solved by Newton's method from several
/// slip directions with least-squares steps of least length. The first answer that `measure` finds within the tolerance
/// is returned, combinations with more open contacts first. It can show that an answer exists, independent of any
/// iteration that the other solvers share. It cannot: prove that none exists (Newton may miss a direction; where
/// sticking contacts are hyperstatic only the least impulses are looked at, and these may leave the cone while others
/// would not), nor find all answers. Cost: up to 3^n (5^n with limits) systems of 3 n unknowns; milliseconds for 4
/// contacts, seconds for 8. Source: pivoting through all bases, as in Al-Fahed, Stavroulakis, Panagiotopoulos 1991.
///
/// Laws: coulomb, ccp, frictionless. Nominal tolerance 1e-10 m/s. Islands are solved apart.
#include "contact/solvers/solver.h"

namespace nilas::solvers {

struct EnumerateSettings {
  contact::SolverSettings shared;
};

class EnumerateSolver final : public IslandSolver {
 public:
  explicit EnumerateSolver(const EnumerateSettings& settings) : IslandSolver(settings.shared), settings_(settings) {}
  std::string name() const override { return "enumerate"; }
  /// iterations: combinations tried, whatever max_iterations says. stalled: none within the tolerance, the best is
  /// returned. numerical_error: an island of more than 8 contacts, or one that cannot yield. `guess` is not used.
  /// Throws InputError for the pyramid laws.
  void demand_law(Law law) const override;
  contact::ContactSolution solve_island(const contact::LocalProblem& island, const VecX& guess,
                                        const contact::SolverSettings& shared, const Budget& budget) const override;

 private:
  EnumerateSettings settings_;
};

}  // namespace nilas::solvers
