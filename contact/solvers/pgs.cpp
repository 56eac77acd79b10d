#include "contact/solvers/pgs.h"

#include <algorithm>
#include <cmath>

#include "contact/problem/row_of.h"
#include "contact/solvers/lanes/pgs_lanes.h"

namespace nilas::solvers {

namespace {

class PgsBodies : public RowSweeps {
 public:
  PgsBodies(const RowIsland& whole, const SweepSettings& settings)
      : RowSweeps(whole),
        sweep_(pgs_sweep(whole.problem.law, settings.shared.tolerance > 0)),
        turns_(rows_, island_, settings.shared.tolerance > 0) {}

  double sweep(bool backward) {
    return turns_.exist() ? turns_.sweep(rows_, backward) : sweep_(rows_, island_, backward);
  }
  double law_map() {
    turns_.keep_impulses(rows_);
    return RowSweeps::law_map();
  }
  VecX impulses() {
    turns_.keep_impulses(rows_);
    return RowSweeps::impulses();
  }

 private:
  PgsSweep sweep_;
  PgsTurns turns_;
};

class PgsLocal : public LocalSweeps {
 public:
  PgsLocal(const contact::LocalProblem& problem, const VecX& guess) : LocalSweeps(problem, guess) {
    for (int c = 0; c < problem.num_contacts(); ++c) {
      const auto i = static_cast<std::size_t>(c);
      weights_.push_back(row_weights(problem.diagonal(c), problem.law, problem.compliance[i],
                                     problem.tangential_compliance[i], problem.force_limit[i]));
      step(c, impulse(c));  // makes the guess admissible
    }
  }

  double sweep(bool backward) {
    double largest = 0;
    const int count = problem_.num_contacts();
    for (int k = 0; k < count; ++k) largest = std::max(largest, visit(backward ? count - 1 - k : k));
    return largest;
  }

 private:
  Vec3 impulse(int c) const { return r_.segment<3>(contact::row_of(c)); }

  /// Sets the contact's impulse to what the law's bounds leave of `wanted`, T2 seeing T1's change of velocity.
  void step(int c, const Vec3& wanted, double coupling = 0) {
    const auto i = static_cast<std::size_t>(c);
    const double normal = weights_[i].unanswerable ? 0 : std::clamp(wanted[0], 0.0, problem_.force_limit[i]);
    const double bound = problem_.mu[i] * normal;
    Vec2 t = wanted.tail<2>();
    if (problem_.law == Law::pyramid) {
      const double before = impulse(c)[1];
      t[0] = std::clamp(t[0], -bound, bound);
      t[1] = std::clamp(t[1] - coupling * (t[0] - before), -bound, bound);
    } else if (problem_.law == Law::coulomb) {
      if (t.norm() > bound) t *= bound / t.norm();
    } else {
      t.setZero();
    }
    r_.segment<3>(contact::row_of(c)) = Vec3(normal, t[0], t[1]);
  }

  /// The largest |dr_i| W_ii.
  double visit(int c) {
    const auto i = static_cast<std::size_t>(c);
    const Mat3& w = problem_.diagonal(c);
    const double* const weight = weights_[i].weight;
    const Vec3 r = impulse(c), u = contact::compliant_velocity(problem_, c, r, velocity(c));
    Vec3 wanted = r;
    wanted[0] -= weight[0] * u[0];
    const double change = weights_[i].unanswerable ? 0 : std::clamp(wanted[0], 0.0, problem_.force_limit[i]) - r[0];
    for (int k = 1; k < 3; ++k) wanted[k] -= weight[k] * (u[k] + w(k, 0) * change);
    step(c, wanted, weight[2] * w(2, 1));
    return (impulse(c) - r).cwiseAbs().cwiseProduct(w.diagonal()).maxCoeff();
  }

  std::vector<RowWeights> weights_;
};

}  // namespace

contact::ContactSolution PgsSolver::solve(const contact::PreparedProblem& problem, const VecX& guess) const {
  demand_known("pgs", k_row_laws, problem.problem().law);
  demand_no_moments(name(), problem.problem());
  const Budget budget(settings_.shared);
  return solve_row_islands(problem, guess, settings_.shared, RowOrder::given, [&](const RowIsland& island) {
    PgsBodies sweeps(island, settings_);
    contact::ContactSolution part =
        sweep_to_tolerance(sweeps, island.island.last - island.island.first, settings_, budget);
    sweeps.set_impulses(part.r);
    return part;
  });
}

contact::ContactSolution PgsSolver::solve(const contact::LocalProblem& problem, const VecX& guess) const {
  demand_known("pgs", k_row_laws, problem.law);
  return solve_by_sweeps<PgsLocal>(problem, guess, settings_, Budget(settings_.shared));
}

}  // namespace nilas::solvers
