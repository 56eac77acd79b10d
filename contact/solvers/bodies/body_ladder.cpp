#include "contact/solvers/bodies/body_ladder.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "contact/measure/measure.h"
#include "contact/problem/row_of.h"
#include "contact/solvers/bodies/body_system.h"
#include "contact/solvers/bodies/interior_on_bodies.h"
#include "contact/solvers/newton.h"

namespace nilas::solvers {

namespace {

/// Newton's least proximal weight that its systems on bodies bear [-].
constexpr double k_least_weight_on_bodies = 1e-9;

/// A round of the ladder: the interior point hands over to Newton at a residual. Below 1e-5 m/s rounding often costs it
/// more iterations than Newton needs, above it Newton has a longer search for the contacts that carry something. Where
/// that search is long even so, the second round brings Newton nearer.
struct LadderRound {
  double handover;     ///< [m/s]
  bool starts_lagged;  ///< whether the shift is lagged before it is differentiated
  int factorisations;  ///< most of Newton
};
constexpr LadderRound k_ladder_rounds[] = {{1e-5, true, 40}, {1e-6, false, 120}};

/// With more friction than this on any contact a lagged shift converges slowly or not at all, and is left out [-].
constexpr double k_most_lagged_friction = 0.2;

/// One solve of the ladder.
class BodyClimb {
 public:
  BodyClimb(const contact::PreparedProblem& island, const VecX& guess, const contact::SolverSettings& settings,
            const Budget& budget)
      : island_(island), settings_(settings), budget_(budget), bodies_(island), plan_(plan_nodes(bodies_)) {
    start_ = guess.size() > 0 ? guess : VecX(VecX::Zero(contact::row_of(bodies_.num_contacts())));
    const auto& mu = island.problem().mu;
    may_lag_ =
        island.problem().law != Law::coulomb || *std::max_element(mu.begin(), mu.end()) <= k_most_lagged_friction;
    no_impulses_ = VecX::Zero(start_.size());
    best_.r = start_;
    best_.law_map_m_s = contact::measure(island, start_).law_map_m_s;
  }

  BodyOutcome run() {
    for (const LadderRound& round : k_ladder_rounds) {
      if (is_done()) break;
      approach(round);
      if (!is_done()) finish(round);
    }
    best_.has_converged = best_.law_map_m_s <= settings_.tolerance;
    return std::move(best_);
  }

 private:
  bool is_done() const {
    return best_.law_map_m_s <= settings_.tolerance || !budget_.allows(best_.interior + best_.newton);
  }
  Budget left() const { return budget_.after(best_.interior + best_.newton); }

  void keep_better(const VecX& r) {
    const double map = contact::measure(island_, r).law_map_m_s;
    if (!(map < best_.law_map_m_s)) return;
    best_.law_map_m_s = map;
    best_.r = r;
  }
  void note(const std::vector<double>& history) {
    if (settings_.keep_history) best_.history.insert(best_.history.end(), history.begin(), history.end());
  }

  void approach(const LadderRound& round) {
    const double goal = std::max(settings_.tolerance, round.handover);
    if (!interior_) interior_.emplace(island_, bodies_, plan_);
    for (const Shift shift : {Shift::lagged, Shift::differentiated}) {
      if (shift == Shift::lagged && !(round.starts_lagged && may_lag_)) continue;
      if (shift == Shift::differentiated && island_.problem().law != Law::coulomb) continue;
      if (best_.law_map_m_s <= goal || is_done()) break;
      // a start that the first run did not come from is no better for the second than none
      const VecX& from = shift == Shift::lagged ? start_ : no_impulses_;
      const auto found = interior_->run(from, goal, left(), shift);
      best_.interior += found.iterations;
      note(found.history);
      keep_better(found.r);
    }
  }

  void finish(const LadderRound& round) {
    NewtonSettings settings{.shared = settings_};
    settings.least_weight = k_least_weight_on_bodies;
    settings.max_factorisations = round.factorisations;
    BodySystem system(island_, bodies_, plan_);
    const auto found = newton_on(system, best_.r, settings, left());
    best_.newton += found.iterations;
    note(found.history);
    keep_better(found.r);
  }

  const contact::PreparedProblem& island_;
  const contact::SolverSettings& settings_;
  const Budget& budget_;
  BodyIsland bodies_;
  NodePlan plan_;
  std::optional<InteriorOnBodies> interior_;
  VecX start_, no_impulses_;
  bool may_lag_ = true;
  BodyOutcome best_;
};

}  // namespace

bool fits_bodies(const contact::PreparedProblem& island) {
  const contact::ContactProblem& problem = island.problem();
  const bool is_cone = problem.law == Law::coulomb || problem.law == Law::ccp || problem.law == Law::frictionless;
  const auto all_finite = [](const std::vector<double>& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  };
  const auto& scales = island.inverse_mass_scales();
  return is_cone && !problem.has_moments() && has_roots(island) && problem.f.allFinite() && problem.w.allFinite() &&
         all_finite(problem.jacobian_data) && all_finite(problem.mu) && all_finite(problem.compliance) &&
         std::all_of(scales.begin(), scales.end(), [](double d) { return d > 0; });
}

BodyOutcome solve_on_bodies(const contact::PreparedProblem& island, const VecX& guess,
                            const contact::SolverSettings& settings, const Budget& budget) {
  return BodyClimb(island, guess, settings, budget).run();
}

}  // namespace nilas::solvers
