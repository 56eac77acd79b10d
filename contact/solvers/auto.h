#pragma once
/// The default: climbs a ladder of solvers, island by island, until the tolerance is reached, and reports the rungs
/// used.
///
///   0  the guess itself, measured
///   1  nsgs, 20 sweeps: enough for loose contact, and the state of most contacts for the next rung. Problems with
///      bodies are swept on their velocities, without W; only what is left is reduced to W. With a guess up to 250
///      sweeps with momentum, as long as they promise to suffice (SweepSettings::horizon). Of islands of 200 contacts
///      or more the contacts that close climb on alone where they fall apart (closing_contacts.h), and all others after
///      them
///   2  for laws with cones and problems with bodies: interior point, then newton or, for loose tolerances, sweeps, on
///      the bodies (body_ladder.h), without W; in jams, with mass ratios and force limits this is what solves. It is
///      the last rung of islands of 1500 contacts or more that the bodies take: the next ones find the same steps from
///      W, at four times the cost. Smaller islands leave rung 4 its 200 factorisations, as long as the bodies have 600
///      iterations: where force limits differ by many decades, newton on W reaches residuals that newton on the bodies
///      does not
///   3  from cold and for laws that admm knows, where the sweeps of rung 1 left more than a hundredth of the residual
///      of no impulses and three contacts in ten stick, as in tall stacks: admm from no impulses, one factorisation, as
///      long as two iterations leave less than a fifth
///   4  newton: little proximal weight for a local problem with a guess, else more
///   5  nsgs, 500 sweeps from the best so far, but at most a quarter of the iterations left; then newton with more
///      weight, and at most half of what is left
///   6  continuation in friction (continuation.h), for laws with friction
///   7  ipm (laws coulomb, ccp, frictionless), then newton from there
///
/// Islands whose W is too large to be formed or factorised (contact/problem/reducible.h) have rungs 1 and 2, then half
/// of the iterations left nsgs and the rest apgd, which does not know the law pyramid. Problems with rolling or
/// spinning friction have rung 1 alone, without its limit. Every rung except 3 and 6, which start from no impulses,
/// starts from the best impulses so far in law_map_m_s. The best of all rungs are returned. What decides is the
/// residual, and for rung 3 the share that sticks. Cost: that of nsgs for loose fields, two to four dozen
/// factorisations of the bodies for stacks, jams and mass ratios. Laws: all.
///
/// Nominal tolerances: 1e-6 m/s in simulations, 1e-10 m/s as a reference. `message` names each rung that was used, on
/// how many islands, and the most iterations that one island took of it.
#include "contact/solvers/solver.h"

namespace nilas::solvers {

struct AutoSettings {
  contact::SolverSettings shared;  ///< max_iterations counts sweeps and factorisations of an island together
  int first_sweeps = 20;
  int warm_sweeps = 250;          ///< sweeps of rung 1 with bodies and a guess, at most half of all iterations
  int jam_contacts = 1500;        ///< contacts of an island from which on the rungs on W are left out
  double stiff_share = 0.01;      ///< share of the residual of no impulses above which an island goes to rung 3 ...
  double sticking_share = 0.3;    ///< ... where at least this share of its contacts sticks
  double stiff_least_fall = 0.2;  ///< AdmmSettings::least_fall there
  int body_iterations = 600;      ///< iterations up to which rung 2 leaves none to rung 4
  int more_sweeps = 500;
  int first_factorisations = 200;  ///< factorisations of newton in rung 4 and after ipm
  int more_factorisations = 400;   ///< factorisations of newton in rung 5
  int path_factorisations = 1500;  ///< factorisations of newton for each friction of rung 6
  int ipm_factorisations = 200;
};

class AutoSolver final : public ContactSolver {
 public:
  explicit AutoSolver(const AutoSettings& settings) : settings_(settings) {}
  using ContactSolver::solve;
  std::string name() const override { return "auto"; }
  /// converged: every island's law_map_m_s is at most the tolerance, as `measure` finds it on the impulses returned.
  /// Otherwise the status of the last rung.
  contact::ContactSolution solve(const contact::PreparedProblem& problem, const VecX& guess) const override;
  contact::ContactSolution solve(const contact::LocalProblem& problem, const VecX& guess) const override;

 private:
  AutoSettings settings_;
};

}  // namespace nilas::solvers
