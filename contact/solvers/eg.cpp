#include "contact/solvers/eg.h"

#include <cmath>
#include <numeric>

#include "contact/solvers/island_operator.h"
#include "contact/solvers/shared/law_cone.h"
#include "contact/solvers/shared/measured_loop.h"
#include "core/base/error.h"
#include "core/base/order_free_sum.h"
#include "core/base/parallel.h"

namespace nilas::solvers {

namespace {

constexpr double k_accepted_ratio = 0.9;
constexpr double k_timid_ratio = 0.3;
constexpr double k_shrink = 2.0 / 3;

/// Steps shorter than this share of 1/d change impulses by less than rounding.
constexpr double k_least_rho = 1e-15;

Eigen::VectorBlock<VecX, 3> segment(VecX& x, std::ptrdiff_t c) { return x.segment<3>(3 * c); }
Vec3 segment(const VecX& x, std::ptrdiff_t c) { return x.segment<3>(3 * c); }

/// One island, with the sums that the choice of step needs.
struct Game {
  IslandOperator& island;
  bool order_free;

  const contact::ContactScale& scale(std::ptrdiff_t c) const { return island.scales()[c]; }
  Vec3 project(std::ptrdiff_t c, const Vec3& x) const {
    return project_law(island.law(), island.facets(), scale(c), x);
  }
  /// F of one contact: its velocity with the shift.
  Vec3 force(std::ptrdiff_t c, const VecX& u) const {
    Vec3 f = segment(u, c);
    f[0] += law_shift(island.law(), island.facets(), scale(c), f);
    return f;
  }
  template <class Work>
  void for_each_contact(const Work& work) const {
    parallel_for(island.num_contacts(), island.threads(), work);
  }
  /// Sum of terms >= 0.
  double total(const VecX& terms) const {
    if (!order_free) return std::accumulate(terms.begin(), terms.end(), 0.0);
    OrderFreeSum sum;
    for (const double term : terms) sum.add(term);
    return sum.value();
  }
};

/// P(r - rho D^-1 F(u)); a contact that cannot move is at its limit while it closes.
VecX moved(const Game& game, const VecX& r, const VecX& u, double rho) {
  VecX next(r.size());
  game.for_each_contact([&](std::ptrdiff_t c) {
    const contact::ContactScale& scale = game.scale(c);
    const Vec3 f = game.force(c, u);
    if (scale.d == 0)
      segment(next, c) = Vec3(f[0] < 0 && std::isfinite(scale.force_limit) ? scale.force_limit : 0.0, 0, 0);
    else
      segment(next, c) = game.project(c, segment(r, c) - rho / scale.d * f);
  });
  return next;
}

/// rho |F(r) - F(trial)|_{D^-1} / |r - trial|_D
double change_ratio(const Game& game, const VecX& r, const VecX& u, const VecX& trial, const VecX& trial_u,
                    double rho) {
  VecX forces(game.island.num_contacts()), impulses(game.island.num_contacts());
  game.for_each_contact([&](std::ptrdiff_t c) {
    const double d = game.scale(c).d;
    forces[c] = d > 0 ? (game.force(c, u) - game.force(c, trial_u)).squaredNorm() / d : 0;
    impulses[c] = d > 0 ? (segment(r, c) - segment(trial, c)).squaredNorm() * d : 0;
  });
  const double force = game.total(forces), impulse = game.total(impulses);
  return impulse > 0 ? rho * std::sqrt(force / impulse) : k_accepted_ratio;
}

contact::ContactSolution iterate(IslandOperator& island, const VecX& guess, const EgSettings& settings,
                                 const Budget& budget) {
  const Game game{island, settings.order_free};
  VecX r(guess.size()), u, trial, trial_u;
  game.for_each_contact([&](std::ptrdiff_t c) { segment(r, c) = game.project(c, segment(guess, c)); });
  island.velocities(r, u);
  double rho = 1, ratio = k_accepted_ratio;
  const auto predict = [&] {
    trial = moved(game, r, u, rho);
    island.velocities(trial, trial_u);
    ratio = change_ratio(game, r, u, trial, trial_u, rho);
  };

  MeasuredLoop loop(settings.shared, budget, settings.stall_iterations);
  const auto measured = [&] { return island.law_map(r); };
  const auto impulses = [&]() -> const VecX& { return r; };
  for (double estimate = island.estimate(r, u); loop.goes_on(estimate, measured, impulses);) {
    if (ratio < k_timid_ratio) rho /= k_shrink;
    predict();
    while (ratio > k_accepted_ratio && rho > k_least_rho) {
      rho *= k_shrink * std::min(1.0, 1 / ratio);
      predict();
    }
    r = moved(game, r, trial_u, rho);
    island.velocities(r, u);
    estimate = island.estimate(r, u);
    if (settings.shared.keep_history) loop.note(estimate);
  }
  return loop.solution(measured, impulses);
}

}  // namespace

contact::ContactSolution EgSolver::solve(const contact::PreparedProblem& problem, const VecX& guess) const {
  return solve(problem, guess, Budget(settings_.shared));
}

contact::ContactSolution EgSolver::solve(const contact::PreparedProblem& problem, const VecX& guess,
                                         const Budget& budget) const {
  demand_known("eg", k_convex_laws, problem.problem().law);
  demand_no_moments(name(), problem.problem());
  EgSettings own = settings_;
  // its own residual is what an order-free solve may look at, and that differs from `measure` by rounding
  if (own.order_free) own.shared = with_margin(own.shared);
  return solve_by_operator(problem, guess, own.shared, own.order_free, [&](IslandOperator& island, const VecX& start) {
    return iterate(island, start, own, budget);
  });
}

contact::ContactSolution EgSolver::solve(const contact::LocalProblem& problem, const VecX& guess) const {
  demand_known("eg", k_convex_laws, problem.law);
  const Budget budget(settings_.shared);
  return solve_by_operator(problem, guess, settings_.shared, [&](IslandOperator& island, const VecX& start) {
    return iterate(island, start, settings_, budget);
  });
}

}  // namespace nilas::solvers
