#include "contact/solvers/body_ladder.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "contact/measure/measure.h"
#include "contact/problem/reducible.h"
#include "contact/problem/row_of.h"
#include "contact/solvers/bodies/body_system.h"
#include "contact/solvers/bodies/interior_on_bodies.h"
#include "contact/solvers/closing_contacts.h"
#include "contact/solvers/newton.h"
#include "contact/solvers/nsgs.h"

namespace nilas::solvers {

namespace {

/// Newton's least proximal weight that its systems on bodies bear [-].
constexpr double k_least_weight_on_bodies = 1e-9;

/// Residuals at which the interior point hands over to Newton [m/s], and Newton's most factorisations. For tight
/// tolerances: below 1e-5 m/s rounding often costs the interior point more iterations than Newton needs, above it
/// Newton has a longer search for the contacts that carry something. Where that search is long even so, the second
/// handover brings Newton nearer.
struct Handover {
  double residual;
  int factorisations;
};
constexpr Handover k_handovers[] = {{1e-5, 100}, {1e-6, 120}};
/// The same to a tolerance of at most k_strict from a start whose residual is at most k_near_start, as where a solved
/// step is solved again [m/s]. From such a start the interior point takes a third fewer iterations, and Newton takes 6
/// factorisations from 1e-6 m/s where it takes 23 from 1e-5 m/s.
constexpr Handover k_near_handovers[] = {{1e-6, 100}, {1e-7, 120}};
constexpr double k_strict = 1e-7, k_near_start = 1e-3;

/// Tolerances from which on the interior point with a lagged shift reaches them itself in large islands [m/s]: from
/// 1e-5 m/s on it has some five iterations to go, where Newton's search takes 5 to 30 factorisations. With the slope of
/// the shift it has ten, and in small islands rounding often ends it before.
constexpr double k_least_of_interior = 5e-7;

/// With more friction than this on any contact a lagged shift converges slowly or not at all [-]. To a loose tolerance
/// [m/s] it is worth a trial from a start all the same, since its steps cost half. To a strict one the trial costs more
/// than it saves.
constexpr double k_most_lagged_friction = 0.2;
constexpr double k_loose = 1e-5;
constexpr InteriorSettings k_lagged{.inside = 1};
constexpr InteriorSettings k_first_lagged{.slope_share = 0.6, .patience = 20, .lagged_patience = 3};
/// The first way without a start, or where a quarter of the contacts or more has a force limit. There a lagged shift
/// mostly leaves steps too short, and an iterate near the ends of its cones. From far inside half of the iterations
/// suffice. From the impulses of a step before in a jam without limits, the lagged trial costs less.
constexpr InteriorSettings k_first_inside{Shift::differentiated, 0.9, 10, 20};
constexpr double k_limited_share = 0.25;
/// The way after it. From impulses that are off it takes up to ten iterations less than from none.
constexpr InteriorSettings k_from_start{Shift::differentiated, 0.7, 10, 20};

/// To a loose tolerance sweeps with momentum finish what the interior point began: it has built up the pressure of the
/// jam, and what is left is off at single contacts. They are tried where it reached these multiples of the tolerance in
/// turn, and where it ended within k_swept_from times the tolerance. k_most_sweeps cost about three iterations; they
/// end sooner where they do not promise to suffice. Begun farther off, they would reach the tolerance with the pressure
/// off.
constexpr double k_sweep_goals[] = {4, 2, 1};
constexpr double k_swept_from = 10;
constexpr int k_most_sweeps = 40;
/// Newton's factorisations after a way that these sweeps do not finish. Where it finds the solution from there, it
/// seldom needs more, and then the next ways would take hundreds of iterations.
constexpr int k_short_newton = 20;
/// A way that ends within k_turns_from times a loose tolerance is off at few contacts. There Newton and sweeps take
/// turns, since sweeps move the contacts at which Newton is stuck. To any tolerance they do so last of all.
constexpr double k_turns_from = 30;
constexpr int k_rounds = 10, k_sweeps_of_round = 50;

/// Newton seldom finds the solution from a larger share of the residual of no impulses than this [-].
constexpr double k_near = 0.1;

/// Ways to the solution with the slope of the shift, each tried where those before failed. Above 1 - 1/g, with g > 1 an
/// eigenvalue of the map from shift to shift, the whole slope would point a step away from the solution, and such g
/// occur in jams. Loads of a jam that is about to lock are many times those of the step before. They are found from
/// farther inside the cones, since steps are longer there. No share of the slope is best for all of them.
constexpr InteriorSettings k_with_slope[] = {{Shift::differentiated, 0.7, 1, 20},
                                             {Shift::differentiated, 0.5, 100, 20},
                                             {Shift::differentiated, 0.3, 20, 20},
                                             {Shift::differentiated, 0.85, 100, 20}};

/// The way after those. With mass ratios and force limits over many decades the slope may leave steps too short,
/// whatever its share. A held shift takes two to four times the iterations of a share that leads there.
constexpr InteriorSettings k_held{Shift::held, 0, 1, 12};

/// A way from the start, or from no impulses. Where the shift is not lagged, a start that is off seldom saves anything.
struct Way {
  InteriorSettings settings;
  bool has_start = false;
  std::span<const Handover> handovers = k_handovers;
};

bool is_limited(const contact::ContactProblem& problem) {
  const auto limited = std::count_if(problem.force_limit.begin(), problem.force_limit.end(),
                                     [](double limit) { return std::isfinite(limit); });
  return static_cast<double>(limited) >= k_limited_share * problem.num_contacts();
}

/// `near`: the residual of the start [m/s], infinite without one.
std::vector<Way> ways_for(const contact::ContactProblem& problem, double tolerance, double near) {
  const bool is_convex = problem.law != Law::coulomb;
  const auto is_slight = [](double mu) { return mu <= k_most_lagged_friction; };
  std::vector<Way> ways;
  if (is_convex || std::all_of(problem.mu.begin(), problem.mu.end(), is_slight))
    ways.push_back({k_lagged, true});
  else if (tolerance >= k_loose)
    ways = {{is_limited(problem) || std::isinf(near) ? k_first_inside : k_first_lagged, true}, {k_from_start, true}};
  else if (tolerance <= k_strict && near <= k_near_start)
    ways.push_back({k_from_start, true, k_near_handovers});
  if (is_convex) return ways;
  for (const InteriorSettings& way : k_with_slope) ways.push_back({way});
  ways.push_back({k_held});
  return ways;
}

/// One solve of the ladder.
class BodyClimb {
 public:
  BodyClimb(const contact::PreparedProblem& island, const BodyIsland& bodies, const NodePlan& plan, const VecX& start,
            const contact::SolverSettings& settings, const Budget& budget)
      : island_(island),
        bodies_(bodies),
        plan_(plan),
        settings_(settings),
        budget_(budget),
        interior_(island, bodies, plan),
        start_(start) {
    best_.r = start_;
    best_.law_map_m_s = contact::largest_law_map(island, start_, bodies.threads());
    if (!std::isfinite(best_.law_map_m_s)) best_.law_map_m_s = std::numeric_limits<double>::infinity();
    if (!start_.isZero(0)) near_ = best_.law_map_m_s;
    still_ = keep_better(VecX::Zero(start_.size()));
  }

  BodyOutcome run() {
    const std::vector<Way> ways = ways_for(island_.problem(), settings_.tolerance, near_);
    for (std::size_t k = 0; k < ways.size(); ++k) {
      const bool is_last = k + 1 == ways.size() || ways[k + 1].settings.shift == Shift::held;
      approach(ways[k].has_start ? start_ : VecX(VecX::Zero(start_.size())), ways[k], is_last);
    }
    take_turns(best_.r);
    best_.has_converged = best_.law_map_m_s <= settings_.tolerance;
    return std::move(best_);
  }

 private:
  bool is_done() const {
    return best_.law_map_m_s <= settings_.tolerance || !budget_.allows(best_.interior + best_.sweeps + best_.newton);
  }
  Budget left() const { return budget_.after(best_.interior + best_.sweeps + best_.newton); }

  /// Returns the residual [m/s].
  double keep_better(const VecX& r) {
    const double map = contact::largest_law_map(island_, r, bodies_.threads());
    if (map < best_.law_map_m_s) {
      best_.law_map_m_s = map;
      best_.r = r;
    }
    return map;
  }
  void note(const std::vector<double>& history) {
    if (settings_.keep_history) best_.history.insert(best_.history.end(), history.begin(), history.end());
  }

  /// The interior point from a start, and Newton from where it ends; the second time from nearer, where the interior
  /// point got as far as it was asked to. Newton is left out where the interior point ended far from the solution and
  /// another way of its kind is left, and the interior point where the impulses are near already and nothing failed
  /// from there.
  void approach(const VecX& start, const Way& way, bool is_last) {
    if (settings_.tolerance >= k_loose) return approach_loosely(start, way.settings, is_last);
    bool is_begun = false, arrives = true;
    const bool goes_all_the_way = way.settings.shift == Shift::lagged && settings_.tolerance >= k_least_of_interior &&
                                  island_.problem().num_contacts() >= k_large_on_bodies;
    for (const Handover& handover : way.handovers) {
      if (is_done() || !arrives) break;
      const double goal = goes_all_the_way ? settings_.tolerance : std::max(settings_.tolerance, handover.residual);
      VecX near = best_.r;
      if (has_failed_ || best_.law_map_m_s > goal) {
        auto found = is_begun ? interior_.go_on(goal, left()) : interior_.run(start, goal, left(), way.settings);
        is_begun = true;
        arrives = found.law_map_m_s <= goal;
        best_.interior += found.iterations;
        note(found.history);
        keep_better(found.r);
        if (!is_last && !(found.law_map_m_s < k_near * still_)) break;
        near = std::move(found.r);
      }
      if (!is_done()) finish(near, handover.factorisations);
    }
    has_failed_ = true;
  }

  /// The same for a loose tolerance, with sweeps before Newton and after it, which has few factorisations unless the
  /// way is the last of its kind.
  void approach_loosely(const VecX& start, const InteriorSettings& way, bool is_last) {
    const double tolerance = settings_.tolerance;
    InteriorSettings settings = way;
    settings.ends_when_stuck = true;
    VecX near = best_.r;
    double reached = best_.law_map_m_s;
    bool is_begun = false;
    for (const double share : k_sweep_goals) {
      if (is_done()) return;
      auto found = is_begun ? interior_.go_on(share * tolerance, left())
                            : interior_.run(start, share * tolerance, left(), settings);
      is_begun = true;
      best_.interior += found.iterations;
      note(found.history);
      reached = keep_better(found.r);
      near = std::move(found.r);
      if (!is_done() && reached <= k_swept_from * tolerance) sweep(near, k_most_sweeps);
      if (!(reached <= share * tolerance)) break;
    }
    if (reached <= k_turns_from * tolerance)
      take_turns(near);
    else if (!is_done() && reached < k_near * still_)
      finish(near, is_last ? k_handovers[0].factorisations : k_short_newton);
    has_failed_ = true;
  }

  void take_turns(const VecX& near) {
    VecX r = near;
    for (int round = 0; round < k_rounds; ++round) {
      if (!is_done()) r = finish(r, k_short_newton);
      if (!is_done()) r = sweep(r, k_sweeps_of_round);
    }
  }

  /// Sweeps with momentum, as long as they promise to suffice. Returns the impulses.
  VecX sweep(const VecX& near, int most) {
    const NsgsSettings settings{.shared = settings_, .has_momentum = true, .horizon = most};
    auto found = NsgsSolver(settings).solve(island_, near, left().capped(most));
    best_.sweeps += found.iterations;
    note(found.history);
    keep_better(found.r);
    return std::move(found.r);
  }

  /// Newton. Returns the impulses.
  VecX finish(const VecX& near, int factorisations) {
    if (!system_) system_.emplace(island_, bodies_, plan_);
    NewtonSettings settings{.shared = settings_};
    settings.least_weight = k_least_weight_on_bodies;
    settings.max_factorisations = factorisations;
    auto found = newton_on(*system_, near, settings, left());
    best_.newton += found.iterations;
    note(found.history);
    keep_better(found.r);
    return std::move(found.r);
  }

  const contact::PreparedProblem& island_;
  const BodyIsland& bodies_;
  const NodePlan& plan_;
  const contact::SolverSettings& settings_;
  const Budget& budget_;
  InteriorOnBodies interior_;
  std::optional<BodySystem> system_;  ///< made when first needed
  const VecX& start_;
  double near_ = std::numeric_limits<double>::infinity();  ///< residual of a start with impulses [m/s]
  double still_ = 0;                                       ///< residual of no impulses [m/s]
  bool has_failed_ = false;                                ///< a way was tried before
  BodyOutcome best_;
};

/// Products of blocks from which on it is asked whether W is factorised in less time.
constexpr double k_many_products = 5e5;

/// Whether W can be formed and one of its factorisations takes less time than one of the bodies. In W contacts that
/// stay open are left out. It has k rows of 3 x 3 blocks, one for each contact that closes, where a body has one of 6
/// x 6. So it takes k^3 times as many products as the bodies that these contacts join, each of an eighth of the work.
bool is_quicker_on_w(const contact::PreparedProblem& island, const BodyIsland& bodies, const NodePlan& plan,
                     const VecX& r) {
  std::vector<int> all(static_cast<std::size_t>(bodies.num_contacts()));
  std::iota(all.begin(), all.end(), 0);
  if (!contact::is_reducible(island.problem(), all)) return false;
  const std::vector<char> closes = closing_contacts(island, r);
  std::vector<char> is_joined(static_cast<std::size_t>(bodies.num_nodes()));
  for (int c = 0; c < bodies.num_contacts(); ++c)
    for (int s = bodies.first_side(c); closes[c] != 0 && s < bodies.first_side(c + 1); ++s)
      is_joined[bodies.node(s)] = 1;
  const auto contacts = static_cast<double>(std::count(closes.begin(), closes.end(), 1));
  const auto nodes = static_cast<double>(std::count(is_joined.begin(), is_joined.end(), 1));
  return num_products(bodies, closes) * std::pow(contacts / std::max(nodes, 1.0), 3) < 8 * plan.products;
}

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
  const BodyIsland bodies(island, island.problem().num_contacts() < k_large_on_bodies ? 1 : settings.threads);
  const auto plan = plan_nodes(bodies);
  if (!plan) return {};
  const VecX start = guess.size() > 0 ? guess : VecX(VecX::Zero(contact::row_of(bodies.num_contacts())));
  if (plan->products > k_many_products && is_quicker_on_w(island, bodies, *plan, start)) return {};
  return BodyClimb(island, bodies, *plan, start, settings, budget).run();
}

}  // namespace nilas::solvers
