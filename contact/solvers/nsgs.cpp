#include "contact/solvers/nsgs.h"

#include <algorithm>

#include "contact/solvers/nsgs_sweep.h"
#include "contact/solvers/progress.h"
#include "contact/solvers/row_islands.h"
#include "core/base/error.h"

namespace nilas {

namespace {

/// `measure` finds the same law_map up to rounding: velocities of bodies are summed in another order there.
constexpr double k_agreed_share = 1 - 1e-12;

/// Sweeps an island to the end. Island: sweep(backward) -> largest change, law_map(), correct(), save(), restore().
template <class Island>
ContactSolution iterate(Island& island, int contacts, const NsgsSettings& settings) {
  const SolverSettings& shared = settings.shared;
  ContactSolution outcome;
  outcome.status = SolveStatus::iteration_limit;
  Progress progress(shared, std::max(settings.stall_sweeps, contacts));
  bool saved_is_current = false;
  while (outcome.status == SolveStatus::iteration_limit && !progress.out_of_budget(outcome.iterations)) {
    const bool backward = settings.symmetric_sweeps && outcome.iterations % 2 == 1;
    const double change = island.sweep(backward);
    ++outcome.iterations;
    saved_is_current = false;
    if (shared.keep_history) outcome.history.push_back(island.law_map());
    if (!progress.measurement_due(outcome.iterations, change)) continue;
    outcome.status = progress.judge(outcome.iterations, change, island.law_map());
    island.correct();
    saved_is_current = progress.improved();
    if (saved_is_current) island.save();
  }
  if (shared.tolerance > 0 && !saved_is_current) {
    const double last = island.law_map();
    if (!(last <= progress.best())) island.restore();
    if (last <= shared.tolerance) outcome.status = SolveStatus::converged;
  }
  if (outcome.status == SolveStatus::numerical_error) outcome.message = "the impulses grew beyond all numbers";
  return outcome;
}

/// An island of a problem with bodies.
class BodiesIsland {
 public:
  explicit BodiesIsland(const RowIsland& whole)
      : rows_(whole.rows),
        island_(whole.island),
        residual_(whole.residual),
        facets_(whole.problem.facets),
        blocks_(make_nsgs_contacts(rows_, island_)) {
    saved_.resize(3 * blocks_.size());
  }

  double sweep(bool backward) { return nsgs_sweep(rows_, island_, blocks_, facets_, backward); }

  double law_map() { return residual_.law_map(rows_, island_) / k_agreed_share; }
  /// After law_map: drops the rounding that the sweeps have gathered.
  void correct() { residual_.correct(rows_, island_); }
  void save() {
    for (int k = island_.first; k < island_.last; ++k)
      std::copy_n(rows_.contacts[static_cast<std::size_t>(k)].r, 3, saved_at(k));
  }
  void restore() {
    for (int k = island_.first; k < island_.last; ++k)
      std::copy_n(saved_at(k), 3, rows_.contacts[static_cast<std::size_t>(k)].r);
  }

 private:
  double* saved_at(int k) { return saved_.data() + 3 * static_cast<std::ptrdiff_t>(k - island_.first); }

  PgsRows& rows_;
  const PgsIsland& island_;
  RowResidual& residual_;
  int facets_;
  std::vector<NsgsContact> blocks_;
  std::vector<double> saved_;
};

/// An island of a local problem.
class LocalIsland {
 public:
  LocalIsland(const LocalProblem& problem, const VecX& guess)
      : problem_(problem), r_(guess.size() > 0 ? guess : VecX(VecX::Zero(problem.q.size()))), saved_(r_) {
    for (int c = 0; c < problem.num_contacts(); ++c) {
      const auto i = static_cast<std::size_t>(c);
      const Mat3& w = problem.diagonal(c);
      scales_.push_back(contact_scale(problem, c));
      contacts_.push_back({ContactBlock(w, problem.mu[i], problem.force_limit[i], problem.compliance[i]),
                           {0, r_[3 * static_cast<Eigen::Index>(c)]},
                           scales_.back().d});
    }
  }

  double sweep(bool backward) {
    double largest = 0;
    const int count = problem_.num_contacts();
    for (int k = 0; k < count; ++k) {
      const double change = visit(backward ? count - 1 - k : k);
      if (!(change <= largest)) largest = change;
    }
    return largest;
  }

  double law_map() const {
    const VecX u = contact_velocities(problem_, r_);
    double worst = 0;
    for (int c = 0; c < problem_.num_contacts(); ++c) {
      const auto i = static_cast<std::size_t>(c);
      const Vec3 r = r_.segment<3>(3 * static_cast<Eigen::Index>(c));
      const Vec3 own = compliant_velocity(problem_.compliance[i], r, u.segment<3>(3 * static_cast<Eigen::Index>(c)));
      const double map = nilas::law_map(problem_.law, problem_.facets, scales_[i], r, own);
      if (!(map <= worst)) worst = map;
      if (std::isnan(worst)) break;
    }
    return worst;
  }
  void correct() {}  // velocities are gathered anew in every visit
  void save() { saved_ = r_; }
  void restore() { r_ = saved_; }
  const VecX& impulses() const { return r_; }

 private:
  Vec3 velocity(int c) const {
    const auto i = static_cast<std::size_t>(c);
    const double* const r = r_.data();
    double u[3] = {0, 0, 0};
    for (int k = problem_.row_start[i]; k < problem_.row_start[i + 1]; ++k) {
      const double* const w = problem_.block[static_cast<std::size_t>(k)].data();
      const double* const x = r + 3 * static_cast<std::ptrdiff_t>(problem_.column[static_cast<std::size_t>(k)]);
      for (int j = 0; j < 3; ++j) u[j] += w[j] * x[0] + w[j + 3] * x[1] + w[j + 6] * x[2];
    }
    const auto q = problem_.q.segment<3>(3 * static_cast<Eigen::Index>(c));
    return {u[0] + q[0], u[1] + q[1], u[2] + q[2]};
  }

  double visit(int c) {
    NsgsContact& own = contacts_[static_cast<std::size_t>(c)];
    const Vec3 old = r_.segment<3>(3 * static_cast<Eigen::Index>(c));
    const Vec3 u = compliant_velocity(problem_.compliance[static_cast<std::size_t>(c)], old, velocity(c));
    const Vec3 r = solve_in_sweep(problem_.law, problem_.facets, own.block, own.block.without(old, u), own.start);
    r_.segment<3>(3 * static_cast<Eigen::Index>(c)) = r;
    return own.d * (r - old).norm();
  }

  const LocalProblem& problem_;
  std::vector<NsgsContact> contacts_;
  std::vector<ContactScale> scales_;
  VecX r_, saved_;
};

}  // namespace

ContactSolution NsgsSolver::solve(const ContactProblem& problem, const VecX& guess) const {
  return solve_row_islands(problem, guess, settings_.shared, [&](const RowIsland& island) {
    BodiesIsland sweeps(island);
    return iterate(sweeps, island.island.last - island.island.first, settings_);
  });
}

ContactSolution NsgsSolver::solve(const LocalProblem& problem, const VecX& guess) const {
  NILAS_DEMAND(guess.size() == 0 || guess.size() == 3 * problem.num_contacts());
  return solve_islands(problem, guess, [&](const LocalProblem& island, const VecX& start) {
    LocalIsland sweeps(island, start);
    ContactSolution solution = iterate(sweeps, island.num_contacts(), settings_);
    solution.r = sweeps.impulses();
    const std::string culprit = find_culprit(island, solution.r, settings_.shared.tolerance);
    if (!culprit.empty()) {
      solution.status = SolveStatus::numerical_error;
      solution.message = culprit;
    }
    return solution;
  });
}

}  // namespace nilas
