#include "contact/solvers/auto.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "contact/solvers/continuation.h"
#include "contact/solvers/ipm.h"
#include "contact/solvers/newton.h"
#include "contact/solvers/nsgs.h"
#include "core/base/error.h"

namespace nilas {

namespace {

/// Proximal weights of newton [-]: near a solution, from a first guess, and where that failed.
constexpr double k_warm_weight = 1e-5;
constexpr double k_cold_weight = 1e-3;
constexpr double k_wary_weight = 1e-2;

/// What the rungs did, for the message.
class Log {
 public:
  void add(const std::string& rung, const char* unit, int iterations) {
    const auto found = std::find_if(uses_.begin(), uses_.end(), [&](const Use& use) { return use.rung == rung; });
    Use& use = found == uses_.end() ? uses_.emplace_back(Use{rung, unit}) : *found;
    ++use.islands;
    use.most = std::max(use.most, iterations);
  }

  std::string text() const {
    std::string all;
    for (const Use& use : uses_) {
      all += (all.empty() ? "" : ", ") + use.rung + " " + std::to_string(use.most) + " " + use.unit;
      if (use.islands > 1) all += " on " + std::to_string(use.islands) + " islands";
    }
    return all.empty() ? "guess" : all;
  }

 private:
  struct Use {
    std::string rung, unit;
    int islands = 0;
    int most = 0;
  };
  std::vector<Use> uses_;
};

/// Wall time left of what the settings allow.
class Clock {
 public:
  explicit Clock(double max_seconds) : max_seconds_(max_seconds), start_(Steady::now()) {}
  double used() const { return std::chrono::duration<double>(Steady::now() - start_).count(); }
  bool over() const { return max_seconds_ > 0 && used() >= max_seconds_; }
  /// For SolverSettings::max_seconds, where 0 means no limit.
  double left() const { return max_seconds_ > 0 ? std::max(max_seconds_ - used(), 1e-9) : 0; }

 private:
  using Steady = std::chrono::steady_clock;
  double max_seconds_;
  Steady::time_point start_;
};

bool ipm_knows(Law law) { return law == Law::coulomb || law == Law::ccp || law == Law::frictionless; }

/// One island on its way up.
class Climb {
 public:
  Climb(const LocalProblem& island, const AutoSettings& settings, const Clock& clock, Log& log)
      : island_(island), settings_(settings), clock_(clock), log_(log) {}

  ContactSolution run(const VecX& guess, bool swept) {
    best_.r = guess.size() > 0 ? guess : VecX(VecX::Zero(island_.q.size()));
    best_.status = SolveStatus::iteration_limit;
    best_map_ = measure(island_, best_.r).law_map_m_s;
    const bool warm = guess.size() > 0 && !swept;
    if (best_map_ <= settings_.shared.tolerance) best_.status = SolveStatus::converged;
    if (!swept && goes_on()) sweep("nsgs", settings_.first_sweeps);
    if (goes_on()) newton("newton", warm ? k_warm_weight : k_cold_weight, settings_.first_factorisations);
    if (goes_on()) sweep("more nsgs", settings_.more_sweeps);
    if (goes_on()) newton("wary newton", k_wary_weight, settings_.more_factorisations);
    if (goes_on() && island_.law != Law::frictionless) follow_friction();
    if (goes_on() && ipm_knows(island_.law)) {
      interior_point();
      if (goes_on()) newton("last newton", k_cold_weight, settings_.first_factorisations);
    }
    return best_;
  }

 private:
  bool goes_on() const {
    return best_.status != SolveStatus::converged && best_.status != SolveStatus::numerical_error &&
           best_.iterations < settings_.shared.max_iterations && !clock_.over();
  }

  SolverSettings stage(int most_iterations) const {
    SolverSettings shared = settings_.shared;
    shared.max_iterations = std::min(most_iterations, shared.max_iterations - best_.iterations);
    shared.max_seconds = clock_.left();
    return shared;
  }

  void sweep(const char* rung, int sweeps) {
    take(rung, "sweeps", NsgsSolver({.shared = stage(sweeps)}).solve(island_, best_.r));
  }

  void newton(const char* rung, double weight, int factorisations) {
    NewtonSettings settings{.shared = stage(factorisations)};
    settings.first_weight = weight;
    take(rung, "factorisations", newton_island(island_, best_.r, settings));
  }

  void follow_friction() {
    NewtonSettings settings{.shared = stage(settings_.shared.max_iterations)};
    settings.max_factorisations = settings_.path_factorisations;
    settings.shared.keep_history = false;  // of other problems than this one
    take("friction continuation", "iterations", continue_in_friction(island_, settings));
  }

  void interior_point() {
    take("ipm", "factorisations", IpmSolver({.shared = stage(settings_.ipm_factorisations)}).solve(island_, best_.r));
  }

  void take(const char* rung, const char* unit, const ContactSolution& found) {
    log_.add(rung, unit, found.iterations);
    best_.iterations += found.iterations;
    best_.history.insert(best_.history.end(), found.history.begin(), found.history.end());
    best_.status = found.status;
    best_.message = found.message;
    const double map = measure(island_, found.r).law_map_m_s;
    if (!(map <= best_map_)) return;
    best_map_ = map;
    best_.r = found.r;
  }

  const LocalProblem& island_;
  const AutoSettings& settings_;
  const Clock& clock_;
  Log& log_;
  ContactSolution best_;
  double best_map_ = 0;
};

/// The guess as the solution.
ContactSolution accepted(const ContactProblem& problem, const VecX& guess) {
  ContactSolution solution;
  solution.r = guess;
  solution.v = velocities(problem, guess);
  solution.u = contact_velocities(problem, solution.v);
  solution.status = SolveStatus::converged;
  solution.message = "guess";
  return solution;
}

/// What was used, after what failed.
void describe(const Log& log, ContactSolution& solution) {
  const std::string failure = solution.status == SolveStatus::numerical_error ? solution.message + "; " : "";
  solution.message = failure + log.text();
}

}  // namespace

ContactSolution AutoSolver::solve(const LocalProblem& problem, const VecX& guess) const {
  NILAS_DEMAND(guess.size() == 0 || guess.size() == problem.q.size());
  const Clock clock(settings_.shared.max_seconds);
  Log log;
  ContactSolution solution = solve_islands(problem, guess, [&](const LocalProblem& island, const VecX& start) {
    return Climb(island, settings_, clock, log).run(start, false);
  });
  describe(log, solution);
  return solution;
}

ContactSolution AutoSolver::solve(const ContactProblem& problem, const VecX& guess) const {
  NILAS_DEMAND(guess.size() == 0 || guess.size() == 3 * problem.num_contacts());
  if (guess.size() > 0 && measure(problem, guess).law_map_m_s <= settings_.shared.tolerance)
    return accepted(problem, guess);
  const Clock clock(settings_.shared.max_seconds);
  Log log;
  SolverSettings sweeps = settings_.shared;
  sweeps.max_iterations = std::min(settings_.first_sweeps, sweeps.max_iterations);
  ContactSolution swept = NsgsSolver({.shared = sweeps}).solve(problem, guess);
  log.add("nsgs", "sweeps", swept.iterations);
  if (swept.status == SolveStatus::converged || swept.status == SolveStatus::numerical_error) {
    describe(log, swept);
    return swept;
  }
  AutoSettings rest = settings_;
  rest.shared.max_iterations -= swept.iterations;
  ContactSolution solution = solve_islands(problem, swept.r, [&](const LocalProblem& island, const VecX& start) {
    return Climb(island, rest, clock, log).run(start, true);
  });
  solution.iterations += swept.iterations;
  solution.history.insert(solution.history.begin(), swept.history.begin(), swept.history.end());
  describe(log, solution);
  return solution;
}

}  // namespace nilas
