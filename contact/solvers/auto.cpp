#include "contact/solvers/auto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/law/law_map.h"
#include "contact/problem/islands.h"
#include "contact/problem/operators.h"
#include "contact/problem/reducible.h"
#include "contact/solvers/admm.h"
#include "contact/solvers/apgd.h"
#include "contact/solvers/continuation.h"
#include "contact/solvers/ipm.h"
#include "contact/solvers/newton.h"
#include "contact/solvers/nsgs.h"
#include "contact/solvers/shared/row_residual.h"
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

bool known_to_admm_and_ipm(Law law) { return law == Law::coulomb || law == Law::ccp || law == Law::frictionless; }

/// What a climb starts from: no impulses at all, or a guess from outside, and whether the first sweeps are behind it.
struct Start {
  bool cold = true, swept = false;
};

/// Zeros tell nothing: a scene's first step guesses them.
bool is_cold(const VecX& guess) { return guess.size() == 0 || guess.isZero(0); }

/// One island on its way up.
class Climb {
 public:
  Climb(const LocalProblem& island, const AutoSettings& settings, Log& log)
      : island_(island), settings_(settings), log_(log) {}

  ContactSolution run(const VecX& guess, Start start) {
    best_.r = guess.size() > 0 ? guess : VecX(VecX::Zero(island_.q.size()));
    best_.status = SolveStatus::iteration_limit;
    best_map_ = measure(island_, best_.r).law_map_m_s;
    if (!std::isfinite(best_map_)) {
      best_.r.setZero();
      best_map_ = std::numeric_limits<double>::infinity();
    }
    const bool warm = !start.cold && !start.swept;
    if (best_map_ <= settings_.shared.tolerance) best_.status = SolveStatus::converged;
    if (!start.swept && goes_on()) sweep("nsgs", settings_.first_sweeps);
    if (start.cold && known_to_admm_and_ipm(island_.law) && goes_on() && is_stiff()) alternate();
    if (goes_on()) newton("newton", warm ? k_warm_weight : k_cold_weight, settings_.first_factorisations);
    if (goes_on()) sweep("more nsgs", settings_.more_sweeps);
    if (goes_on()) newton("wary newton", k_wary_weight, settings_.more_factorisations);
    if (goes_on() && island_.law != Law::frictionless) follow_friction();
    if (goes_on() && known_to_admm_and_ipm(island_.law)) {
      interior_point();
      if (goes_on()) newton("last newton", k_cold_weight, settings_.first_factorisations);
    }
    return best_;
  }

 private:
  bool goes_on() const {
    return best_.status != SolveStatus::converged && !hopeless_ && best_.iterations < settings_.shared.max_iterations &&
           !settings_.shared.out_of_time();
  }

  SolverSettings stage(int most_iterations) const {
    SolverSettings shared = settings_.shared;
    shared.max_iterations = std::min(most_iterations, shared.max_iterations - best_.iterations);
    return shared;
  }

  void sweep(const char* rung, int sweeps) {
    take(rung, "sweeps", NsgsSolver({.shared = stage(sweeps)}).solve(island_, best_.r));
  }

  /// Sweeps hardly moved it, and much of it sticks already: what slips or opens keeps admm busy for long.
  bool is_stiff() const {
    int sticking = 0;
    for (int c = 0; c < island_.num_contacts(); ++c) {
      const Vec3 r = best_.r.segment<3>(3 * static_cast<Eigen::Index>(c));
      constexpr double k_inside = 0.99;  // of the cone
      const double slip = k_inside * island_.mu[static_cast<std::size_t>(c)] * r[0];
      if (r[0] > 0 && r.tail<2>().norm() < slip) ++sticking;
    }
    if (sticking < settings_.sticking_share * island_.num_contacts()) return false;
    return best_map_ > settings_.stiff_share * measure(island_, VecX::Zero(best_.r.size())).law_map_m_s;
  }

  void alternate() {
    AdmmSettings settings{.shared = stage(settings_.shared.max_iterations)};
    settings.first_exponent = 0;  // what sticks wants a lower penalty than admm starts with by itself
    settings.least_fall = settings_.stiff_least_fall;
    take("admm", "iterations", AdmmSolver(settings).solve(island_, {}));
  }

  void newton(const char* rung, double weight, int factorisations) {
    NewtonSettings settings{.shared = stage(factorisations)};
    settings.first_weight = weight;
    take(rung, "factorisations", newton_island(island_, best_.r, settings));
  }

  void follow_friction() {
    NewtonSettings settings{.shared = stage(settings_.shared.max_iterations)};
    settings.max_factorisations = settings_.path_factorisations;
    settings.plunge = settings.fall = 0.1;  // a slower fall, good in jams, loses the path in piles of spheres
    settings.shared.keep_history = false;   // of other problems than this one
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
    if (map <= best_map_) {
      best_map_ = map;
      best_.r = found.r;
    }
    // a rung that fails is no reason to stop, unless no rung could do it
    hopeless_ = found.status == SolveStatus::numerical_error &&
                !find_culprit(island_, best_.r, settings_.shared.tolerance).empty();
  }

  const LocalProblem& island_;
  const AutoSettings& settings_;
  Log& log_;
  ContactSolution best_;
  double best_map_ = 0;
  bool hopeless_ = false;
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

/// The islands whose law_map is above the tolerance, or that nothing can move.
std::vector<std::vector<int>> unsolved(const ContactProblem& problem, const VecX& r, double tolerance) {
  const MassInverse masses(problem);
  const VecX v = velocities(problem, masses, r);
  std::vector<double> response(largest_response(problem));
  const auto is_solved = [&](int c) {
    const double d = inverse_mass_scale(problem, masses, c, response.data());
    const Vec3 r_c = r.segment<3>(3 * static_cast<Eigen::Index>(c));
    const Vec3 u = compliant_velocity(problem.compliance[static_cast<std::size_t>(c)], r_c,
                                      contact_velocity(problem, c, v.data()));
    return law_map(problem.law, problem.facets, contact_scale(problem, c, d), r_c, u) <= tolerance;
  };
  auto islands = find_islands(problem);
  std::erase_if(islands,
                [&](const std::vector<int>& island) { return std::all_of(island.begin(), island.end(), is_solved); });
  return islands;
}

/// Climbs for an island whose W is too large to be formed or factorised: more sweeps, then the projected gradient where
/// it knows the law, each with half of the iterations. The better impulses go into `whole.r`, iterations into `whole`.
SolveStatus solve_without_w(const ContactProblem& problem, const std::vector<int>& island, const AutoSettings& settings,
                            Log& log, ContactSolution& whole) {
  const ContactProblem part = select(problem, island);
  VecX r(3 * static_cast<Eigen::Index>(island.size()));
  for (std::size_t i = 0; i < island.size(); ++i)
    r.segment<3>(3 * static_cast<Eigen::Index>(i)) = whole.r.segment<3>(3 * static_cast<Eigen::Index>(island[i]));
  SolverSettings left = settings.shared;
  const int all = left.max_iterations;
  left.max_iterations = (all + 1) / 2;
  ContactSolution found = NsgsSolver({.shared = left}).solve(part, r);
  log.add("more nsgs", "sweeps", found.iterations);
  left.max_iterations = all - found.iterations;
  if (found.status != SolveStatus::converged && part.law != Law::pyramid && left.max_iterations > 0 &&
      !left.out_of_time()) {
    const int swept = found.iterations;
    ContactSolution next = ApgdSolver({.shared = left}).solve(part, found.r);
    log.add("apgd", "iterations", next.iterations);
    const double map = measure(part, next.r).law_map_m_s, swept_map = measure(part, found.r).law_map_m_s;
    if (map <= swept_map || std::isnan(swept_map)) found = std::move(next);
    found.iterations += swept;
  }
  for (std::size_t i = 0; i < island.size(); ++i)
    whole.r.segment<3>(3 * static_cast<Eigen::Index>(island[i])) = found.r.segment<3>(3 * static_cast<Eigen::Index>(i));
  whole.iterations += found.iterations;
  if (found.status == SolveStatus::numerical_error) whole.message = found.message;
  return found.status;
}

/// What was used, after what failed.
void describe(const Log& log, ContactSolution& solution) {
  const std::string failure = solution.status == SolveStatus::numerical_error ? solution.message + "; " : "";
  solution.message = failure + log.text();
}

}  // namespace

ContactSolution AutoSolver::solve(const LocalProblem& problem, const VecX& guess) const {
  AutoSettings running = settings_;
  running.shared = settings_.shared.started();
  const bool cold = is_cold(guess);
  Log log;
  ContactSolution solution = solve_islands(problem, guess, [&](const LocalProblem& island, const VecX& start) {
    return Climb(island, running, log).run(start, {cold, false});
  });
  describe(log, solution);
  return solution;
}

ContactSolution AutoSolver::solve(const ContactProblem& problem, const VecX& guess) const {
  NILAS_DEMAND(guess.size() == 0 || guess.size() == 3 * static_cast<Eigen::Index>(problem.num_contacts()));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double tolerance = settings_.shared.tolerance;
  const bool cold = is_cold(guess);
  double guess_map = guess.size() > 0 ? measure(problem, guess).law_map_m_s : infinity;
  if (guess_map <= tolerance) return accepted(problem, guess);
  if (std::isnan(guess_map)) guess_map = infinity;
  AutoSettings running = settings_;
  running.shared = with_margin(settings_.shared.started());
  Log log;
  SolverSettings sweeps = running.shared;
  // with moments the ladder has one rung
  if (!problem.has_moments()) {
    const int all = sweeps.max_iterations;
    sweeps.max_iterations = std::min(settings_.first_sweeps, all);
    // half of the iterations is left for the next rungs
    if (!cold) sweeps.max_iterations = std::max(sweeps.max_iterations, std::min(settings_.warm_sweeps, all / 2));
  }
  ContactSolution swept = NsgsSolver({.shared = sweeps}).solve(problem, guess);
  log.add("nsgs", "sweeps", swept.iterations);
  if (swept.status == SolveStatus::converged || problem.has_moments()) {
    describe(log, swept);
    return swept;
  }
  const double swept_map = measure(problem, swept.r).law_map_m_s;
  if (guess_map < swept_map || (std::isnan(swept_map) && std::isfinite(guess_map))) swept.r = guess;
  running.shared.max_iterations -= swept.iterations;
  auto islands = unsolved(problem, swept.r, running.shared.tolerance);
  const auto first_large =
      std::stable_partition(islands.begin(), islands.end(), [&](const auto& i) { return is_reducible(problem, i); });
  SolveStatus large = SolveStatus::converged;
  for (auto island = first_large; island != islands.end(); ++island)
    large = worse(large, solve_without_w(problem, *island, running, log, swept));
  islands.erase(first_large, islands.end());
  ContactSolution solution =
      solve_islands(problem, islands, swept.r, [&](const LocalProblem& island, const VecX& start) {
        return Climb(island, running, log).run(start, {cold, true});
      });
  solution.iterations += swept.iterations;
  if (large == SolveStatus::numerical_error && solution.message.empty()) solution.message = swept.message;
  solution.status = worse(solution.status, large);
  solution.history.insert(solution.history.begin(), swept.history.begin(), swept.history.end());
  if (solution.status == SolveStatus::converged && !(measure(problem, solution.r).law_map_m_s <= tolerance))
    solution.status = SolveStatus::stalled;
  describe(log, solution);
  return solution;
}

}  // namespace nilas
