#include "contact/solvers/lanes/pgs_lanes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nilas::solvers {

namespace {

/// Fewest contacts of an island for which setting up lanes pays.
constexpr int k_fewest_in_lanes = 200;
/// Turns from one contact of a block to its next. With 2, the processor works on two turns at once.
constexpr int k_turns_apart = 2;

NILAS_PART_OF_CLONES void clamp_lanes(const FourLanes& low, const FourLanes& high, FourLanes& x) {
  x = x < low ? low : x;
  x = high < x ? high : x;
}

NILAS_PART_OF_CLONES void keep_largest(const FourLanes& step, const FourLanes& diagonal, FourLanes& largest) {
  const FourLanes change = (step < 0.0 ? -step : step) * diagonal;
  largest = largest < change ? change : largest;
}

/// The tangential impulses that the law allows with u1 and u2; T2 sees T1's change on a pyramid.
template <Law law>
NILAS_PART_OF_CLONES void step_tangents(const PgsLanes& c, const FourLanes& u1, const FourLanes& u2, FourLanes& r1,
                                        FourLanes& r2) {
  const FourLanes bound = c.mu * c.r[0];
  r1 = c.r[1] - u1 * c.weight[1];
  if constexpr (law == Law::pyramid) {
    clamp_lanes(-bound, bound, r1);
    const FourLanes d1 = r1 - c.r[1];
    r2 = c.r[2] - (u2 + c.coupling[2] * d1) * c.weight[2];
    clamp_lanes(-bound, bound, r2);
  } else {
    r2 = c.r[2] - u2 * c.weight[2];
    const FourLanes square = r1 * r1 + r2 * r2;
    for (int lane = 0; lane < k_lanes; ++lane) {
      if (!(square[lane] > bound[lane] * bound[lane])) continue;
      const double share = bound[lane] / std::sqrt(square[lane]);
      r1[lane] *= share;
      r2[lane] *= share;
    }
  }
}

/// Four contacts at once, each as the visit of pgs_sweep.cpp does it. A lane that stays open keeps its zeros.
template <Law law, bool track>
NILAS_PART_OF_CLONES void visit_lanes(PgsLanes& c, double* velocities, FourLanes& largest) {
  FourLanes a[6], b[6], u;
  gather_lanes(velocities, c.first_a, a);
  gather_lanes(velocities, c.first_b, b);
  row_velocity(c.rows[0], a, b, u);
  u = u + c.w[0] + c.compliance * c.r[0];
  FourLanes r = c.r[0] - u * c.weight[0];
  clamp_lanes(FourLanes{}, c.force_limit, r);
  const FourLanes dn = r - c.r[0];
  c.r[0] = r;
  if constexpr (track) keep_largest(dn, c.diagonal[0], largest);
  const auto closed = (r != 0.0) | (c.r[1] != 0.0) | (c.r[2] != 0.0);
  if ((closed[0] | closed[1] | closed[2] | closed[3]) == 0) {
    const auto moves = dn != 0.0;
    if ((moves[0] | moves[1] | moves[2] | moves[3]) == 0) return;
    for (int k = 0; k < 6; ++k) {
      a[k] += dn * c.rows[0][k];
      b[k] += dn * c.rows[0][6 + k];
    }
  } else {
    FourLanes u1, u2, r1, r2;
    row_velocity(c.rows[1], a, b, u1);
    row_velocity(c.rows[2], a, b, u2);
    u1 = u1 + c.w[1] + c.coupling[0] * dn + c.tangential_compliance * c.r[1];
    u2 = u2 + c.w[2] + c.coupling[1] * dn + c.tangential_compliance * c.r[2];
    step_tangents<law>(c, u1, u2, r1, r2);
    r1 = closed ? r1 : c.r[1];
    r2 = closed ? r2 : c.r[2];
    const FourLanes d1 = r1 - c.r[1], d2 = r2 - c.r[2];
    c.r[1] = r1;
    c.r[2] = r2;
    if constexpr (track) {
      keep_largest(d1, c.diagonal[1], largest);
      keep_largest(d2, c.diagonal[2], largest);
    }
    for (int k = 0; k < 6; ++k) {
      a[k] += dn * c.rows[0][k] + d1 * c.rows[1][k] + d2 * c.rows[2][k];
      b[k] += dn * c.rows[0][6 + k] + d1 * c.rows[1][6 + k] + d2 * c.rows[2][6 + k];
    }
  }
  scatter_lanes(a, c.first_a, c.count, velocities);
  scatter_lanes(b, c.first_b, c.count, velocities);
}

}  // namespace

struct TurnSweep {
  template <Law law, bool track>
  NILAS_PART_OF_CLONES static double run(PgsTurns& turns, PgsRows& rows, bool backward) {
    double* const velocities = rows.velocities.data();
    FourLanes largest{};
    double largest_alone = 0;
    const std::size_t count = turns.lanes_.size();
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t turn = backward ? count - 1 - k : k;
      PgsLanes& lanes = turns.lanes_[turn];
      if (lanes.count > 0) visit_lanes<law, track>(lanes, velocities, largest);
      for (int i = turn == 0 ? 0 : turns.ends_[turn - 1]; i < turns.ends_[turn]; ++i) {
        PgsContact& contact = rows.contacts[turns.alone_[i]];
        const double change = turns.visit_alone_(contact, rows.coefficients.data(), velocities);
        if (track) largest_alone = std::max(largest_alone, change);
      }
    }
    for (int lane = 0; lane < k_lanes; ++lane) largest_alone = std::max(largest_alone, largest[lane]);
    return largest_alone;
  }
};

namespace {

NILAS_WIDE_CLONES double sweep_pyramids(PgsTurns& turns, PgsRows& rows, bool backward) {
  return TurnSweep::run<Law::pyramid, false>(turns, rows, backward);
}
NILAS_WIDE_CLONES double track_pyramids(PgsTurns& turns, PgsRows& rows, bool backward) {
  return TurnSweep::run<Law::pyramid, true>(turns, rows, backward);
}
NILAS_WIDE_CLONES double sweep_cones(PgsTurns& turns, PgsRows& rows, bool backward) {
  return TurnSweep::run<Law::coulomb, false>(turns, rows, backward);
}
NILAS_WIDE_CLONES double track_cones(PgsTurns& turns, PgsRows& rows, bool backward) {
  return TurnSweep::run<Law::coulomb, true>(turns, rows, backward);
}

/// The first turns that have room in their lanes.
class RoomyTurns {
 public:
  /// Takes a lane of the first turn from `turn` on that has one.
  int take(int turn) {
    turn = find(turn);
    if (++taken_[turn] == k_lanes) next_[turn] = turn + 1;
    return turn;
  }

 private:
  /// Follows the turns to the first with room, and shortens the way to it.
  int find(int turn) {
    for (;;) {
      while (turn >= static_cast<int>(next_.size())) {
        next_.push_back(static_cast<int>(next_.size()));
        taken_.push_back(0);
      }
      const int after = next_[turn];
      if (after == turn) return turn;
      if (after < static_cast<int>(next_.size())) next_[turn] = next_[after];
      turn = after;
    }
  }

  std::vector<int> next_, taken_;
};

}  // namespace

PgsTurns::PgsTurns(const PgsRows& rows, const PgsIsland& island, bool track) {
  const int count = island.last - island.first;
  if (count < k_fewest_in_lanes || (rows.law != Law::pyramid && rows.law != Law::coulomb)) return;
  if (rows.law == Law::pyramid)
    sweep_ = track ? track_pyramids : sweep_pyramids;
  else
    sweep_ = track ? track_cones : sweep_cones;
  visit_alone_ = pgs_visit(rows.law, track);

  std::vector<int> free_from(static_cast<std::size_t>(rows.velocities.size()), 0);  // by the block's first velocity
  std::vector<int> turn_of(static_cast<std::size_t>(count));
  RoomyTurns roomy;
  int turns = 0;
  for (int k = 0; k < count; ++k) {
    const PgsContact& contact = rows.contacts[static_cast<std::size_t>(island.first) + static_cast<std::size_t>(k)];
    int turn = 0;
    if (contact.size_a > 0) turn = std::max(turn, free_from[contact.first_a]);
    if (contact.size_b > 0) turn = std::max(turn, free_from[contact.first_b]);
    if (fits_lanes(contact)) turn = roomy.take(turn);
    if (contact.size_a > 0) free_from[contact.first_a] = turn + k_turns_apart;
    if (contact.size_b > 0) free_from[contact.first_b] = turn + k_turns_apart;
    turn_of[k] = turn;
    turns = std::max(turns, turn + 1);
  }
  lanes_.resize(static_cast<std::size_t>(turns));
  std::vector<std::pair<int, int>> alone;  // turn and place
  for (int k = 0; k < count; ++k) {
    if (fits_lanes(rows.contacts[island.first + k]))
      add(rows, island.first + k, turn_of[k]);
    else
      alone.emplace_back(turn_of[k], island.first + k);
  }
  std::sort(alone.begin(), alone.end());
  ends_.assign(lanes_.size(), 0);
  for (const auto& [turn, place] : alone) {
    alone_.push_back(place);
    ++ends_[turn];
  }
  for (std::size_t turn = 1; turn < ends_.size(); ++turn) ends_[turn] += ends_[turn - 1];
}

void PgsTurns::add(const PgsRows& rows, int place, int turn) {
  PgsLanes& lanes = lanes_[turn];
  const PgsContact& contact = rows.contacts[place];
  const int lane = lanes.count++;
  const double* row = rows.coefficients.data() + contact.rows;
  for (auto& of_row : lanes.rows)
    for (FourLanes& numbers : of_row) numbers[lane] = *row++;
  for (int i = 0; i < 3; ++i) {
    lanes.r[i][lane] = contact.r[i];
    lanes.w[i][lane] = contact.w[i];
    lanes.weight[i][lane] = contact.weight[i];
    lanes.coupling[i][lane] = contact.coupling[i];
    lanes.diagonal[i][lane] = contact.diagonal[i];
  }
  lanes.mu[lane] = contact.mu;
  lanes.force_limit[lane] = contact.force_limit;
  lanes.compliance[lane] = contact.compliance;
  lanes.tangential_compliance[lane] = contact.tangential_compliance;
  lanes.place[lane] = place;
  for (int free = lane; free < k_lanes; ++free) {  // lanes without a contact read the last one's velocities
    lanes.first_a[free] = contact.first_a;
    lanes.first_b[free] = contact.first_b;
  }
}

void PgsTurns::keep_impulses(PgsRows& rows) const {
  for (const PgsLanes& lanes : lanes_)
    for (int lane = 0; lane < lanes.count; ++lane)
      for (int i = 0; i < 3; ++i) rows.contacts[lanes.place[lane]].r[i] = lanes.r[i][lane];
}

}  // namespace nilas::solvers
