#pragma once
/// A contact at rest holds up to mu_s r_N; one that slips has |r_T| = mu_k r_N. With one coefficient per contact the
/// problem is one of exact Coulomb friction (or of the law asked for). Contacts that slipped in the last step begin
/// with mu_k, all others with mu_s. Those that turn out to slip under mu_s get mu_k for the rest of the step. The
/// problem is then solved again from the impulses at hand, until no further contact starts to slip. A contact that
/// rests under mu_k has mu_s in the next step. The set of slipping contacts only grows within a step, so the iteration
/// ends.
#include <cstdint>
#include <vector>

#include "contact/solvers/solver.h"

namespace nilas::contact {

/// Keys of the contacts that slip, in rising order.
using SlippingContacts = std::vector<std::uint64_t>;

struct StaticFriction {
  /// Tangential speed above which a contact counts as slipping [m/s]. It must be above the solver's tolerance.
  double slip_speed = 1e-5;
  static constexpr int k_most_rounds = 20;
};

struct StaticFrictionSolution {
  ContactSolution solution;   ///< `iterations` counts all rounds
  SlippingContacts slipping;  ///< contacts that slip at this solution, for the next step
  int rounds = 0;             ///< number of solves
};

/// Solves the problem with the kinetic coefficient at the contacts that slipped in the last step. Leaves in
/// `problem.mu` the coefficient that each contact had, so that `measure` judges the solution by that problem. After
/// k_most_rounds the last solution stands, and its status is no better than stalled. `prepared` is of this `problem`
/// and serves all rounds.
StaticFrictionSolution solve_with_static_friction(const StaticFriction& friction, const solvers::ContactSolver& solver,
                                                  const VecX& guess, const SlippingContacts& slipped,
                                                  ContactProblem& problem, const PreparedProblem& prepared);
/// Prepares the problem first.
StaticFrictionSolution solve_with_static_friction(const StaticFriction& friction, const solvers::ContactSolver& solver,
                                                  const VecX& guess, const SlippingContacts& slipped,
                                                  ContactProblem& problem);

}  // namespace nilas::contact
