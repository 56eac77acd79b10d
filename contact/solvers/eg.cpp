#include "contact/solvers/eg.h"

#include <cmath>
#include <numeric>

#include "contact/solvers/best_iterate.h"
#include "contact/solvers/island_operator.h"
#include "contact/solvers/shared/law_cone.h"
#include "core/base/error.h"
#include "core/base/order_free_sum.h"
#include "core/base/parallel.h"

namespace nilas {

namespace {

constexpr std::initializer_list<Law> k_laws{Law::coulomb, Law::ccp, Law::pyramid_k, Law::frictionless};

constexpr double k_accepted_ratio = 0.9;
constexpr double k_timid_ratio = 0.3;
constexpr double k_shrink = 2.0 / 3;

class Extragradient {
 public:
  Extragradient(IslandOperator& island, const VecX& guess, bool order_free)
      : island_(island), order_free_(order_free), r_(guess), forces_(island.num_contacts()), impulses_(forces_) {
    for_each_contact([&](int c) { set(c, r_, project(c, r_.segment<3>(3 * c))); });
    island_.velocities(r_, u_);
  }

  /// One accepted iteration.
  void step() {
    if (ratio_ < k_timid_ratio) rho_ /= k_shrink;
    predict();
    while (ratio_ > k_accepted_ratio && rho_ > k_least_step) {
      rho_ *= k_shrink * std::min(1.0, 1 / ratio_);
      predict();
    }
    for_each_contact([&](int c) { set(c, r_, moved(c, r_, trial_u_)); });
    island_.velocities(r_, u_);
  }

  double estimate() const { return island_.estimate(r_, u_); }
  const VecX& impulses() const { return r_; }

 private:
  /// Steps shorter than this share of 1/d move nothing that doubles can tell.
  static constexpr double k_least_step = 1e-15;

  Vec3 project(int c, const Vec3& x) const {
    return project_law(island_.law(), island_.facets(), island_.scales()[static_cast<std::size_t>(c)], x);
  }
  static void set(int c, VecX& x, const Vec3& value) { x.segment<3>(3 * static_cast<Eigen::Index>(c)) = value; }

  Vec3 shifted(int c, const VecX& u) const {
    Vec3 f = u.segment<3>(3 * static_cast<Eigen::Index>(c));
    f[0] += law_shift(island_.law(), island_.facets(), island_.scales()[static_cast<std::size_t>(c)], f);
    return f;
  }

  /// P(r - rho F/d); a contact that cannot move is at its limit while it closes.
  Vec3 moved(int c, const VecX& r, const VecX& u) const {
    const ContactScale& scale = island_.scales()[static_cast<std::size_t>(c)];
    const Vec3 f = shifted(c, u);
    if (scale.d == 0) return {f[0] < 0 && std::isfinite(scale.force_limit) ? scale.force_limit : 0.0, 0, 0};
    return project(c, r.segment<3>(3 * static_cast<Eigen::Index>(c)) - rho_ / scale.d * f);
  }

  void predict() {
    trial_.resize(r_.size());
    for_each_contact([&](int c) { set(c, trial_, moved(c, r_, u_)); });
    island_.velocities(trial_, trial_u_);
    for_each_contact([&](int c) {
      const double d = island_.scales()[static_cast<std::size_t>(c)].d;
      const auto first = 3 * static_cast<Eigen::Index>(c);
      forces_[c] = d > 0 ? (shifted(c, u_) - shifted(c, trial_u_)).squaredNorm() / d : 0;
      impulses_[c] = d > 0 ? (r_.segment<3>(first) - trial_.segment<3>(first)).squaredNorm() * d : 0;
    });
    const double force = total(forces_), impulse = total(impulses_);
    ratio_ = impulse > 0 ? rho_ * std::sqrt(force / impulse) : k_accepted_ratio;
  }

  template <class Work>
  void for_each_contact(const Work& work) const {
    parallel_for(island_.num_contacts(), island_.threads(), [&](std::ptrdiff_t c) { work(static_cast<int>(c)); });
  }

  /// Sum of terms >= 0.
  double total(const VecX& terms) const {
    if (!order_free_) return std::accumulate(terms.begin(), terms.end(), 0.0);
    OrderFreeSum sum;
    for (const double term : terms) sum.add(term);
    return sum.value();
  }

  IslandOperator& island_;
  bool order_free_;
  VecX r_, u_, trial_, trial_u_;
  VecX forces_, impulses_;  ///< per contact: what the two sides of the acceptance test add up
  double rho_ = 1;
  double ratio_ = k_accepted_ratio;
};

ContactSolution iterate(IslandOperator& island, const VecX& guess, const EgSettings& settings) {
  Extragradient method(island, guess, settings.order_free);
  BestIterate best(island, settings.shared, settings.stall_iterations);
  while (best.go_on(method.impulses(), method.estimate())) method.step();
  return best.solution(method.impulses());
}

}  // namespace

ContactSolution EgSolver::solve(const ContactProblem& problem, const VecX& guess) const {
  demand_known("eg", k_laws, problem.law);
  demand_no_moments(name(), problem);
  EgSettings running = settings_;
  running.shared = settings_.shared.started();
  // its own residual is what an order-free solve may look at, and that differs from `measure` by rounding
  if (running.order_free) running.shared = with_margin(running.shared);
  return solve_by_operator(problem, guess, running.shared, running.order_free,
                           [&](IslandOperator& island, const VecX& start) { return iterate(island, start, running); });
}

ContactSolution EgSolver::solve(const LocalProblem& problem, const VecX& guess) const {
  demand_known("eg", k_laws, problem.law);
  EgSettings running = settings_;
  running.shared = settings_.shared.started();
  return solve_by_operator(problem, guess, running.shared,
                           [&](IslandOperator& island, const VecX& start) { return iterate(island, start, running); });
}

}  // namespace nilas
