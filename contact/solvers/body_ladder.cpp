#include "contact/solvers/body_ladder.h"

#include <algorithm>
#include <cmath>
#include <limits>
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
  int factorisations;  ///< most of Newton
};
constexpr LadderRound k_ladder_rounds[] = {{1e-5, 40}, {1e-6, 120}};

/// With more friction than this on any contact a lagged shift converges slowly or not at all, and is left out [-].
constexpr double k_most_lagged_friction = 0.2;

/// One solve of the ladder.
class BodyClimb {
 public:
  BodyClimb(const contact::PreparedProblem& island, const BodyIsland& bodies, const NodePlan& plan, const VecX& start,
            const contact::SolverSettings& settings, const Budget& budget)
      : island_(island),
        settings_(settings),
        budget_(budget),
        interior_(island, bodies, plan),
        system_(island, bodies, plan),
        start_(start) {
    best_.r = start_;
    best_.law_map_m_s = contact::measure(island, start_).law_map_m_s;
    if (!std::isfinite(best_.law_map_m_s)) best_.law_map_m_s = std::numeric_limits<double>::infinity();
  }

  BodyOutcome run() {
    for (const LadderRound& round : k_ladder_rounds) {
      if (is_done()) break;
      approach(std::max(settings_.tolerance, round.handover));
      if (!is_done()) finish(round.factorisations);
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

  /// Returns whether the run reached its goal.
  bool keep(const InteriorOnBodies::Outcome& found, double goal) {
    best_.interior += found.iterations;
    note(found.history);
    keep_better(found.r);
    return found.law_map_m_s <= goal;
  }

  void approach(double goal) {
    if (best_.law_map_m_s <= goal) return;
    if (goes_on_) {
      goes_on_ = keep(interior_.go_on(goal, left()), goal);
      return;
    }
    const contact::ContactProblem& problem = island_.problem();
    const bool is_convex = problem.law != Law::coulomb;
    const auto is_slight = [](double mu) { return mu <= k_most_lagged_friction; };
    if (!has_lagged_ && (is_convex || std::all_of(problem.mu.begin(), problem.mu.end(), is_slight))) {
      has_lagged_ = true;
      goes_on_ = keep(interior_.run(start_, goal, left(), Shift::lagged), goal);
      if (goes_on_ || is_done()) return;
    }
    if (is_convex || has_differentiated_) return;
    has_differentiated_ = true;
    // a start that the first run did not come from is no better than none for the second
    goes_on_ = keep(interior_.run(VecX::Zero(start_.size()), goal, left(), Shift::differentiated), goal);
  }

  void finish(int factorisations) {
    NewtonSettings settings{.shared = settings_};
    settings.least_weight = k_least_weight_on_bodies;
    settings.max_factorisations = factorisations;
    const auto found = newton_on(system_, best_.r, settings, left());
    best_.newton += found.iterations;
    note(found.history);
    keep_better(found.r);
  }

  const contact::PreparedProblem& island_;
  const contact::SolverSettings& settings_;
  const Budget& budget_;
  InteriorOnBodies interior_;
  BodySystem system_;
  const VecX& start_;
  bool has_lagged_ = false, has_differentiated_ = false;
  bool goes_on_ = false;  ///< the last run of the interior point reached its goal, and can go on from there
  BodyOutcome best_;
};

}  // namespace

bool fits_bodies(const contact::PreparedProblem& island) {
  const contact::ContactProblem& problem = island.problem();
  const bool is_cone = std::find(k_cone_laws.begin(), k_cone_laws.end(), problem.law) != k_cone_laws.end();
  const auto all_finite = [](const std::vector<double>& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  };
  const auto& scales = island.inverse_mass_scales();
  // the interior point takes no springs along the tangents
  const auto is_stiff = [](double compliance) { return compliance == 0; };
  const auto has_limit = [](double limit) { return !std::isnan(limit); };
  return problem.num_contacts() > 0 && is_cone && !problem.has_moments() && has_roots(island) &&
         problem.f.allFinite() && problem.w.allFinite() && all_finite(problem.jacobian_data) &&
         all_finite(problem.mu) && all_finite(problem.compliance) &&
         std::all_of(problem.tangential_compliance.begin(), problem.tangential_compliance.end(), is_stiff) &&
         std::all_of(problem.force_limit.begin(), problem.force_limit.end(), has_limit) &&
         std::all_of(scales.begin(), scales.end(), [](double d) { return d > 0; });
}

std::optional<BodyOutcome> solve_on_bodies(const contact::PreparedProblem& island, const VecX& guess,
                                           const contact::SolverSettings& settings, const Budget& budget) {
  if (!fits_bodies(island)) return {};
  const BodyIsland bodies(island);
  const auto plan = plan_nodes(bodies);
  if (!plan) return {};
  const VecX start = guess.size() > 0 ? guess : VecX(VecX::Zero(contact::row_of(bodies.num_contacts())));
  return BodyClimb(island, bodies, *plan, start, settings, budget).run();
}

}  // namespace nilas::solvers
