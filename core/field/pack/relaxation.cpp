#include "core/field/pack/relaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/field/pack/overlaps.h"

namespace nilas::field {

namespace {

/// Largest move of a floe in a pass as a share of its size, so that it cannot jump over a neighbour.
constexpr double k_largest_move = 0.25;
/// Scale of floes in the search for pairs, so that growth does not require a new search in every pass.
constexpr double k_pair_scale = 1.02;

}  // namespace

Relaxation::Relaxation(std::vector<LooseFloe>& floes, const FieldBounds& bounds, const RelaxationSettings& settings)
    : floes_(floes),
      bounds_(bounds),
      settings_(settings),
      outlines_(floes.size()),
      displacements_(floes.size(), Vec3::Zero()),
      travelled_(floes.size(), 0.0) {}

double Relaxation::pass(double scale, double accepted) {
  for (std::size_t i = 0; i < floes_.size(); ++i) place_outline(floes_[i], scale, outlines_[i]);
  if (!pairs_hold(scale)) find_pairs(scale);
  find_contacts();
  double worst = -std::numeric_limits<double>::infinity();
  for (const Contact& contact : contacts_) worst = std::max(worst, contact.lack);
  if (worst <= accepted) return worst;
  for (int k = 0; k < settings_.sweeps; ++k) sweep();
  move();
  return worst;
}

bool Relaxation::pairs_hold(double scale) const {
  if (!pairs_valid_ || scale > pair_scale_) return false;
  return *std::max_element(travelled_.begin(), travelled_.end()) < 0.5 * settings_.reach;
}

void Relaxation::find_pairs(double scale) {
  pair_scale_ = k_pair_scale * scale;
  // Each of two floes may travel half a reach before the pairs are searched again.
  const double distance = settings_.gap + 2 * settings_.reach;
  pairs_.clear();
  for (const NearPair& pair : near_pairs(floes_, pair_scale_, distance)) pairs_.push_back({pair.a, pair.b});
  for (std::size_t o = 0; o < bounds_.obstacles.size(); ++o)
    for (std::size_t i = 0; i < floes_.size(); ++i)
      if (is_near(bounds_.obstacles[o], floes_[i].centre, pair_scale_ * floes_[i].radius, distance))
        pairs_.push_back({static_cast<int>(i), -static_cast<int>(o) - 1});
  std::fill(travelled_.begin(), travelled_.end(), 0.0);
  pairs_valid_ = true;
}

void Relaxation::find_contacts() {
  contacts_.clear();
  const double reach = settings_.gap + settings_.reach;
  for (Pair& pair : pairs_) {
    const ConvexOutline& a = outlines_[pair.a];
    const ConvexOutline& b = pair.b >= 0 ? outlines_[pair.b] : bounds_.obstacles[-pair.b - 1].outline;
    if (gap_on_axis(a, b, pair.edge, pair.of_first) >= reach) continue;
    const SeparatingAxis axis = best_axis(a, b);
    pair.edge = axis.edge;
    pair.of_first = axis.of_first;
    if (axis.gap >= reach) continue;
    const Touching touching = touching_points(a, b, axis, reach);
    for (int k = 0; k < touching.count; ++k)
      add_contact(pair.a, pair.b, touching.normal, touching.point[k], touching.gap[k]);
  }
  for (int a = 0; a < static_cast<int>(floes_.size()); ++a) add_wall_contacts(a);
}

void Relaxation::add_wall_contacts(int a) {
  const LooseFloe& floe = floes_[a];
  const double reach = settings_.gap + settings_.reach;
  const auto wall = [&](const Vec2& outward, double offset) {
    if (offset - outward.dot(floe.centre) > pair_scale_ * floe.radius + reach) return;
    for (const Vec2& corner : outlines_[a].corners) {
      const double gap = offset - outward.dot(corner);
      if (gap < reach) add_contact(a, -1, outward, corner, gap);
    }
  };
  wall({1, 0}, bounds_.high.x());
  wall({-1, 0}, -bounds_.low.x());
  wall({0, 1}, bounds_.high.y());
  wall({0, -1}, -bounds_.low.y());
}

void Relaxation::add_contact(int a, int b, const Vec2& normal, const Vec2& point, double gap) {
  double yielding = 0;
  const auto arm = [&](int floe) {
    const LooseFloe& f = floes_[floe];
    const Vec2 r = point - f.centre;
    const double r_cross_n = r.x() * normal.y() - r.y() * normal.x();
    yielding += 1 / f.area + r_cross_n * r_cross_n / f.polar_moment;
    return r_cross_n;
  };
  const double arm_a = arm(a), arm_b = b >= 0 ? arm(b) : 0;
  contacts_.push_back({a, b, normal, arm_a, arm_b, settings_.gap - gap, 1 / yielding, 0});
}

void Relaxation::apply(int floe, const Vec2& normal, double arm, double impulse) {
  const LooseFloe& f = floes_[floe];
  const double move = impulse / f.area;
  displacements_[floe] += Vec3(normal.x() * move, normal.y() * move, arm * impulse / f.polar_moment);
}

void Relaxation::sweep() {
  for (Contact& c : contacts_) {
    const Vec3& a = displacements_[c.a];
    double opening = -(c.normal.x() * a.x() + c.normal.y() * a.y() + c.arm_a * a.z());
    if (c.b >= 0) {
      const Vec3& b = displacements_[c.b];
      opening += c.normal.x() * b.x() + c.normal.y() * b.y() + c.arm_b * b.z();
    }
    const double impulse = std::max(0.0, c.impulse + c.response * (c.lack - opening));
    const double change = impulse - c.impulse;
    if (change == 0) continue;
    c.impulse = impulse;
    apply(c.a, c.normal, c.arm_a, -change);
    if (c.b >= 0) apply(c.b, c.normal, c.arm_b, change);
  }
}

void Relaxation::move() {
  for (std::size_t i = 0; i < floes_.size(); ++i) {
    LooseFloe& floe = floes_[i];
    Vec3& step = displacements_[i];
    double way = step.head<2>().norm() + floe.radius * std::abs(step.z());
    const double largest = k_largest_move * std::sqrt(floe.area);
    if (way > largest) {
      step *= largest / way;
      way = largest;
    }
    floe.centre += step.head<2>();
    floe.angle += step.z();
    travelled_[i] += way;
    step.setZero();
  }
}

}  // namespace nilas::field
