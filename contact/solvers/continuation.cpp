#include "contact/solvers/continuation.h"

#include <algorithm>

#include "contact/solvers/nsgs.h"

namespace nilas::solvers {

namespace {

constexpr double k_first_share = 0.2;  ///< share of mu at the start
constexpr double k_first_step = 0.1;   ///< first step of the share
constexpr double k_least_step = 1e-3;  ///< step of the share below which the path counts as lost
constexpr double k_longer = 1.5, k_shorter = 0.4;
constexpr int k_sweeps = 200;

contact::LocalProblem with_friction(const contact::LocalProblem& island, double share) {
  contact::LocalProblem out = island;
  for (double& mu : out.mu) mu *= share;
  return out;
}

}  // namespace

contact::ContactSolution continue_in_friction(const contact::LocalProblem& island, const NewtonSettings& settings,
                                              const Budget& budget) {
  contact::ContactSolution out =
      NsgsSolver({.shared = settings.shared}).solve(with_friction(island, k_first_share), {}, budget.capped(k_sweeps));
  std::string failure;  ///< message of the last solve
  double solved = 0, share = k_first_share, step = k_first_step;
  while (solved < 1 && step >= k_least_step) {
    out.status = contact::SolveStatus::iteration_limit;
    if (!budget.allows(out.iterations)) return out;
    const contact::ContactSolution next =
        newton_island(with_friction(island, share), out.r, settings, budget.after(out.iterations));
    out.iterations += next.iterations;
    const bool success = next.status == contact::SolveStatus::converged;
    failure = next.status == contact::SolveStatus::numerical_error ? next.message : "";
    if (success) {
      out.status = next.status;
      out.r = next.r;
      solved = share;
    } else if (solved == 0) {
      if (!budget.allows(out.iterations)) return out;
      break;
    }
    step *= success ? (share == k_first_share ? 1 : k_longer) : k_shorter;
    share = std::min(1.0, solved + step);
  }
  out.message = solved < 1 ? failure : "";
  if (solved < 1) out.status = failure.empty() ? contact::SolveStatus::stalled : contact::SolveStatus::numerical_error;
  return out;
}

}  // namespace nilas::solvers
