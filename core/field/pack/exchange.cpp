#include "core/field/pack/exchange.h"

#include <cmath>

#include "core/field/pack/overlaps.h"
#include "core/field/pack/place_floes.h"

namespace nilas::field {

namespace {

constexpr double k_swap_share = 0.7;  ///< share of trials that swap two floes; the others move one
constexpr double k_swap_rank = 0.2;   ///< largest distance of partners in the order of sizes, as a share of all floes
constexpr double k_keep_angle_share = 0.5;  ///< share of swaps that also exchange the angle; the others draw new ones
constexpr double k_far_share = 0.5;         ///< share of moves to any place; the others stay near
constexpr double k_near_move = 0.2;         ///< standard deviation of a near move, in floe sizes
constexpr double k_near_turn = 0.5;         ///< standard deviation of a near move's turn [rad]

double squared_depth(double depth) { return depth > 0 ? depth * depth : 0; }

double largest_radius(const std::vector<LooseFloe>& floes) {
  double radius = 0;
  for (const LooseFloe& floe : floes) radius = std::max(radius, floe.radius);
  return radius;
}

}  // namespace

Exchange::Exchange(std::vector<LooseFloe>& floes, const FieldBounds& bounds, double gap, RandomStream& random)
    : floes_(floes),
      bounds_(bounds),
      gap_(gap),
      random_(random),
      largest_radius_(largest_radius(floes)),
      grid_(bounds.low, bounds.high, 2 * largest_radius_),
      outlines_(floes.size()) {}

void Exchange::run(int trials) {
  read_positions();
  const double count = static_cast<double>(floes_.size());
  for (int k = 0; k < trials; ++k) {
    const int i = static_cast<int>(random_.uniform() * count);
    if (random_.uniform() < k_swap_share)
      try_swap(i);
    else
      try_move(i);
  }
}

void Exchange::read_positions() {
  outlines_ = placed_outlines(floes_);
  grid_.clear();
  for (std::size_t i = 0; i < floes_.size(); ++i) grid_.insert(static_cast<int>(i), floes_[i].centre);
}

void Exchange::try_swap(int i) {
  const int count = static_cast<int>(floes_.size());
  const int j = std::clamp(i + static_cast<int>(random_.uniform(-k_swap_rank, k_swap_rank) * count), 0, count - 1);
  const bool keep_angle = random_.uniform() < k_keep_angle_share;
  if (i == j) return;
  const double before = overlap_now(i) + overlap_now(j);
  if (before == 0) return;
  Trial a{i, floes_[i], {}}, b{j, floes_[j], {}};
  std::swap(a.moved.centre, b.moved.centre);
  std::swap(a.moved.angle, b.moved.angle);
  if (!keep_angle)
    for (Trial* trial : {&a, &b}) trial->moved.angle = random_.uniform(-k_pi, k_pi);
  for (Trial* trial : {&a, &b}) place_outline(trial->moved, 1, trial->outline);
  double after = overlap(i, a.moved.centre, a.outline, j);
  if (after >= before) return;
  after += overlap(j, b.moved.centre, b.outline, i) + squared_depth(gap_ - best_axis(a.outline, b.outline).gap);
  if (after >= before) return;
  keep(a);
  keep(b);
}

void Exchange::try_move(int i) {
  const double before = overlap_now(i);
  if (before == 0) return;
  Trial trial{i, floes_[i], {}};
  if (random_.uniform() < k_far_share) {
    trial.moved.centre = random_place(bounds_, random_);
    trial.moved.angle = random_.uniform(-k_pi, k_pi);
  } else {
    const double step = k_near_move * std::sqrt(trial.moved.area);
    const double dx = random_.normal(), dy = random_.normal();
    trial.moved.centre += step * Vec2(dx, dy);
    trial.moved.angle += k_near_turn * random_.normal();
  }
  place_outline(trial.moved, 1, trial.outline);
  if (overlap(i, trial.moved.centre, trial.outline, i) < before) keep(trial);
}

double Exchange::overlap_now(int floe) const { return overlap(floe, floes_[floe].centre, outlines_[floe], floe); }

double Exchange::overlap(int floe, const Vec2& centre, const ConvexOutline& outline, int other) const {
  const double radius = floes_[floe].radius;
  double sum = squared_depth(gap_ + beyond_edge(outline, bounds_));
  grid_.visit_near(centre, radius + largest_radius_ + gap_, [&](int k) {
    if (k == floe || k == other) return;
    const double reach = radius + floes_[k].radius + gap_;
    if ((centre - floes_[k].centre).squaredNorm() >= reach * reach) return;
    sum += squared_depth(gap_ - best_axis(outline, outlines_[k]).gap);
  });
  for (const Obstacle& o : bounds_.obstacles)
    if (is_near(o, centre, radius, gap_)) sum += squared_depth(gap_ - best_axis(outline, o.outline).gap);
  return sum;
}

void Exchange::keep(Trial& trial) {
  LooseFloe& floe = floes_[trial.floe];
  grid_.erase(trial.floe, floe.centre);
  floe = std::move(trial.moved);
  grid_.insert(trial.floe, floe.centre);
  outlines_[trial.floe] = std::move(trial.outline);
}

}  // namespace nilas::field
