#pragma once
/// Static friction above kinetic friction, around any solver.
///
/// A contact at rest holds up to mu_s r_N; one that slips has |r_T| = mu_k r_N. With a coefficient per contact the
/// problem is one of exact Coulomb (or of the law asked): contacts that slipped in the last step begin with mu_k, all
/// others with mu_s; those that turn out to slip under mu_s get mu_k for the rest of the step, and the problem is
/// solved again from the impulses at hand, until no further contact starts to slip. What rests under mu_k has mu_s in
/// the next step. The set of slipping contacts only grows within a step, so this ends.
#include <cstdint>
#include <vector>

#include "contact/solvers/solver.h"

namespace nilas {

/// Keys of the contacts that slip, in rising order.
using SlippingContacts = std::vector<std::uint64_t>;

struct StaticFriction {
  /// A contact faster than this slips; above the solver's tolerance [m/s].
  double slip_speed = 1e-5;
  static constexpr int k_most_rounds = 20;
};

struct StaticFrictionSolution {
  ContactSolution solution;   ///< `iterations` counts all rounds
  SlippingContacts slipping;  ///< at this solution, for the next step
  int rounds = 0;             ///< solves that it took
};

/// Solves from the contacts that slipped in the last step, and leaves in `problem.mu` the coefficient that each contact
/// had: the solution is one of that problem, and `measure` judges it. After k_most_rounds the last solution stands, and
/// its status is no better than stalled.
StaticFrictionSolution solve_with_static_friction(const StaticFriction& friction, const ContactSolver& solver,
                                                  const VecX& guess, const SlippingContacts& slipped,
                                                  ContactProblem& problem);

}  // namespace nilas
