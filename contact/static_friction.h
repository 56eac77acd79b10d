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
#include "core/base/state.h"

namespace nilas {

class StaticFriction {
 public:
  /// `slip_speed`: a contact faster than this slips [m/s]; keep it above the solver's tolerance.
  explicit StaticFriction(double slip_speed = 1e-5) : slip_speed_(slip_speed) {}

  /// Solves, remembers which keys slip, and leaves in `problem.mu` the coefficient that each contact had: the solution
  /// is one of that problem, and `measure` judges it. `iterations` counts all rounds; after `k_most_rounds` the last
  /// solution stands, and its status is no better than stalled.
  ContactSolution solve(const ContactSolver& solver, const VecX& guess, ContactProblem& problem);

  int rounds() const { return rounds_; }  ///< solves that the last step took
  static constexpr int k_most_rounds = 20;

  /// Which keys slipped in the last step.
  void save(StateWriter out) const { out.add("slipped", slipped_); }
  void restore(const StateReader& in) { in.get("slipped", slipped_); }

 private:
  double slip_speed_;
  int rounds_ = 0;
  std::vector<std::uint64_t> slipped_;  ///< keys of the last step, rising
};

}  // namespace nilas
