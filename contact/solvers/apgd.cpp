#include "contact/solvers/apgd.h"

#include <cmath>

#include "contact/problem/row_of.h"
#include "contact/solvers/island_operator.h"
#include "contact/solvers/shared/law_cone.h"
#include "contact/solvers/shared/measured_loop.h"
#include "core/base/error.h"

namespace nilas::solvers {

namespace {

/// The inner residual against the outer one at which the shifts are renewed.
constexpr double k_inner_share = 0.1;
/// L falls by this factor per iteration, so that it follows the curvature where the iterates are.
constexpr double k_relax = 0.98;
/// Fewest inner iterations between renewals: acceleration needs a few to begin.
constexpr int k_fewest_inner = 5;
/// The weight of a renewal does not fall below this.
constexpr double k_least_weight = 0.05;

constexpr double k_least_curvature = 1e-12;
/// Curvature above this multiple of L asks for a larger L; below, the difference is rounding.
constexpr double k_curvature_rounding = 1 + 1e-12;

Eigen::VectorBlock<VecX, 3> segment(VecX& x, int c) { return x.segment<3>(contact::row_of(c)); }
Vec3 segment(const VecX& x, int c) { return x.segment<3>(contact::row_of(c)); }
const contact::ContactScale& scale_of(const IslandOperator& island, int c) { return island.scales()[c]; }
Vec3 project(const IslandOperator& island, int c, const Vec3& x) {
  return project_law(island.law(), island.facets(), scale_of(island, c), x);
}

/// Impulses with their velocities.
struct Point {
  VecX r, u;
};

/// The velocity with the shift in force.
Vec3 gradient(const Point& at, const VecX& shift, int c) {
  Vec3 f = segment(at.u, c);
  f[0] += shift[c];
  return f;
}

/// next = P(y - D^-1 gradient/L); a contact that cannot move is at its limit while it closes.
void advance(IslandOperator& island, const Point& y, const VecX& shift, double curvature, Point& next) {
  next.r.resize(y.r.size());
  for (int c = 0; c < island.num_contacts(); ++c) {
    const Vec3 f = gradient(y, shift, c);
    const contact::ContactScale& scale = scale_of(island, c);
    if (scale.d > 0)
      segment(next.r, c) = project(island, c, segment(y.r, c) - f / (curvature * scale.d));
    else
      segment(next.r, c) = Vec3(f[0] < 0 && std::isfinite(scale.force_limit) ? scale.force_limit : 0.0, 0, 0);
  }
  island.velocities(next.r, next.u);
}

/// (next - y).W (next - y) / |next - y|_D^2, 0 when that is rounding.
double needed_curvature(const IslandOperator& island, const Point& y, const Point& next) {
  double work = 0, square = 0;
  for (int c = 0; c < island.num_contacts(); ++c) {
    const Vec3 dr = segment(next.r, c) - segment(y.r, c);
    work += dr.dot(segment(next.u, c) - segment(y.u, c));
    square += scale_of(island, c).d * dr.squaredNorm();
  }
  return square > 0 && std::isfinite(work) ? work / square : 0;
}

/// Nesterov's momentum from r to next; restarts (theta = 1, beta = 0) where the gradient at y points along the step.
double momentum(const Point& y, const VecX& shift, const Point& r, const Point& next, double& theta) {
  double along = 0;
  for (int c = 0; c < shift.size(); ++c) along += gradient(y, shift, c).dot(segment(next.r, c) - segment(r.r, c));
  const double square = theta * theta;
  const double lower = 0.5 * (std::sqrt(square * square + 4 * square) - square);
  const double beta = along > 0 ? 0 : theta * (1 - theta) / (square + lower);
  theta = along > 0 ? 1 : lower;
  return beta;
}

VecX shift_of(const IslandOperator& island, const VecX& u) {
  VecX shift(island.num_contacts());
  for (int c = 0; c < island.num_contacts(); ++c)
    shift[c] = law_shift(island.law(), island.facets(), scale_of(island, c), segment(u, c));
  return shift;
}

/// Residual of r for the shifts in force.
double inner_residual(const IslandOperator& island, const Point& r, const VecX& shift) {
  double worst = 0;
  for (int c = 0; c < island.num_contacts(); ++c) {
    const double d = scale_of(island, c).d;
    if (d == 0) continue;
    const Vec3 r_c = segment(r.r, c);
    worst = std::max(worst, d * (r_c - project(island, c, r_c - gradient(r, shift, c) / d)).norm());
  }
  return worst;
}

/// The outer loop's state: when the shifts were last renewed, and with what weight they next are.
struct Renewal {
  double weight = 1;
  double last_residual = std::numeric_limits<double>::infinity();
  int inner_iterations = 0;
};

/// Renews the shifts where the inner problem is solved well enough for that. True: they are others now.
bool renew_if_due(const IslandOperator& island, const Point& r, double residual, Renewal& renewal, VecX& shift) {
  ++renewal.inner_iterations;
  const bool convex = island.law() == Law::ccp || island.law() == Law::frictionless;
  if (convex || renewal.inner_iterations < k_fewest_inner ||
      inner_residual(island, r, shift) > k_inner_share * residual)
    return false;
  if (residual > renewal.last_residual) renewal.weight = std::max(0.5 * renewal.weight, k_least_weight);
  renewal.last_residual = residual;
  renewal.inner_iterations = 0;
  shift += renewal.weight * (shift_of(island, r.u) - shift);
  return true;
}

contact::ContactSolution iterate(IslandOperator& island, const VecX& guess, const ApgdSettings& settings,
                                 const Budget& budget) {
  Point r{guess, {}}, next;
  for (int c = 0; c < island.num_contacts(); ++c) segment(r.r, c) = project(island, c, segment(guess, c));
  island.velocities(r.r, r.u);
  Point y = r;
  VecX shift = shift_of(island, r.u);
  Renewal renewal;
  double curvature = 1, theta = 1;

  MeasuredLoop loop(settings.shared, budget, settings.stall_iterations);
  const auto measured = [&] { return island.law_map(r.r); };
  const auto impulses = [&]() -> const VecX& { return r.r; };
  for (double estimate = island.estimate(r.r, r.u); loop.goes_on(estimate, measured, impulses);) {
    curvature = std::max(k_relax * curvature, k_least_curvature);
    advance(island, y, shift, curvature, next);
    for (double needed = needed_curvature(island, y, next); needed > curvature * k_curvature_rounding;
         needed = needed_curvature(island, y, next)) {
      curvature = std::max(1.1 * needed, 1.5 * curvature);
      advance(island, y, shift, curvature, next);
    }
    const double beta = momentum(y, shift, r, next, theta);
    y.r = next.r + beta * (next.r - r.r);
    y.u = next.u + beta * (next.u - r.u);
    std::swap(r, next);
    estimate = island.estimate(r.r, r.u);
    if (settings.shared.keep_history) loop.note(estimate);
    if (renew_if_due(island, r, estimate, renewal, shift)) {
      theta = 1;
      y = r;
    }
  }
  return loop.solution(measured, impulses);
}

}  // namespace

contact::ContactSolution ApgdSolver::solve(const contact::PreparedProblem& problem, const VecX& guess) const {
  return solve(problem, guess, Budget(settings_.shared));
}

contact::ContactSolution ApgdSolver::solve(const contact::PreparedProblem& problem, const VecX& guess,
                                           const Budget& budget) const {
  demand_known("apgd", k_convex_laws, problem.problem().law);
  demand_no_moments(name(), problem.problem());
  return solve_by_operator(problem, guess, settings_.shared, false, [&](IslandOperator& island, const VecX& start) {
    return iterate(island, start, settings_, budget);
  });
}

contact::ContactSolution ApgdSolver::solve(const contact::LocalProblem& problem, const VecX& guess) const {
  demand_known("apgd", k_convex_laws, problem.law);
  const Budget budget(settings_.shared);
  return solve_by_operator(problem, guess, settings_.shared, [&](IslandOperator& island, const VecX& start) {
    return iterate(island, start, settings_, budget);
  });
}

}  // namespace nilas::solvers
