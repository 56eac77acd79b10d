#include "contact/solvers/pgs.h"

#include <algorithm>
#include <limits>

#include "contact/operators.h"
#include "contact/solvers/pgs_rows.h"
#include "contact/solvers/pgs_sweep.h"
#include "contact/solvers/time_limit.h"
#include "core/base/error.h"
#include "core/base/parallel.h"

namespace nilas {

namespace {

/// Closing slower than this is rounding where nothing can move [m/s].
constexpr double k_closing_speed = 1e-9;
/// law_map must fall by this share to count as progress.
constexpr double k_progress = 1e-3;
/// `measure` finds the same law_map up to rounding.
constexpr double k_agreed_share = 1 - 1e-12;
/// Sweeps before the first measurement that no small change called for; later ones at growing distance.
constexpr int k_first_measurement = 20;

/// Decides when an island is measured and when it has stalled.
class Stop {
 public:
  Stop(double tolerance, int stall_sweeps) : tolerance_(tolerance), stall_sweeps_(stall_sweeps), enough_(tolerance) {}

  /// A sweep's largest change predicts law_map; sweeps that change much are measured now and then.
  bool measurement_due(int sweep, double change) const { return change <= enough_ || sweep >= next_; }

  /// Takes the law_map measured after a sweep with this largest change. True if there is no progress any more.
  bool stalled(int sweep, double change, double law_map) {
    const bool fixed = change == 0 && last_change_ == 0;
    last_change_ = change;
    next_ = sweep + std::max(k_first_measurement, sweep / 2);
    enough_ = std::min(enough_, change * tolerance_ / law_map);
    if (law_map < (1 - k_progress) * best_) {
      best_ = law_map;
      best_sweep_ = sweep;
    }
    return fixed || sweep - best_sweep_ >= stall_sweeps_;
  }

 private:
  double tolerance_;
  int stall_sweeps_;
  double enough_;
  int next_ = k_first_measurement;
  double last_change_ = 1;
  double best_ = std::numeric_limits<double>::infinity();
  int best_sweep_ = 0;
};

struct Outcome {
  SolveStatus status = SolveStatus::iteration_limit;
  int iterations = 0;
  std::vector<double> history;
  int culprit = -1;  ///< contact of the problem that closes although nothing can move
  double closing_speed = 0;
};

/// One solve: the problem, its rows and the true velocities. Islands touch different parts of all three.
class Solve {
 public:
  Solve(const ContactProblem& problem, const MassInverse& masses, PgsRows& rows, const PgsSettings& settings)
      : problem_(problem),
        masses_(masses),
        rows_(rows),
        settings_(settings),
        time_limit_(settings.shared),
        v_(VecX::Zero(problem.num_velocities())),
        sweep_(pgs_sweep(problem.law, settings.shared.tolerance > 0)) {}

  Outcome run(const PgsIsland& island) {
    const SolverSettings& shared = settings_.shared;
    Outcome outcome;
    Stop stop(shared.tolerance, std::max(settings_.stall_sweeps, island.last - island.first));
    while (outcome.status == SolveStatus::iteration_limit && outcome.iterations < shared.max_iterations &&
           !time_limit_.over()) {
      const bool backward = settings_.symmetric_sweeps && outcome.iterations % 2 == 1;
      const double change = sweep_(rows_, island, backward);
      ++outcome.iterations;
      if (shared.keep_history) outcome.history.push_back(true_law_map(island));
      const bool last = outcome.iterations == shared.max_iterations;
      if (shared.tolerance > 0 && (last || stop.measurement_due(outcome.iterations, change)))
        outcome.status = judge(island, stop, outcome.iterations, change);
    }
    find_culprit(island, outcome);
    return outcome;
  }

 private:
  /// law_map of the island with velocities M^-1 (f + H r) from the impulses alone, as `measure` has it.
  double true_law_map(const PgsIsland& island) {
    set_true_velocities(island);
    double worst = 0;
    for (int k = island.first; k < island.last; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const int c = rows_.source[i];
      const Vec3 r = Eigen::Map<const Vec3>(rows_.contacts[i].r);
      const Vec3 u = compliant_velocity(problem_.compliance[static_cast<std::size_t>(c)], r,
                                        contact_velocity(problem_, c, v_.data()));
      worst = std::max(worst, law_map(problem_.law, problem_.facets, rows_.scales[i], r, u));
    }
    return worst;
  }

  void set_true_velocities(const PgsIsland& island) {
    for (const int k : island.blocks) {
      const int first = problem_.block_offset[static_cast<std::size_t>(k)];
      v_.segment(first, problem_.block_size(k)) = problem_.f.segment(first, problem_.block_size(k));
    }
    for (int k = island.first; k < island.last; ++k) {
      const auto i = static_cast<std::size_t>(k);
      add_impulse(problem_, rows_.source[i], Eigen::Map<const Vec3>(rows_.contacts[i].r), v_.data());
    }
    for (const int k : island.blocks) {
      double* const block = v_.data() + problem_.block_offset[static_cast<std::size_t>(k)];
      masses_.apply(k, block, block);
    }
  }

  SolveStatus judge(const PgsIsland& island, Stop& stop, int sweep, double change) {
    const double law_map = true_law_map(island);
    if (law_map <= k_agreed_share * settings_.shared.tolerance) return SolveStatus::converged;
    // the sweeps go on from the true velocities, free of accumulated rounding
    for (const int k : island.blocks)
      rows_.velocities.segment(rows_.first_velocity[static_cast<std::size_t>(k)], problem_.block_size(k)) =
          v_.segment(problem_.block_offset[static_cast<std::size_t>(k)], problem_.block_size(k));
    return stop.stalled(sweep, change, law_map) ? SolveStatus::stalled : SolveStatus::iteration_limit;
  }

  void find_culprit(const PgsIsland& island, Outcome& outcome) {
    for (int k = island.first; k < island.last; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (!rows_.contacts[i].unanswerable) continue;
      set_true_velocities(island);
      const double u_n = contact_velocity(problem_, rows_.source[i], v_.data())[0];
      if (u_n >= -std::max(k_closing_speed, settings_.shared.tolerance)) continue;
      outcome.status = SolveStatus::numerical_error;
      outcome.culprit = rows_.source[i];
      outcome.closing_speed = -u_n;
      return;
    }
  }

  const ContactProblem& problem_;
  const MassInverse& masses_;
  PgsRows& rows_;
  const PgsSettings& settings_;
  TimeLimit time_limit_;
  VecX v_;
  PgsSweep sweep_;
};

int severity(SolveStatus status) {
  switch (status) {
    case SolveStatus::converged:
      return 0;
    case SolveStatus::iteration_limit:
      return 1;
    case SolveStatus::stalled:
      return 2;
    case SolveStatus::numerical_error:
      return 3;
  }
  return 3;
}

/// The islands' worst: an island that stopped early keeps its last law_map.
std::vector<double> merge_histories(const std::vector<Outcome>& outcomes, int iterations) {
  std::vector<double> merged(static_cast<std::size_t>(iterations), 0.0);
  for (const auto& outcome : outcomes)
    for (std::size_t k = 0; k < merged.size() && !outcome.history.empty(); ++k)
      merged[k] = std::max(merged[k], outcome.history[std::min(k, outcome.history.size() - 1)]);
  return merged;
}

void merge(const ContactProblem& problem, const std::vector<Outcome>& outcomes, bool keep_history,
           ContactSolution& out) {
  out.status = SolveStatus::converged;
  for (const auto& outcome : outcomes) {
    out.iterations = std::max(out.iterations, outcome.iterations);
    if (severity(outcome.status) > severity(out.status)) out.status = outcome.status;
    if (outcome.culprit >= 0 && out.message.empty())
      out.message = "contact " + std::to_string(outcome.culprit) + " (key " +
                    std::to_string(problem.key[static_cast<std::size_t>(outcome.culprit)]) + ") closes at " +
                    std::to_string(outcome.closing_speed) + " m/s, but neither side can move and it has no force limit";
  }
  if (keep_history) out.history = merge_histories(outcomes, out.iterations);
}

void fail(const std::string& message, ContactSolution& out) {
  out.status = SolveStatus::numerical_error;
  out.message = message;
}

void demand_law(Law law) {
  if (law == Law::ccp || law == Law::pyramid_k)
    throw InputError("solver 'pgs' knows the laws pyramid, coulomb and frictionless; choose one of them");
}

void demand_sizes(const ContactProblem& problem) {
  const std::size_t nc = problem.pairs.size();
  NILAS_DEMAND(problem.f.size() == problem.num_velocities());
  NILAS_DEMAND(problem.w.size() == 3 * problem.num_contacts() && problem.jacobian_offset.size() == nc + 1);
  NILAS_DEMAND(problem.mu.size() == nc && problem.force_limit.size() == nc && problem.compliance.size() == nc);
  NILAS_DEMAND(problem.key.size() == nc);
}

}  // namespace

ContactSolution PgsSolver::solve(const ContactProblem& problem, const VecX& guess) const {
  demand_law(problem.law);
  NILAS_DEMAND(guess.size() == 0 || guess.size() == 3 * problem.num_contacts());
  demand_sizes(problem);
  const int threads = settings_.shared.threads;
  const MassInverse masses(problem);
  PgsRows rows = make_pgs_rows(problem, masses, guess, threads);

  ContactSolution out;
  out.r = VecX::Zero(3 * problem.num_contacts());
  if (masses.first_bad_block() >= 0) {
    fail("mass block " + std::to_string(masses.first_bad_block()) + " is not positive definite", out);
  } else if (!rows.finite || !guess.allFinite()) {
    fail("the problem or the guess holds numbers that are not finite", out);
  } else {
    std::vector<Outcome> outcomes(rows.islands.size());
    Solve solve(problem, masses, rows, settings_);
    parallel_for(static_cast<std::ptrdiff_t>(outcomes.size()), threads, [&](std::ptrdiff_t k) {
      outcomes[static_cast<std::size_t>(k)] = solve.run(rows.islands[static_cast<std::size_t>(k)]);
    });
    for (std::size_t k = 0; k < rows.source.size(); ++k)
      out.r.segment<3>(3 * static_cast<Eigen::Index>(rows.source[k])) = Eigen::Map<const Vec3>(rows.contacts[k].r);
    merge(problem, outcomes, settings_.shared.keep_history, out);
  }
  out.v = velocities(problem, masses, out.r);
  out.u = contact_velocities(problem, out.v);
  if (out.status != SolveStatus::numerical_error && !(out.v.allFinite() && out.r.allFinite()))
    fail("the impulses grew beyond all numbers", out);
  return out;
}

}  // namespace nilas
