/// The rounds of a held shift.
#include <algorithm>
#include <limits>

#include "contact/law/cone.h"
#include "contact/solvers/bodies/interior_on_bodies.h"

namespace nilas::solvers {

namespace {

/// A round of a held shift ends at this share of the residual that it began with, or of the tolerance: what is left of
/// its convex law hardly changes the next shift.
constexpr double k_share_of_round = 0.15, k_share_of_tolerance = 0.2;
/// Rounds without the residual halving that end the run.
constexpr int k_rounds_in_vain = 4;

}  // namespace

/// Holds the shifts that impulses give, or half way to them where a shift turned back. Returns the residual of the
/// impulses.
double InteriorOnBodies::hold(const VecX& r) {
  place(r);
  std::vector<double> held;
  held.swap(held_);  // the residual is that of the law itself
  const double map = find_map();
  held_.swap(held);
  for (std::size_t c = 0; c < count_; ++c) {
    const double change = friction_[c] * contact::tangential_norm(other_.at(c)) - held_[c];
    held_[c] += change * change_[c] < 0 ? 0.5 * change : change;
    change_[c] = change;
  }
  return map;
}

/// Rounds of a held shift, each from the impulses and with the shift of the one before.
InteriorOnBodies::Outcome InteriorOnBodies::go_round(double tolerance, const Budget& budget) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Outcome best{last_, infinity, 0, {}};
  double marked = infinity;
  for (int in_vain = 0; in_vain < k_rounds_in_vain; ++in_vain) {
    const double goal = std::max(k_share_of_round * begin(last_), k_share_of_tolerance * tolerance);
    const Outcome round = iterate(goal, budget.after(best.iterations));
    last_ = round.r;
    const double map = hold(last_);
    best.iterations += round.iterations;
    best.history.insert(best.history.end(), static_cast<std::size_t>(round.iterations), map);
    if (map < best.law_map_m_s) {
      best.law_map_m_s = map;
      best.r = last_;
    }
    if (best.law_map_m_s < 0.5 * marked) {
      marked = best.law_map_m_s;
      in_vain = -1;
    }
    if (!(map > tolerance) || !budget.allows(best.iterations)) break;
  }
  return best;
}

}  // namespace nilas::solvers
