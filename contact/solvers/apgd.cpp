#include "contact/solvers/apgd.h"

#include <cmath>

#include "contact/solvers/best_iterate.h"
#include "contact/solvers/island_operator.h"
#include "contact/solvers/shared/law_cone.h"
#include "core/base/error.h"

namespace nilas {

namespace {

constexpr std::initializer_list<Law> k_laws{Law::coulomb, Law::ccp, Law::pyramid_k, Law::frictionless};

/// The inner residual against the outer one at which the shifts are renewed.
constexpr double k_inner_share = 0.1;
/// L falls by this factor per iteration, so that it follows the curvature where the iterates are.
constexpr double k_relax = 0.98;
/// Fewest inner iterations between renewals: acceleration needs a few to begin.
constexpr int k_fewest_inner = 5;
/// The weight of a renewal does not fall below this.
constexpr double k_least_weight = 0.05;

class Accelerated {
 public:
  Accelerated(IslandOperator& island, const VecX& guess) : island_(island), r_(guess) {
    for (int c = 0; c < island.num_contacts(); ++c) segment(r_, c) = project(c, segment(r_, c));
    island_.velocities(r_, u_);
    y_ = r_;
    y_u_ = u_;
    shift_ = target_shift();
    estimate_ = island_.estimate(r_, u_);
  }

  void step() {
    curvature_ = std::max(k_relax * curvature_, k_least_curvature);
    advance();
    for (double needed = needed_curvature(); needed > curvature_ * (1 + 1e-12); needed = needed_curvature()) {
      curvature_ = std::max(1.1 * needed, 1.5 * curvature_);
      advance();
    }
    extrapolate();
    ++since_renewal_;
    renew_if_due();
  }

  double estimate() const { return estimate_; }
  const VecX& impulses() const { return r_; }

 private:
  static constexpr double k_least_curvature = 1e-12;

  static Eigen::VectorBlock<VecX, 3> segment(VecX& x, int c) { return x.segment<3>(3 * static_cast<Eigen::Index>(c)); }
  static Vec3 segment(const VecX& x, int c) { return x.segment<3>(3 * static_cast<Eigen::Index>(c)); }
  const ContactScale& scale(int c) const { return island_.scales()[static_cast<std::size_t>(c)]; }
  Vec3 project(int c, const Vec3& x) const { return project_law(island_.law(), island_.facets(), scale(c), x); }

  Vec3 gradient(int c) const {
    Vec3 f = segment(y_u_, c);
    f[0] += shift_[c];
    return f;
  }

  /// next = P(y - D^-1 gradient/L)
  void advance() {
    next_.resize(r_.size());
    for (int c = 0; c < island_.num_contacts(); ++c) {
      const Vec3 f = gradient(c);
      if (scale(c).d > 0)
        segment(next_, c) = project(c, segment(y_, c) - f / (curvature_ * scale(c).d));
      else
        segment(next_, c) = Vec3(f[0] < 0 && std::isfinite(scale(c).force_limit) ? scale(c).force_limit : 0.0, 0, 0);
    }
    island_.velocities(next_, next_u_);
  }

  /// (next - y).W (next - y) / |next - y|_D^2, 0 when that is rounding.
  double needed_curvature() const {
    double work = 0, square = 0;
    for (int c = 0; c < island_.num_contacts(); ++c) {
      const Vec3 dr = segment(next_, c) - segment(y_, c);
      work += dr.dot(segment(next_u_, c) - segment(y_u_, c));
      square += scale(c).d * dr.squaredNorm();
    }
    return square > 0 && std::isfinite(work) ? work / square : 0;
  }

  void extrapolate() {
    double along = 0;
    for (int c = 0; c < island_.num_contacts(); ++c) along += gradient(c).dot(segment(next_, c) - segment(r_, c));
    const double square = theta_ * theta_;
    const double theta = 0.5 * (std::sqrt(square * square + 4 * square) - square);
    const double beta = along > 0 ? 0 : theta_ * (1 - theta_) / (square + theta);
    theta_ = along > 0 ? 1 : theta;
    y_ = next_ + beta * (next_ - r_);
    y_u_ = next_u_ + beta * (next_u_ - u_);
    r_.swap(next_);
    u_.swap(next_u_);
  }

  VecX target_shift() const {
    VecX shift(island_.num_contacts());
    for (int c = 0; c < island_.num_contacts(); ++c)
      shift[c] = law_shift(island_.law(), island_.facets(), scale(c), segment(u_, c));
    return shift;
  }

  /// Residual of r for the shifts in force.
  double inner_residual() const {
    double worst = 0;
    for (int c = 0; c < island_.num_contacts(); ++c) {
      if (scale(c).d == 0) continue;
      Vec3 f = segment(u_, c);
      f[0] += shift_[c];
      const Vec3 r = segment(r_, c);
      worst = std::max(worst, scale(c).d * (r - project(c, r - f / scale(c).d)).norm());
    }
    return worst;
  }

  void renew_if_due() {
    estimate_ = island_.estimate(r_, u_);
    const bool convex = island_.law() == Law::ccp || island_.law() == Law::frictionless;
    if (convex || since_renewal_ < k_fewest_inner || inner_residual() > k_inner_share * estimate_) return;
    if (estimate_ > last_renewal_) weight_ = std::max(0.5 * weight_, k_least_weight);
    last_renewal_ = estimate_;
    shift_ += weight_ * (target_shift() - shift_);
    since_renewal_ = 0;
    theta_ = 1;
    y_ = r_;
    y_u_ = u_;
  }

  IslandOperator& island_;
  VecX r_, u_, y_, y_u_, next_, next_u_, shift_;
  double curvature_ = 1;
  double theta_ = 1;
  double estimate_ = std::numeric_limits<double>::infinity();
  double last_renewal_ = std::numeric_limits<double>::infinity();
  double weight_ = 1;
  int since_renewal_ = 0;
};

ContactSolution iterate(IslandOperator& island, const VecX& guess, const ApgdSettings& settings) {
  Accelerated method(island, guess);
  BestIterate best(island, settings.shared, settings.stall_iterations);
  while (best.go_on(method.impulses(), method.estimate())) method.step();
  return best.solution(method.impulses());
}

}  // namespace

ContactSolution ApgdSolver::solve(const ContactProblem& problem, const VecX& guess) const {
  demand_known("apgd", k_laws, problem.law);
  demand_no_moments(name(), problem);
  ApgdSettings running = settings_;
  running.shared = settings_.shared.started();
  return solve_by_operator(problem, guess, running.shared, false,
                           [&](IslandOperator& island, const VecX& start) { return iterate(island, start, running); });
}

ContactSolution ApgdSolver::solve(const LocalProblem& problem, const VecX& guess) const {
  demand_known("apgd", k_laws, problem.law);
  ApgdSettings running = settings_;
  running.shared = settings_.shared.started();
  return solve_by_operator(problem, guess, running.shared,
                           [&](IslandOperator& island, const VecX& start) { return iterate(island, start, running); });
}

}  // namespace nilas
