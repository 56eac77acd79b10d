#include "contact/solvers/lanes/nsgs_lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"

namespace nilas::solvers {

namespace {

/// Runs of one piece: four groups of lanes, whose visits the processor overlaps.
constexpr std::size_t k_runs_of_piece = 16;
/// Evaluations of four lanes in search of their slip. The few that need more are solved one by one.
constexpr int k_most_evaluations = 6;

/// True (-1) or false (0) in each lane.
using LaneMask = long long __attribute__((vector_size(32), aligned(32)));

NILAS_PART_OF_CLONES bool any(const LaneMask& mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }

NILAS_PART_OF_CLONES void root_lanes(const FourLanes& x, FourLanes& root) {
  for (int lane = 0; lane < k_lanes; ++lane) root[lane] = std::sqrt(x[lane]);
}

/// Friction as a function of x in each lane; see SlipLine and Slip in local_solve.cpp.
struct SlipLanes {
  FourLanes s1, s2, n0, g1, g2;
  FourLanes n, t1, t2, x, excess, slope, e1, e2;
};

NILAS_PART_OF_CLONES void evaluate(const NsgsLanes& c, const FourLanes& x, SlipLanes& slip) {
  const FourLanes pivot = 1 / (c.schur[0] + x);
  const FourLanes below = c.schur[1] * pivot;
  const FourLanes last = 1 / (c.schur[2] + x - below * c.schur[1]);
  slip.x = x;
  slip.t2 = -(slip.s2 - below * slip.s1) * last;
  slip.t1 = -(slip.s1 + c.schur[1] * slip.t2) * pivot;
  slip.n = slip.n0 - (slip.g1 * slip.t1 + slip.g2 * slip.t2);
  slip.e2 = (slip.t2 - below * slip.t1) * last;
  slip.e1 = (slip.t1 - c.schur[1] * slip.e2) * pivot;
  const FourLanes inverse_square = 1 / (slip.t1 * slip.t1 + slip.t2 * slip.t2);
  FourLanes root;
  root_lanes(inverse_square, root);
  const FourLanes share = c.mu * root;
  slip.excess = share * slip.n - 1;
  slip.slope = share * (slip.g1 * slip.e1 + slip.g2 * slip.e2 +
                        slip.n * (slip.t1 * slip.e1 + slip.t2 * slip.e2) * inverse_square);
}

/// What is known of the slip in each lane, as solve_slip of local_solve.cpp keeps it.
struct Bracket {
  FourLanes low, high;
  LaneMask stick_tried;
};

NILAS_PART_OF_CLONES void next_slip(const NsgsLanes& c, const SlipLanes& slip, const Bracket& bracket,
                                    FourLanes& next) {
  const FourLanes newton = slip.x - slip.excess / slip.slope;
  FourLanes root_of_low, root_of_high;
  root_lanes(bracket.low, root_of_low);
  root_lanes(bracket.high, root_of_high);
  const LaneMask is_wide = (bracket.low > 0.0) & (bracket.high > 4 * bracket.low);
  const FourLanes middle = is_wide ? root_of_low * root_of_high : 0.5 * (bracket.low + bracket.high);
  const LaneMask is_open = bracket.high == std::numeric_limits<double>::infinity();
  next = is_open ? 4 * slip.x : middle;
  next = ((newton <= c.x_min) & ~bracket.stick_tried) ? c.x_min : next;
  next = ((newton > bracket.low) & (newton < bracket.high)) ? newton : next;
}

/// The slipping impulse of the lanes in `sought`, with their slip in c.slip. `unknown`: the lanes that are not found.
NILAS_PART_OF_CLONES void slide(NsgsLanes& c, SlipLanes& slip, const LaneMask& sought, FourLanes (&r)[3],
                                LaneMask& unknown) {
  const FourLanes exact = FourLanes{} + contact::k_nearly_root, loose = FourLanes{} + contact::k_nearly_root_in_sweeps;
  const FourLanes nearly = c.slip > c.x_min ? loose : exact;
  Bracket bracket{c.x_min, FourLanes{} + std::numeric_limits<double>::infinity(), LaneMask{}};
  FourLanes x = c.slip < c.x_min ? c.x_min : c.slip;
  unknown = sought & (slip.s1 == 0.0) & (slip.s2 == 0.0);
  LaneMask left = sought & ~unknown;
  for (int k = 0; k < k_most_evaluations && any(left); ++k) {
    evaluate(c, x, slip);
    const LaneMask is_least = slip.x <= c.x_min;
    bracket.stick_tried |= is_least;
    const LaneMask sticks = left & is_least & (slip.excess >= 0.0);
    const FourLanes size = slip.excess < 0.0 ? -slip.excess : slip.excess;
    const LaneMask is_near = left & ~sticks & (size <= nearly) & (slip.slope * slip.x > size);
    const FourLanes step = -slip.excess / slip.slope;
    const FourLanes finished_n = slip.n + step * (slip.g1 * slip.e1 + slip.g2 * slip.e2);
    r[0] = is_near ? finished_n : (sticks ? slip.n : r[0]);
    r[1] = is_near ? slip.t1 - step * slip.e1 : (sticks ? slip.t1 : r[1]);
    r[2] = is_near ? slip.t2 - step * slip.e2 : (sticks ? slip.t2 : r[2]);
    c.slip = is_near ? slip.x + step : (sticks ? slip.x : c.slip);
    left &= ~(sticks | is_near);
    if (!any(left)) break;
    const LaneMask is_below = slip.excess < 0.0;
    bracket.low = is_below ? slip.x : bracket.low;
    bracket.high = is_below ? bracket.high : slip.x;
    FourLanes next;
    next_slip(c, slip, bracket, next);
    const FourLanes change = next < slip.x ? slip.x - next : next - slip.x;
    const LaneMask is_over =
        left & ((change <= contact::k_root_accuracy * slip.x) | ~(next < std::numeric_limits<double>::max()));
    unknown |= is_over;
    left &= ~is_over;
    x = next;
  }
  unknown |= left;
}

/// The answers of Coulomb's law to b in the lanes that are `active`; see contact::solve_coulomb.
NILAS_PART_OF_CLONES void solve_lanes(NsgsLanes& c, const FourLanes (&b)[3], const LaneMask& active,
                                      std::vector<NsgsContact>& blocks, int island_first, FourLanes (&r)[3]) {
  const LaneMask closes = active & (b[0] < 0.0), has_friction = c.mu != 0.0;
  SlipLanes slip;
  const FourLanes lift = -b[0] * c.inverse_nn;
  slip.n0 = lift;
  slip.s1 = b[1] + c.nt[0] * lift;
  slip.s2 = b[2] + c.nt[1] * lift;
  slip.g1 = c.nt[0] * c.inverse_nn;
  slip.g2 = c.nt[1] * c.inverse_nn;
  // without friction
  const LaneMask is_smooth = closes & ~has_friction;
  r[0] = is_smooth ? (c.force_limit < lift ? c.force_limit : lift) : FourLanes{};
  r[1] = FourLanes{};
  r[2] = FourLanes{};
  // sticking
  const FourLanes t2 = -(slip.s2 - c.stick[1] * slip.s1) * c.stick[2];
  const FourLanes t1 = -(slip.s1 + c.schur[1] * t2) * c.stick[0];
  const FourLanes n = lift - (slip.g1 * t1 + slip.g2 * t2);
  const LaneMask sticks = closes & has_friction & (c.slip <= c.x_min) & (n <= c.force_limit) & (n >= 0.0) &
                          (t1 * t1 + t2 * t2 <= c.mu * c.mu * n * n);
  r[0] = sticks ? n : r[0];
  r[1] = sticks ? t1 : r[1];
  r[2] = sticks ? t2 : r[2];
  const LaneMask slides = closes & has_friction & ~sticks;
  if (!any(slides)) return;
  const FourLanes old_slip = c.slip;
  LaneMask unknown;
  slide(c, slip, slides, r, unknown);
  unknown |= slides & (r[0] > c.force_limit);
  if (!any(unknown)) return;
  for (int lane = 0; lane < c.count; ++lane) {
    if (unknown[lane] == 0) continue;
    NsgsContact& own = blocks[static_cast<std::size_t>(c.place[lane] - island_first)];
    own.start.slip = old_slip[lane];
    const Vec3 answer =
        contact::solve_in_sweep(Law::coulomb, 0, own.block, Vec3(b[0][lane], b[1][lane], b[2][lane]), own.start);
    c.slip[lane] = own.start.slip;
    for (int i = 0; i < 3; ++i) r[i][lane] = answer[i];
  }
}

/// Visits four contacts as the visit of nsgs_sweep.cpp does one.
NILAS_PART_OF_CLONES void visit_lanes(NsgsLanes& c, std::vector<NsgsContact>& blocks, int island_first,
                                      double* velocities, double beta, FourLanes& largest) {
  for (int i = 0; i < 3; ++i) {
    const FourLanes now = c.r[i];
    if (beta > 0) c.r[i] = now + beta * (now - c.before[i]);
    c.before[i] = now;
  }
  FourLanes a[6], b[6], u[3];
  gather_lanes(velocities, c.first_a, a);
  gather_lanes(velocities, c.first_b, b);
  row_velocity(c.rows[0], a, b, u[0]);
  u[0] = u[0] + c.w[0] + c.compliance * c.r[0];
  const LaneMask active = ~((u[0] >= 0.0) & (c.r[0] == 0.0));
  if (!any(active)) return;
  for (int i = 1; i < 3; ++i) {
    row_velocity(c.rows[i], a, b, u[i]);
    u[i] = u[i] + c.w[i] + c.tangential_compliance * c.r[i];
  }
  const FourLanes free[3] = {u[0] - (c.nn * c.r[0] + c.nt[0] * c.r[1] + c.nt[1] * c.r[2]),
                             u[1] - (c.nt[0] * c.r[0] + c.tt[0] * c.r[1] + c.tt[1] * c.r[2]),
                             u[2] - (c.nt[1] * c.r[0] + c.tt[1] * c.r[1] + c.tt[2] * c.r[2])};
  FourLanes r[3];
  solve_lanes(c, free, active, blocks, island_first, r);
  FourLanes change[3];
  for (int i = 0; i < 3; ++i) change[i] = r[i] - c.r[i];
  const FourLanes square = change[0] * change[0] + change[1] * change[1] + change[2] * change[2];
  const LaneMask moves = active & (square != 0.0);
  if (!any(moves)) return;
  for (int i = 0; i < 3; ++i) c.r[i] = moves ? r[i] : c.r[i];
  for (int k = 0; k < 6; ++k) {
    const FourLanes moved_a = a[k] + (change[0] * c.rows[0][k] + change[1] * c.rows[1][k] + change[2] * c.rows[2][k]);
    const FourLanes moved_b =
        b[k] + (change[0] * c.rows[0][6 + k] + change[1] * c.rows[1][6 + k] + change[2] * c.rows[2][6 + k]);
    a[k] = moves ? moved_a : a[k];
    b[k] = moves ? moved_b : b[k];
  }
  const FourLanes told = c.d * c.d * square;
  largest = (moves & ~(told <= largest)) ? told : largest;
  scatter_lanes(a, c.first_a, c.count, velocities);
  scatter_lanes(b, c.first_b, c.count, velocities);
}

/// Lanes [first, last) in turn; the largest (d |dr|)^2.
NILAS_WIDE_CLONES double visit_all(NsgsLanes* first, NsgsLanes* last, bool backward, std::vector<NsgsContact>& blocks,
                                   int island_first, double* velocities, double beta) {
  FourLanes largest{};
  if (backward)
    while (last != first) visit_lanes(*--last, blocks, island_first, velocities, beta, largest);
  else
    for (; first != last; ++first) visit_lanes(*first, blocks, island_first, velocities, beta, largest);
  double found = 0;
  for (int lane = 0; lane < k_lanes; ++lane)
    if (!(largest[lane] <= found)) found = largest[lane];
  return found;
}

void put(const PgsRows& rows, const NsgsContact& own, int place, int lane, NsgsLanes& lanes) {
  const PgsContact& contact = rows.contacts[place];
  const contact::ContactBlock& block = own.block;
  const double* row = rows.coefficients.data() + contact.rows;
  for (auto& of_row : lanes.rows)
    for (FourLanes& numbers : of_row) numbers[lane] = *row++;
  for (int i = 0; i < 3; ++i) {
    lanes.r[i][lane] = contact.r[i];
    lanes.w[i][lane] = contact.w[i];
    lanes.stick[i][lane] = block.stick[i];
  }
  for (int i = 0; i < 2; ++i) lanes.nt[i][lane] = block.nt[i];
  for (int i = 0; i < 3; ++i) {
    constexpr int k_places[] = {0, 1, 3};
    lanes.tt[i][lane] = block.tt[k_places[i]];
    lanes.schur[i][lane] = block.schur[k_places[i]];
  }
  lanes.compliance[lane] = contact.compliance;
  lanes.tangential_compliance[lane] = contact.tangential_compliance;
  lanes.nn[lane] = block.nn;
  lanes.inverse_nn[lane] = block.inverse_nn;
  lanes.x_min[lane] = block.x_min;
  lanes.mu[lane] = block.mu;
  lanes.force_limit[lane] = block.force_limit;
  lanes.slip[lane] = own.start.slip;
  lanes.d[lane] = own.d;
  lanes.first_a[lane] = contact.first_a;
  lanes.first_b[lane] = contact.first_b;
  lanes.place[lane] = place;
}

}  // namespace

NsgsTurns::NsgsTurns(const PgsRows& rows, const PgsIsland& island, const std::vector<NsgsContact>& blocks) {
  if (rows.law != Law::coulomb || island.colours.empty()) return;
  colours_.push_back(0);
  // lanes of four, and some more with fewer
  lanes_.reserve(static_cast<std::size_t>(island.last - island.first) / 3);
  for (std::size_t colour = 0; colour + 1 < island.colours.size(); ++colour) {
    std::vector<Run> runs;
    for (int k = island.colours[colour]; k < island.colours[colour + 1]; ++k)
      runs.push_back({island.runs[k], island.runs[k + 1]});
    // runs of about the same length fill the lanes
    std::stable_sort(runs.begin(), runs.end(),
                     [](const Run& a, const Run& b) { return a.last - a.first > b.last - b.first; });
    for (std::size_t first = 0; first < runs.size(); first += k_runs_of_piece) {
      const std::size_t last = std::min(first + k_runs_of_piece, runs.size());
      add_piece(rows, island, blocks,
                {runs.begin() + static_cast<std::ptrdiff_t>(first), runs.begin() + static_cast<std::ptrdiff_t>(last)});
    }
    colours_.push_back(pieces_.size() - 1);
  }
}

void NsgsTurns::add_piece(const PgsRows& rows, const PgsIsland& island, const std::vector<NsgsContact>& blocks,
                          const std::vector<Run>& runs) {
  const auto own = [&](int place) -> const NsgsContact& {
    return blocks[static_cast<std::size_t>(place - island.first)];
  };
  const auto fits = [&](const Run& run) {
    for (int place = run.first; place < run.last; ++place) {
      const PgsContact& contact = rows.contacts[place];
      if (!fits_lanes(contact) || contact.moment >= 0 || contact.bound_by >= 0 || !(own(place).block.inverse_nn > 0))
        return false;
    }
    return true;
  };
  std::vector<Run> together;
  for (const Run& run : runs) (fits(run) ? together : alone_).push_back(run);
  const auto length = [](const Run& run) { return run.last - run.first; };
  const int longest = together.empty() ? 0 : length(together.front());
  for (int turn = 0; turn < longest; ++turn)
    for (std::size_t first = 0; first < together.size() && length(together[first]) > turn; first += k_lanes) {
      NsgsLanes& lanes = lanes_.emplace_back();
      for (std::size_t k = first; k < std::min(first + k_lanes, together.size()); ++k)
        if (length(together[k]) > turn) {
          const int place = together[k].first + turn;
          put(rows, own(place), place, lanes.count++, lanes);
        }
      for (int free = lanes.count; free < k_lanes; ++free) {
        lanes.first_a[free] = lanes.first_a[0];
        lanes.first_b[free] = lanes.first_b[0];
      }
    }
  pieces_.push_back({lanes_.size(), alone_.size()});
}

double NsgsTurns::visit_piece(PgsRows& rows, const PgsIsland& island, std::vector<NsgsContact>& blocks,
                              std::size_t piece, bool backward) {
  const Piece &begin = pieces_[piece], &end = pieces_[piece + 1];
  double largest = visit_all(lanes_.data() + begin.lanes, lanes_.data() + end.lanes, backward, blocks, island.first,
                             rows.velocities.data(), beta_);
  for (std::size_t k = begin.runs; k < end.runs; ++k) {
    const double change = visit_coulomb_run(rows, island, blocks, alone_[k].first, alone_[k].last, backward);
    if (!(change <= largest)) largest = change;
  }
  return largest;
}

double NsgsTurns::visit_colour(PgsRows& rows, const PgsIsland& island, std::vector<NsgsContact>& blocks,
                               std::size_t colour, bool backward, int threads) {
  const std::size_t first = colours_[colour], count = colours_[colour + 1] - first;
  std::vector<double> changes(count, 0.0);
  parallel_pieces(static_cast<std::ptrdiff_t>(count), threads, [&](std::ptrdiff_t k) {
    changes[k] = visit_piece(rows, island, blocks, first + static_cast<std::size_t>(k), backward);
  });
  double largest = 0;
  for (const double change : changes)
    if (!(change <= largest)) largest = change;
  return largest;
}

double NsgsTurns::sweep(PgsRows& rows, const PgsIsland& island, std::vector<NsgsContact>& blocks, bool backward,
                        int threads) {
  double largest = 0;
  const auto keep = [&](double change) {
    if (!(change <= largest)) largest = change;
  };
  const auto in_turn = [&] {
    keep(visit_coulomb_run(rows, island, blocks, island.runs.back(), island.last, backward));
  };
  const std::size_t colours = colours_.size() - 1;
  if (backward) in_turn();
  for (std::size_t k = 0; k < colours; ++k)
    keep(visit_colour(rows, island, blocks, backward ? colours - 1 - k : k, backward, threads));
  if (!backward) in_turn();
  return std::sqrt(largest);
}

void NsgsTurns::keep_impulses(PgsRows& rows) const {
  for (const NsgsLanes& lanes : lanes_)
    for (int lane = 0; lane < lanes.count; ++lane)
      for (int i = 0; i < 3; ++i) rows.contacts[lanes.place[lane]].r[i] = lanes.r[i][lane];
}

std::vector<int> NsgsTurns::alone(const PgsIsland& island) const {
  std::vector<char> is_in_lanes(static_cast<std::size_t>(island.last - island.first), 0);
  for (const NsgsLanes& lanes : lanes_)
    for (int lane = 0; lane < lanes.count; ++lane)
      is_in_lanes[static_cast<std::size_t>(lanes.place[lane] - island.first)] = 1;
  std::vector<int> places;
  for (int place = island.first; place < island.last; ++place)
    if (is_in_lanes[static_cast<std::size_t>(place - island.first)] == 0) places.push_back(place);
  return places;
}

}  // namespace nilas::solvers
