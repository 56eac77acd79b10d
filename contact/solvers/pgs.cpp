#include "contact/solvers/pgs.h"

#include <algorithm>
#include <cmath>

#include "contact/solvers/pgs_sweep.h"
#include "core/base/error.h"

namespace nilas {

namespace {

/// Rows held by less than this share of the contact's mean inverse mass cannot move.
constexpr double k_immovable_share = 1e-20;

class BodiesIsland : public RowSweeps {
 public:
  BodiesIsland(const RowIsland& whole, const SweepSettings& settings)
      : RowSweeps(whole), sweep_(pgs_sweep(whole.problem.law, settings.shared.tolerance > 0)) {}

  double sweep(bool backward) { return sweep_(rows_, island_, backward); }

 private:
  PgsSweep sweep_;
};

class LocalIsland : public LocalSweeps {
 public:
  LocalIsland(const LocalProblem& problem, const VecX& guess) : LocalSweeps(problem, guess) {
    for (int c = 0; c < problem.num_contacts(); ++c) visit(c, Vec3::Zero(), 0);  // makes the guess admissible
  }

  double sweep(bool backward) {
    double largest = 0;
    const int count = problem_.num_contacts();
    for (int k = 0; k < count; ++k) {
      const int c = backward ? count - 1 - k : k;
      largest = std::max(largest, visit(c, velocity(c), 1));
    }
    return largest;
  }

 private:
  /// One step of the contact's rows from velocity u, `share` of it; the largest |dr_i| W_ii.
  double visit(int c, const Vec3& u, double share) {
    const auto i = static_cast<std::size_t>(c);
    const Mat3& w = problem_.diagonal(c);
    const double smallest = k_immovable_share * w.trace();
    const auto step = [&](double velocity, double inverse_mass) {
      return inverse_mass > smallest ? share * velocity / inverse_mass : 0.0;
    };
    auto r = r_.segment<3>(3 * static_cast<Eigen::Index>(c));
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
    const Vec3 change = (Vec3(normal, t[0], t[1]) - r).cwiseAbs().cwiseProduct(w.diagonal());
    r = Vec3(normal, t[0], t[1]);
    return change.maxCoeff();
  }
};

}  // namespace

ContactSolution PgsSolver::solve(const ContactProblem& problem, const VecX& guess) const {
  demand_known("pgs", {Law::pyramid, Law::coulomb, Law::frictionless}, problem.law);
  return solve_row_islands(problem, guess, settings_.shared, [&](const RowIsland& island) {
    BodiesIsland sweeps(island, settings_);
    return sweep_to_tolerance(sweeps, island.island.last - island.island.first, settings_);
  });
}

ContactSolution PgsSolver::solve(const LocalProblem& problem, const VecX& guess) const {
  demand_known("pgs", {Law::pyramid, Law::coulomb, Law::frictionless}, problem.law);
  NILAS_DEMAND(guess.size() == 0 || guess.size() == 3 * problem.num_contacts());
  return solve_by_sweeps<LocalIsland>(problem, guess, settings_);
}

}  // namespace nilas
