#include "contact/solvers/newton.h"

#include <algorithm>
#include <cmath>

#include "contact/problem/row_of.h"
#include "contact/solvers/newton/delassus_system.h"
#include "contact/solvers/shared/best_impulses.h"
#include "contact/solvers/shared/mass_scaled.h"
#include "core/base/error.h"

namespace nilas::solvers {

namespace {

constexpr double k_most_weight = 10;
/// Factors of the weight after a middling and a failed inner solve.
constexpr double k_rise = 3, k_retreat = 10;
/// A good inner solve of more steps than these leaves the weight as it is.
constexpr int k_very_quick_steps = 3, k_quick_steps = 8;
/// |F| fallen to this share makes an inner solve good, to the second one middling.
constexpr double k_good = 0.1, k_middling = 0.5;
/// A line search demands this share of the fall that the linear model promises.
constexpr double k_armijo = 1e-4;
/// Retreats beyond the largest weight before giving up.
constexpr int k_most_retreats = 3;
/// |F| that rounding leaves, in units of sqrt(J).
constexpr double k_least_size = 1e-16;

/// Impulses with their velocities, the proximal term included, and |F|.
struct Iterate {
  VecX r, u;
  double size = 0;
};

/// How an inner solve ended.
struct InnerEnd {
  VecX r;           ///< the best by |F|
  double size = 0;  ///< its |F|
  bool is_singular = false;
};

/// Halves the step until |F| falls. False when it never does.
bool descend(const NewtonSystem& system, int halvings, const VecX& dr, const VecX& du, Iterate& now) {
  double t = 1;
  for (int k = 0; k < halvings; ++k, t *= 0.5) {
    Iterate next{now.r + t * dr, now.u + t * du, 0};
    next.size = system.map_size(next.r, next.u);
    if (!(next.size < (1 - k_armijo * t) * now.size)) continue;
    now = std::move(next);
    return true;
  }
  return false;
}

/// Newton from r_0 on the problem with velocities u + a (r - r_0), a the weight, until |F| <= target. Counts its
/// factorisations in `best`. `seen`: called with each iterate.
template <class Seen>
InnerEnd solve_inner(NewtonSystem& system, const NewtonSettings& settings, double weight, double target, Iterate now,
                     BestImpulses& best, const Seen& seen) {
  now.size = system.linearise(now.r, now.u);
  Iterate least = now;
  bool is_singular = false;
  int in_vain = 0;
  VecX dr;
  for (int k = 0; k < settings.inner_steps && least.size > target && best.has_budget(); ++k) {
    if (in_vain == settings.free_steps && now.size > least.size) {
      now = least;
      system.linearise(now.r, now.u);
    }
    best.spend();
    is_singular = !system.step(weight, now.r, dr);
    if (is_singular) break;
    const VecX du = system.product(dr) + weight * dr;
    const bool is_free = in_vain < settings.free_steps;
    if (is_free)
      now = {now.r + dr, now.u + du, 0};
    else if (!descend(system, settings.halvings, dr, du, now))
      break;
    now.size = system.linearise(now.r, now.u);
    if (is_free) in_vain = now.size < k_middling * least.size ? 0 : in_vain + 1;
    if (now.size < least.size) least = now;
    seen(now.r);
  }
  return {least.r, least.size, is_singular};
}

}  // namespace

contact::ContactSolution newton_on(NewtonSystem& system, const VecX& guess, const NewtonSettings& settings,
                                   const Budget& budget) {
  BestImpulses best(settings.shared.tolerance, budget.capped(settings.max_factorisations), {k_no_window, 1});
  const auto offer = [&](const VecX& scaled) { best.offer(system.impulses(scaled), system.residual(scaled)); };
  const auto note = [&](const VecX& scaled) {
    if (settings.shared.keep_history) best.note(system.residual(scaled));
  };

  VecX r = guess.size() > 0 ? system.scaled(guess) : VecX(VecX::Zero(contact::row_of(system.num_contacts())));
  offer(r);
  if (!best.has_any()) offer(r.setZero());  // the guess is beyond all numbers
  if (!best.has_any()) best.fail("newton: even impulses of zero have a residual beyond all numbers");
  double weight = settings.first_weight;
  int retreats = 0;
  while (best.goes_on()) {
    const VecX u = system.velocities(r);
    const double before = system.map_size(r, u), target = std::max(settings.inner_share * before, k_least_size);
    const int done = best.iterations();
    const InnerEnd end = solve_inner(system, settings, weight, target, {r, u, 0}, best, note);
    const int taken = best.iterations() - done;
    offer(end.r);
    if (best.has_converged()) break;
    if (taken == 0 && !std::isfinite(before)) best.fail("newton: the map grew beyond all numbers");
    if (taken == 0) best.stall();  // |F| is rounding already
    if (!best.is_running()) break;
    if (end.size <= std::max(10 * target, k_good * before)) {
      r = end.r;
      if (taken <= k_quick_steps)
        weight =
            std::max((taken <= k_very_quick_steps ? settings.plunge : settings.fall) * weight, settings.least_weight);
    } else if (end.size <= k_middling * before) {
      r = end.r;
      weight *= k_rise;
    } else if (weight *= k_retreat; weight > k_most_weight) {
      weight = 10 * settings.first_weight;
      r = system.scaled(best.impulses());
      if (++retreats < k_most_retreats) continue;
      if (end.is_singular) best.fail("newton: the linear system stays singular whatever the proximal weight");
      best.stall();
    }
  }
  contact::ContactSolution solution = std::move(best).solution();
  if (solution.r.size() == 0) solution.r = VecX::Zero(contact::row_of(system.num_contacts()));
  return solution;
}

contact::ContactSolution newton_island(const contact::LocalProblem& island, const VecX& guess,
                                       const NewtonSettings& settings, const Budget& budget) {
  if (const auto immovable = solve_immovable(island)) return *immovable;
  DelassusSystem system(island, settings.order_free);
  return newton_on(system, guess, settings, budget);
}

contact::ContactSolution NewtonSolver::solve_island(const contact::LocalProblem& island, const VecX& guess,
                                                    const contact::SolverSettings& shared, const Budget& budget) const {
  NewtonSettings own = settings_;
  own.shared = shared;
  return newton_island(island, guess, own, budget);
}

}  // namespace nilas::solvers
