#include "tests/contact/solvers/jacobi_example.h"

#include <cmath>

#include "contact/problem/row_of.h"
#include "contact/solvers/island_operator.h"
#include "contact/solvers/shared/law_cone.h"
#include "contact/solvers/shared/measured_loop.h"

namespace nilas::solvers {

namespace {

/// Returns the impulse of one contact after a step against its velocity `u` and back to its cone.
Vec3 moved(const IslandOperator& island, int c, double omega, const Vec3& r, Vec3 u) {
  const contact::ContactScale& scale = island.scales()[c];
  u[0] += law_shift(island.law(), island.facets(), scale, u);
  // Where neither side can move, the impulse is at its limit while the contact closes.
  if (scale.d == 0) return {u[0] < 0 && std::isfinite(scale.force_limit) ? scale.force_limit : 0.0, 0, 0};
  return project_law(island.law(), island.facets(), scale, r - omega / scale.d * u);
}

contact::ContactSolution iterate(IslandOperator& island, const VecX& guess, const JacobiSettings& settings,
                                 const Budget& budget) {
  VecX r = guess, u;
  island.velocities(r, u);
  MeasuredLoop loop(settings.shared, budget, settings.stall_iterations);
  const auto measured = [&] { return island.law_map(r); };
  const auto impulses = [&]() -> const VecX& { return r; };
  for (double estimate = island.estimate(r, u); loop.goes_on(estimate, measured, impulses);) {
    // Every contact sees the velocities of the last iteration, so the order of contacts does not matter.
    for (int c = 0; c < island.num_contacts(); ++c)
      r.segment<3>(contact::row_of(c)) =
          moved(island, c, settings.omega, r.segment<3>(contact::row_of(c)), u.segment<3>(contact::row_of(c)));
    island.velocities(r, u);
    estimate = island.estimate(r, u);
    if (settings.shared.keep_history) loop.note(estimate);
  }
  return loop.solution(measured, impulses);
}

}  // namespace

contact::ContactSolution JacobiSolver::solve(const contact::PreparedProblem& problem, const VecX& guess) const {
  demand_known("jacobi", k_cone_laws, problem.problem().law);
  demand_no_moments(name(), problem.problem());
  const Budget budget(settings_.shared);  // starts the clock of max_seconds
  return solve_by_operator(problem, guess, settings_.shared, false, [&](IslandOperator& island, const VecX& start) {
    return iterate(island, start, settings_, budget);
  });
}

contact::ContactSolution JacobiSolver::solve(const contact::LocalProblem& problem, const VecX& guess) const {
  demand_known("jacobi", k_cone_laws, problem.law);
  const Budget budget(settings_.shared);
  return solve_by_operator(problem, guess, settings_.shared, [&](IslandOperator& island, const VecX& start) {
    return iterate(island, start, settings_, budget);
  });
}

}  // namespace nilas::solvers
