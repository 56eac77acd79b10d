#pragma once
/// The residual of sweeps over a problem with bodies, from the impulses alone.
#include <string>

#include "contact/problem/local_problem.h"
#include "contact/solvers/shared/pgs_rows.h"

namespace nilas::solvers {

/// Islands of fewer contacts are solved side by side, larger ones one after another with all threads inside.
constexpr int k_large_island = 1000;

/// One solve's true velocities. Islands touch different parts, so small ones may be asked from different threads.
class RowResidual {
 public:
  /// `threads`: of the work on one large island.
  RowResidual(const contact::ContactProblem& problem, const contact::MassInverse& masses, int threads)
      : problem_(problem),
        masses_(masses),
        threads_(threads),
        momentum_(VecX::Zero(problem.num_velocities())),
        v_(momentum_) {}

  /// law_map of the island with velocities M^-1 (f + H r) [m/s], as `measure` has it.
  double law_map(const PgsRows& rows, const PgsIsland& island);
  /// Sets the sweeps' velocities to those last computed, free of accumulated rounding.
  void correct(PgsRows& rows, const PgsIsland& island) const;

  /// A contact that closes faster than `tolerance` although nothing can move and no limit says what to do.
  struct Culprit {
    int contact = -1;  ///< contact of the problem; -1: none
    double closing_speed = 0;
  };
  Culprit find_culprit(const PgsRows& rows, const PgsIsland& island, double tolerance);

 private:
  void set_velocities(const PgsRows& rows, const PgsIsland& island);
  double law_map_of(const PgsRows& rows, std::size_t place) const;

  const contact::ContactProblem& problem_;
  const contact::MassInverse& masses_;
  int threads_;
  VecX momentum_, v_;  ///< f + H r and M^-1 of it
};

/// The same on a local problem, as a message; empty: none.
std::string find_culprit(const contact::LocalProblem& problem, const VecX& r, double tolerance);

/// "contact 3 (key 17) closes at 0.2 m/s, but neither side can move and it has no force limit".
std::string closing_message(int contact, std::uint64_t key, double speed);

}  // namespace nilas::solvers
