#include <algorithm>
#include <cmath>

#include "contact/law_map.h"
#include "contact/solvers/pgs.h"
#include "contact/solvers/time_limit.h"
#include "core/base/error.h"

namespace nilas {

namespace {

/// law_map must fall by this share within the stall sweeps to count as progress.
constexpr double k_progress = 1e-3;
/// Rows held by less than this share of the contact's mean inverse mass cannot move.
constexpr double k_immovable_share = 1e-20;

/// One island: impulses are kept up to date, velocities are gathered row by row.
class LocalSweeps {
 public:
  LocalSweeps(const LocalProblem& problem, const VecX& guess)
      : problem_(problem), r_(guess.size() > 0 ? guess : VecX(VecX::Zero(problem.q.size()))) {
    for (int c = 0; c < problem.num_contacts(); ++c) visit(c, true);
  }

  void sweep() {
    for (int c = 0; c < problem_.num_contacts(); ++c) visit(c, false);
  }
  const VecX& impulses() const { return r_; }

 private:
  /// With `admit_only` the guess is made admissible and nothing else.
  void visit(int c, bool admit_only) {
    const auto i = static_cast<std::size_t>(c);
    const auto first = 3 * static_cast<Eigen::Index>(c);
    const Mat3& w = problem_.diagonal(c);
    const double smallest = k_immovable_share * w.trace();
    Vec3 r = r_.segment<3>(first), u = Vec3::Zero();
    if (!admit_only) {
      u = problem_.q.segment<3>(first);
      for (int k = problem_.row_start[i]; k < problem_.row_start[i + 1]; ++k) {
        const auto place = static_cast<std::size_t>(k);
        u += problem_.block[place] * r_.segment<3>(3 * static_cast<Eigen::Index>(problem_.column[place]));
      }
    }
    const auto step = [&](double velocity, double inverse_mass) {
      return inverse_mass > smallest && !admit_only ? velocity / inverse_mass : 0.0;
    };
    const double compliance = problem_.compliance[i];
    const double normal =
        std::min(std::max(r[0] - step(u[0] + compliance * r[0], w(0, 0) + compliance), 0.0), problem_.force_limit[i]);
    const Vec2 u_t = u.tail<2>() + w.block<2, 1>(1, 0) * (normal - r[0]);
    Vec2 t = Vec2::Zero();
    const double bound = problem_.mu[i] * normal;
    if (problem_.law == Law::pyramid) {
      t[0] = std::clamp(r[1] - step(u_t[0], w(1, 1)), -bound, bound);
      t[1] = std::clamp(r[2] - step(u_t[1] + w(2, 1) * (t[0] - r[1]), w(2, 2)), -bound, bound);
    } else if (problem_.law == Law::coulomb) {
      const double larger = std::max(w(1, 1), w(2, 2));
      t = Vec2(r[1] - step(u_t[0], larger), r[2] - step(u_t[1], larger));
      if (t.norm() > bound) t *= bound / t.norm();
    }
    r_.segment<3>(first) = Vec3(normal, t[0], t[1]);
  }

  const LocalProblem& problem_;
  VecX r_;
};

}  // namespace

ContactSolution PgsSolver::solve(const LocalProblem& problem, const VecX& guess) const {
  if (problem.law == Law::ccp || problem.law == Law::pyramid_k)
    throw InputError("solver pgs knows the laws pyramid, coulomb and frictionless");
  const SolverSettings& shared = settings_.shared;
  const TimeLimit time_limit(shared);
  return solve_islands(problem, guess, [&](const LocalProblem& island, const VecX& start) {
    ContactSolution solution;
    LocalSweeps sweeps(island, start);
    double best = std::numeric_limits<double>::infinity();
    int best_sweep = 0;
    solution.status = SolveStatus::iteration_limit;
    while (solution.iterations < shared.max_iterations && solution.status == SolveStatus::iteration_limit &&
           !time_limit.over()) {
      sweeps.sweep();
      ++solution.iterations;
      if (shared.tolerance <= 0 && !shared.keep_history) continue;
      const double law_map = measure(island, sweeps.impulses()).law_map_m_s;
      if (shared.keep_history) solution.history.push_back(law_map);
      if (shared.tolerance <= 0) continue;
      if (!std::isfinite(law_map)) solution.status = SolveStatus::numerical_error;
      if (law_map <= shared.tolerance) solution.status = SolveStatus::converged;
      if (law_map < (1 - k_progress) * best) {
        best = law_map;
        best_sweep = solution.iterations;
      } else if (solution.iterations - best_sweep >= settings_.stall_sweeps) {
        solution.status = SolveStatus::stalled;
      }
    }
    if (solution.status == SolveStatus::numerical_error) solution.message = "impulses left finite numbers";
    solution.r = sweeps.impulses();
    return solution;
  });
}

}  // namespace nilas
