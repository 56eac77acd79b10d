#include "contact/solvers/auto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "contact/problem/islands.h"
#include "contact/problem/operators.h"
#include "contact/problem/reducible.h"
#include "contact/problem/row_of.h"
#include "contact/solvers/admm.h"
#include "contact/solvers/apgd.h"
#include "contact/solvers/body_ladder.h"
#include "contact/solvers/closing_contacts.h"
#include "contact/solvers/continuation.h"
#include "contact/solvers/ipm.h"
#include "contact/solvers/newton.h"
#include "contact/solvers/nsgs.h"
#include "contact/solvers/shared/row_residual.h"
#include "core/base/error.h"
#include "core/base/parallel.h"

namespace nilas::solvers {

namespace {

/// Proximal weights of newton [-]: near a solution, from a first guess, and where that failed.
constexpr double k_warm_weight = 1e-5;
constexpr double k_cold_weight = 1e-3;
constexpr double k_wary_weight = 1e-2;

/// Shares of the iterations left that rungs take at most, so that the rungs after them have their turn [-]: sweeps,
/// newton after them, and the continuation in friction.
constexpr double k_sweeps_share = 0.25, k_wary_share = 0.5, k_path_share = 0.7;

/// The work of the rungs, for the message.
class Log {
 public:
  /// On one island.
  void add(const std::string& rung, const char* unit, int iterations) { ++note(rung, unit, iterations).islands; }
  /// On all islands at once, and perhaps again on parts of them.
  void add_sweeps(int sweeps) { note("nsgs", "sweeps", sweeps); }

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
  Use& note(const std::string& rung, const char* unit, int iterations) {
    const auto found = std::find_if(uses_.begin(), uses_.end(), [&](const Use& use) { return use.rung == rung; });
    Use& use = found == uses_.end() ? uses_.emplace_back(Use{rung, unit}) : *found;
    use.most = std::max(use.most, iterations);
    return use;
  }
  std::vector<Use> uses_;
};

bool known_to_admm_and_ipm(Law law) { return law == Law::coulomb || law == Law::ccp || law == Law::frictionless; }

/// The start of a climb: `cold` without a guess, `swept` after the first sweeps.
struct Start {
  bool cold = true, swept = false;
};

/// Returns whether the guess is empty or zero, as in a scene's first step.
bool is_cold(const VecX& guess) { return guess.size() == 0 || guess.isZero(0); }

/// The state of the climb of one island.
struct Height {
  const contact::LocalProblem& island;
  const AutoSettings& settings;
  const Budget& budget;
  Log& log;
  contact::ContactSolution best;  ///< impulses, with the status of the last rung and the iterations of all
  double map = 0;                 ///< law_map of the best impulses [m/s]
  bool is_hopeless = false;       ///< no rung can solve the island

  bool goes_on() const {
    return best.status != contact::SolveStatus::converged && !is_hopeless && budget.allows(best.iterations);
  }
  Budget stage(int most_iterations) const { return left().capped(most_iterations); }
  Budget left() const { return budget.after(best.iterations); }
  /// At least one iteration.
  int share_of_left(double share) const {
    return std::max(1, static_cast<int>(share * static_cast<double>(left().iterations())));
  }

  /// Keeps the impulses of a rung where they are no worse. A rung that fails does not end the climb, unless no other
  /// rung could solve the island.
  void take(const char* rung, const char* unit, const contact::ContactSolution& found) {
    log.add(rung, unit, found.iterations);
    best.iterations += found.iterations;
    best.history.insert(best.history.end(), found.history.begin(), found.history.end());
    best.status = found.status;
    best.message = found.message;
    const double found_map = contact::measure(island, found.r).law_map_m_s;
    if (found_map <= map) {
      map = found_map;
      best.r = found.r;
    }
    is_hopeless = found.status == contact::SolveStatus::numerical_error &&
                  !find_culprit(island, best.r, settings.shared.tolerance).empty();
  }
};

void sweep(const char* rung, int sweeps, Height& at) {
  at.take(rung, "sweeps", NsgsSolver({.shared = at.settings.shared}).solve(at.island, at.best.r, at.stage(sweeps)));
}

/// Returns whether the sweeps hardly reduced the residual and much of the island sticks. Contacts that slip or open
/// would cost admm many iterations.
bool is_stiff(const Height& at) {
  int sticking = 0;
  for (int c = 0; c < at.island.num_contacts(); ++c) {
    const Vec3 r = at.best.r.segment<3>(contact::row_of(c));
    constexpr double k_inside = 0.99;  // of the cone
    const double slip = k_inside * at.island.mu[c] * r[0];
    if (r[0] > 0 && r.tail<2>().norm() < slip) ++sticking;
  }
  if (sticking < at.settings.sticking_share * at.island.num_contacts()) return false;
  return at.map > at.settings.stiff_share * contact::measure(at.island, VecX::Zero(at.best.r.size())).law_map_m_s;
}

void alternate(Height& at) {
  AdmmSettings settings{.shared = at.settings.shared};
  settings.first_exponent = 0;  // sticking contacts need a lower penalty than admm's own first one
  settings.least_fall = at.settings.stiff_least_fall;
  at.take("admm", "iterations", AdmmSolver(settings).solve(at.island, {}, at.stage(at.budget.iterations())));
}

void newton(const char* rung, double weight, int factorisations, Height& at) {
  NewtonSettings settings{.shared = at.settings.shared};
  settings.first_weight = weight;
  at.take(rung, "factorisations", newton_island(at.island, at.best.r, settings, at.stage(factorisations)));
}

void follow_friction(Height& at) {
  NewtonSettings settings{.shared = at.settings.shared};
  settings.max_factorisations = at.settings.path_factorisations;
  settings.plunge = settings.fall = 0.1;  // a slower fall, good in jams, loses the path in piles of spheres
  settings.shared.keep_history = false;   // its history would be of other problems than this one
  at.take("friction continuation", "iterations",
          continue_in_friction(at.island, settings, at.stage(at.share_of_left(k_path_share))));
}

void interior_point(Height& at) {
  at.take(
      "ipm", "factorisations",
      IpmSolver({.shared = at.settings.shared}).solve(at.island, at.best.r, at.stage(at.settings.ipm_factorisations)));
}

/// The ladder of the header, from rung 1 (or, after sweeps of the whole problem, from rung 3).
contact::ContactSolution climb(const contact::LocalProblem& island, const VecX& guess, Start start,
                               const AutoSettings& settings, const Budget& budget, Log& log) {
  Height at{island, settings, budget, log, {}};
  at.best.r = guess.size() > 0 ? guess : VecX(VecX::Zero(island.q.size()));
  at.best.status = contact::SolveStatus::iteration_limit;
  at.map = contact::measure(island, at.best.r).law_map_m_s;
  if (!std::isfinite(at.map)) {  // the guess is beyond all numbers
    at.best.r.setZero();
    at.map = std::numeric_limits<double>::infinity();
  }
  if (at.map <= settings.shared.tolerance) at.best.status = contact::SolveStatus::converged;
  const bool knows_cones = known_to_admm_and_ipm(island.law);
  // With bodies only islands come here that rungs 1 and 2 could not solve from the guess, so it is not near their
  // solution.
  const double first_weight = !start.cold && !start.swept ? k_warm_weight : k_cold_weight;

  if (!start.swept && at.goes_on()) sweep("nsgs", settings.first_sweeps, at);
  if (start.cold && knows_cones && at.goes_on() && is_stiff(at)) alternate(at);
  if (at.goes_on()) newton("newton", first_weight, settings.first_factorisations, at);
  if (at.goes_on()) sweep("more nsgs", std::min(settings.more_sweeps, at.share_of_left(k_sweeps_share)), at);
  if (at.goes_on())
    newton("wary newton", k_wary_weight, std::min(settings.more_factorisations, at.share_of_left(k_wary_share)), at);
  if (at.goes_on() && island.law != Law::frictionless) follow_friction(at);
  if (at.goes_on() && knows_cones) interior_point(at);
  if (at.goes_on() && knows_cones) newton("last newton", k_cold_weight, settings.first_factorisations, at);
  return at.best;
}

/// The guess as the solution.
contact::ContactSolution accepted(const contact::PreparedProblem& problem, const VecX& guess) {
  contact::ContactSolution solution;
  solution.r = guess;
  solution.v = contact::velocities(problem, guess);
  solution.u = contact::contact_velocities(problem.problem(), solution.v);
  solution.status = contact::SolveStatus::converged;
  solution.message = "guess";
  return solution;
}

/// The islands that the bodies did not solve.
struct LeftByBodies {
  std::vector<std::vector<int>> islands;  ///< for the next rungs
  bool has_jam = false;                   ///< one of more contacts than these rungs take
};

/// What the bodies may take of a budget for an island of so many contacts.
Budget of_bodies(const Budget& budget, std::size_t contacts, const AutoSettings& settings) {
  if (static_cast<int>(contacts) >= settings.jam_contacts) return budget;
  return budget.capped(std::max(budget.iterations() - settings.first_factorisations, settings.body_iterations));
}

/// Solves islands on their bodies where that can be, the smallest first, so that the hardest is left when time runs
/// out. Each has the budget of_bodies, whatever the others took. The better impulses, the iterations of the island that
/// took most and the history go into `whole`.
LeftByBodies solve_each_on_bodies(const contact::ContactProblem& problem, std::vector<std::vector<int>> islands,
                                  const AutoSettings& settings, const Budget& budget, Log& log,
                                  contact::ContactSolution& whole) {
  std::stable_sort(islands.begin(), islands.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  std::vector<std::optional<BodyOutcome>> outcomes(islands.size());
  const auto solve = [&](std::ptrdiff_t k) {
    const std::vector<int>& island = islands[static_cast<std::size_t>(k)];
    const VecX r = impulses_of(whole.r, island);
    if (!budget.allows(0) || !r.allFinite()) return;
    const contact::ContactProblem part_problem = contact::select(problem, island);
    outcomes[static_cast<std::size_t>(k)] = solve_on_bodies(contact::PreparedProblem(part_problem), r, settings.shared,
                                                            of_bodies(budget, island.size(), settings));
  };
  const auto first_large = std::partition_point(islands.begin(), islands.end(), [](const auto& island) {
    return static_cast<int>(island.size()) < k_large_on_bodies;
  });
  const std::ptrdiff_t small = first_large - islands.begin();
  parallel_pieces(small, settings.shared.threads, solve);
  for (std::ptrdiff_t k = small; k < static_cast<std::ptrdiff_t>(islands.size()); ++k) solve(k);
  LeftByBodies left;
  std::vector<double> history;
  int most = 0;
  for (std::size_t k = 0; k < islands.size(); ++k) {
    const std::optional<BodyOutcome>& found = outcomes[k];
    const bool is_jam = found && static_cast<int>(islands[k].size()) >= settings.jam_contacts;
    if (found) {
      for (std::size_t i = 0; i < islands[k].size(); ++i)
        whole.r.segment<3>(contact::row_of(islands[k][i])) = found->r.segment<3>(contact::row_of(i));
      if (found->interior > 0) log.add("interior point", "iterations", found->interior);
      if (found->sweeps > 0) log.add("sweeps after it", "sweeps", found->sweeps);
      if (found->newton > 0) log.add("newton on bodies", "factorisations", found->newton);
      most = std::max(most, found->interior + found->sweeps + found->newton);
      merge_history(found->history, history);
      if (found->has_converged) continue;
    }
    left.has_jam = left.has_jam || is_jam;
    if (!is_jam) left.islands.push_back(std::move(islands[k]));
  }
  whole.iterations += most;
  whole.history.insert(whole.history.end(), history.begin(), history.end());
  return left;
}

/// For a stage before one that may need as much.
Budget half_of(const Budget& budget) { return budget.capped((budget.iterations() + 1) / 2); }

/// Climbs for an island whose W is too large to be formed or factorised: more sweeps, then the projected gradient where
/// it knows the law, the first with half of the iterations and the second with the rest. The better impulses go into
/// `whole.r`, iterations into `whole`.
contact::SolveStatus solve_without_w(const contact::ContactProblem& problem, const std::vector<int>& island,
                                     const AutoSettings& settings, const Budget& budget, Log& log,
                                     contact::ContactSolution& whole) {
  const contact::ContactProblem part_problem = contact::select(problem, island);
  const contact::PreparedProblem part(part_problem);
  const VecX r = impulses_of(whole.r, island);
  const contact::SolverSettings& shared = settings.shared;
  contact::ContactSolution found = NsgsSolver({.shared = shared}).solve(part, r, half_of(budget));
  log.add("more nsgs", "sweeps", found.iterations);
  if (found.status != contact::SolveStatus::converged && part_problem.law != Law::pyramid &&
      budget.allows(found.iterations)) {
    const int swept = found.iterations;
    contact::ContactSolution next = ApgdSolver({.shared = shared}).solve(part, found.r, budget.after(swept));
    log.add("apgd", "iterations", next.iterations);
    const double map = contact::largest_law_map(part, next.r, shared.threads),
                 swept_map = contact::largest_law_map(part, found.r, shared.threads);
    if (map <= swept_map || std::isnan(swept_map)) found = std::move(next);
    found.iterations += swept;
  }
  for (std::size_t i = 0; i < island.size(); ++i)
    whole.r.segment<3>(contact::row_of(island[i])) = found.r.segment<3>(contact::row_of(i));
  whole.iterations += found.iterations;
  if (found.status == contact::SolveStatus::numerical_error) whole.message = found.message;
  return found.status;
}

/// The first sweeps of a problem with bodies. With a guess they go on as long as they promise to suffice.
contact::ContactSolution first_rung(const contact::PreparedProblem& prepared, const VecX& guess,
                                    const AutoSettings& settings, const Budget& budget) {
  NsgsSettings sweeps{.shared = settings.shared};
  if (prepared.problem().has_moments())  // the ladder has one rung
    return NsgsSolver(sweeps).solve(prepared, guess, budget);
  const bool cold = is_cold(guess);
  // half of the iterations is left for the next rungs
  const int warm = std::max(settings.first_sweeps, std::min(settings.warm_sweeps, budget.iterations() / 2));
  if (!cold) {
    sweeps.horizon = warm;
    sweeps.has_momentum = true;
  }
  return NsgsSolver(sweeps).solve(prepared, guess, budget.capped(cold ? settings.first_sweeps : warm));
}

/// Impulses and their residual [m/s].
struct Guess {
  const VecX& r;
  double map = 0;
};

/// The ladder of the header for a problem with bodies.
contact::ContactSolution climb_with_bodies(const contact::PreparedProblem& prepared, const Guess& guess,
                                           const AutoSettings& settings, const Budget& budget, Log& log) {
  const contact::ContactProblem& problem = prepared.problem();
  const bool cold = is_cold(guess.r);
  AutoSettings running = settings;
  running.shared = with_margin(settings.shared);
  contact::ContactSolution swept = first_rung(prepared, guess.r, running, budget);
  log.add_sweeps(swept.iterations);
  if (swept.status == contact::SolveStatus::converged || problem.has_moments()) return swept;
  const double swept_map = contact::largest_law_map(prepared, swept.r, settings.shared.threads);
  if (guess.map < swept_map || (std::isnan(swept_map) && std::isfinite(guess.map))) swept.r = guess.r;
  const Budget closing = half_of(budget.after(swept.iterations));
  const auto climb_again = [&](const contact::PreparedProblem& part, const VecX& r, int done) {
    const double map = contact::largest_law_map(part, r, settings.shared.threads);
    return climb_with_bodies(part, {r, map}, settings, closing.after(done), log);
  };
  ClosingOutcome apart = solve_closing(prepared, running.shared.tolerance, climb_again, swept.r);
  swept.iterations += apart.iterations;
  swept.history.insert(swept.history.end(), apart.history.begin(), apart.history.end());
  LeftByBodies unfinished =
      solve_each_on_bodies(problem, std::move(apart.unsolved), running, budget.after(swept.iterations), log, swept);
  std::vector<std::vector<int>>& islands = unfinished.islands;
  const Budget left = budget.after(swept.iterations);
  const auto first_large = std::stable_partition(islands.begin(), islands.end(),
                                                 [&](const auto& i) { return contact::is_reducible(problem, i); });
  contact::SolveStatus large = contact::SolveStatus::converged;
  for (auto island = first_large; island != islands.end(); ++island)
    large = contact::worse(large, solve_without_w(problem, *island, running, left, log, swept));
  islands.erase(first_large, islands.end());
  contact::ContactSolution solution =
      solve_islands(prepared, islands, swept.r, [&](const contact::LocalProblem& island, const VecX& start) {
        return climb(island, start, {cold, true}, running, left, log);
      });
  solution.iterations += swept.iterations;
  if (large == contact::SolveStatus::numerical_error && solution.message.empty()) solution.message = swept.message;
  solution.status = contact::worse(solution.status, large);
  if (unfinished.has_jam)
    solution.status = contact::worse(
        solution.status, left.allows(0) ? contact::SolveStatus::stalled : contact::SolveStatus::iteration_limit);
  solution.history.insert(solution.history.begin(), swept.history.begin(), swept.history.end());
  if (solution.status == contact::SolveStatus::converged &&
      !(contact::largest_law_map(prepared, solution.r, settings.shared.threads) <= settings.shared.tolerance))
    solution.status = contact::SolveStatus::stalled;
  return solution;
}

/// Writes the message: first the failure, then the rungs used.
void describe(const Log& log, contact::ContactSolution& solution) {
  const std::string failure = solution.status == contact::SolveStatus::numerical_error ? solution.message + "; " : "";
  solution.message = failure + log.text();
}

}  // namespace

contact::ContactSolution AutoSolver::solve(const contact::LocalProblem& problem, const VecX& guess) const {
  const Budget budget(settings_.shared);
  const bool cold = is_cold(guess);
  Log log;
  contact::ContactSolution solution =
      solve_islands(problem, guess, [&](const contact::LocalProblem& island, const VecX& start) {
        return climb(island, start, {cold, false}, settings_, budget, log);
      });
  describe(log, solution);
  return solution;
}

contact::ContactSolution AutoSolver::solve(const contact::PreparedProblem& prepared, const VecX& guess) const {
  NILAS_DEMAND(guess.size() == 0 || guess.size() == contact::row_of(prepared.problem().num_contacts()));
  const double map = guess.size() > 0 ? contact::largest_law_map(prepared, guess, settings_.shared.threads)
                                      : std::numeric_limits<double>::infinity();
  if (map <= settings_.shared.tolerance) return accepted(prepared, guess);
  Log log;
  contact::ContactSolution solution =
      climb_with_bodies(prepared, {guess, map}, settings_, Budget(settings_.shared), log);
  describe(log, solution);
  return solution;
}

}  // namespace nilas::solvers
