#include "contact/solvers/ipm.h"

#include <algorithm>
#include <cmath>

#include "contact/solvers/newton/interior_point.h"
#include "contact/solvers/newton/newton_finish.h"
#include "contact/solvers/shared/anderson.h"
#include "contact/solvers/shared/best_impulses.h"
#include "core/base/error.h"

namespace nilas::solvers {

namespace {

constexpr int k_anderson_depth = 6;
/// An inner solve need not be better than this share of the outer loop's last change.
constexpr double k_inner_accuracy = 1e-4;
/// A later round starts this share of the first one's velocities inside the cones: nearer, steps are cut short by the
/// boundary; farther, the warm start is lost.
constexpr double k_warm_share = 1e-3;
/// Rounds without halving after which the fixed point is repeated plainly: accelerated, it may creep along one set of
/// states; plain, it wanders and gives the Newton finish other starts.
constexpr int k_plain_after = 5;
/// Inner iterations per round; 30 are enough from a cold start.
constexpr int k_inner_limit = 60;
constexpr double k_halved = 0.5;

/// Returns what the outer loop adds to q for given impulses.
VecX offset(const MassScaled& problem, const VecX& r) {
  const VecX u = problem.w * r + problem.q;
  VecX sum = problem.skew ? VecX(problem.w * r - problem.symmetric * r) : VecX(VecX::Zero(r.size()));
  if (problem.law == Law::coulomb) sum += de_saxce_shift(problem, u);
  return sum;
}

contact::ContactSolution solve_rounds(const contact::LocalProblem& island, const VecX& guess,
                                      const IpmSettings& settings, const contact::SolverSettings& shared,
                                      const Budget& budget) {
  const MassScaled problem = mass_scaled(island);
  InteriorPoint inner(problem);
  BestImpulses best(shared.tolerance, budget, {k_no_window, k_halved});
  const double least = 0.1 * shared.tolerance;  // of what the stages aim at [m/s]
  const auto offer = [&](const VecX& scaled) {
    if (!scaled.allFinite()) return;
    const VecX r = problem.impulses(scaled);
    const double residual = contact::measure(island, r).law_map_m_s;
    if (shared.keep_history) best.note(residual);
    best.offer(r, residual);
  };
  const auto finish = [&](const VecX& scaled) {
    if (best.has_converged()) return;
    const FinishOutcome end = newton_finish(problem, scaled, least, best.left().capped(settings.finish_iterations));
    best.spend(end.iterations);
    offer(end.r);
  };

  offer(VecX::Zero(problem.q.size()));
  if (!best.has_any()) best.fail("ipm: even impulses of zero have a residual beyond all numbers");
  if (guess.size() > 0) {
    const VecX scaled = problem.scaled_impulses(guess);
    const double before = best.residual();
    offer(scaled);
    finish(best.residual() < before ? scaled : VecX(VecX::Zero(scaled.size())));
  }
  const double size = problem.q.cwiseAbs().maxCoeff();
  const bool adds_nothing = problem.law != Law::coulomb && !problem.skew;  // then one round is all
  VecX added = VecX::Zero(problem.q.size());
  InteriorIterate point = inner.cold_start(problem.q);
  Anderson mixer(k_anderson_depth);
  StallRule rule(settings.stall_rounds, k_halved);
  rule.has_stalled(best.residual(), 0);
  double change = size;
  int failed = 0, round = 0;
  for (; round < settings.max_rounds && best.goes_on(); ++round) {
    if (round > 0) point = inner.shifted(point, std::min(k_warm_share * size, change));
    const double tolerance = adds_nothing ? least : std::max(k_inner_accuracy * change, least);
    const auto convex = inner.minimise(problem.q + added, tolerance, best.left().capped(k_inner_limit), point);
    best.spend(convex.iterations);
    if (!convex.finite) ++failed;
    const VecX r = inner.impulses(point);
    offer(r);
    finish(r);
    const VecX wanted = offset(problem, r);
    change = (wanted - added).cwiseAbs().maxCoeff();
    const bool creeps = rule.waited(round) >= k_plain_after;
    if (creeps) mixer.restart();
    added = creeps ? wanted : mixer.next(added, wanted);
    if (rule.has_stalled(best.residual(), round) || change == 0) best.stall();
  }
  if (round > 0 && failed == round) best.fail("ipm: W and the barrier together are not positive definite");
  contact::ContactSolution solution = std::move(best).solution();
  if (solution.r.size() == 0) solution.r = VecX::Zero(island.q.size());
  return solution;
}

}  // namespace

void IpmSolver::demand_law(Law law) const { demand_known("ipm", k_cone_laws, law); }

contact::ContactSolution IpmSolver::solve_island(const contact::LocalProblem& island, const VecX& guess,
                                                 const contact::SolverSettings& shared, const Budget& budget) const {
  if (const auto still = solve_immovable(island)) return *still;
  return solve_rounds(island, guess, settings_, shared, budget);
}

}  // namespace nilas::solvers
