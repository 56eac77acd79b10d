#include "core/sim/step/find_contacts.h"

#include <algorithm>
#include <tuple>

#include "contact/detect/broad/reach.h"
#include "core/sim/step/advance.h"
#include "core/sim/step/fast_bodies.h"

namespace nilas::sim {

namespace {

/// Contacts enter the problem when they can close within this multiple of the bodies' path in one substep. It is above
/// 1 because a hit may turn points of a floe faster than the body that hit it moves.
constexpr double k_reach_share = 1.5;

using PartNames = std::tuple<int, int, int, int>;
template <class OfParts>
PartNames names(const OfParts& x) {
  return {x.a, x.b, x.part_a, x.part_b};
}

double thinner(const World& world, const detect::ContactPoint& c) {
  return std::min(world.width[c.a], world.width[c.b]);
}

std::vector<detect::ContactPoint> detect_within_reach(World& world, const Loads& loads, const Substep& substep) {
  const bodies::Bodies& bodies = world.parts.bodies;
  return world.detector.detect(bodies, detect::own_reach(bodies, loads.total, substep.h, k_reach_share),
                               world.model.margin, pairs_left_out(world));
}

std::vector<detect::ContactPoint> detect_discrete(World& world, const Loads& loads, const Substep& substep) {
  if (world.model.margin > 0)
    return world.detector.detect(world.parts.bodies, world.model.margin, pairs_left_out(world));
  std::vector<detect::ContactPoint> points = detect_within_reach(world, loads, substep);
  std::erase_if(points, [&](const detect::ContactPoint& c) { return c.gap > thinner(world, c); });
  return points;
}

/// Gives fast pairs that do not touch yet the contacts on their paths in place of those at the substep's start. In a
/// substep that ends with an impact they have none, except those too early to cut at.
void follow_fast_pairs(World& world, const Loads& loads, const Substep& substep, FoundContacts& found) {
  const bodies::Bodies& bodies = world.parts.bodies;
  std::vector<detect::ContactPoint>& points = found.points;
  // Only a fast pair can close a larger gap, and that happens at the substep's end.
  if (substep.ends_with_impact)
    std::erase_if(points, [&](const detect::ContactPoint& c) { return c.gap > k_fast_share * thinner(world, c); });
  contact::Velocities velocities;
  free_velocities(bodies, loads.total, substep.h, velocities);
  const detect::FastMotion motion{velocities.v, velocities.w, substep.h};
  if (!detect::any_fast(bodies, motion, world.width, k_fast_share)) return;
  const std::vector<detect::SweptPair> swept = sweep(world, velocities, substep.h, substep.h);
  std::vector<PartNames> touching;
  for (const detect::SweptPair& pair : swept)
    if (pair.first.hit && pair.first.t == 0) touching.push_back(names(pair));
  std::erase_if(points, [&](const detect::ContactPoint& c) {
    return c.gap > 0 && detect::is_fast(bodies, motion, world.width, k_fast_share, c.a, c.b) &&
           !std::binary_search(touching.begin(), touching.end(), names(c));
  });
  for (const detect::SweptPair& pair : swept) {
    if (!pair.first.hit || pair.first.t == 0) continue;
    if (substep.ends_with_impact && pair.first.t * substep.h >= k_shortest_cut * world.step) continue;
    for (const detect::ContactPoint& met : pair.points) {
      points.push_back(as_gap(world, met, pair.first.t, velocities, substep.h));
      found.met_on_path.push_back(met.key);
    }
  }
  sort_as_detected(points);
}

/// Whether a contact bounces, by the criterion of assemble(): approach slower than the threshold ends a series of
/// bounces. A body that could be half through another when they meet bounces at once.
bool will_bounce_when_met(const World& world, const detect::ContactPoint& c, double h) {
  const bodies::Bodies& bodies = world.parts.bodies;
  const double before = c.n.dot(bodies.velocity_at(c.b, c.p) - bodies.velocity_at(c.a, c.p));
  if (before >= -world.model.assembly.restitution_threshold) return false;
  constexpr double k_deepest_share = 0.5;
  if (-before * h > k_deepest_share * thinner(world, c)) return false;
  return world.parts.friction.of(bodies.material[c.a], bodies.material[c.b]).restitution > 0;
}

}  // namespace

void sort_as_detected(std::vector<detect::ContactPoint>& points) {
  std::sort(points.begin(), points.end(), [](const detect::ContactPoint& p, const detect::ContactPoint& q) {
    return std::tuple(names(p), p.key) < std::tuple(names(q), q.key);
  });
}

FoundContacts find_contacts(World& world, const Loads& loads, const Substep& substep) {
  FoundContacts found;
  switch (world.model.detection) {
    case Detection::discrete:
      found.points = detect_discrete(world, loads, substep);
      break;
    case Detection::speculative:
      found.points = detect_within_reach(world, loads, substep);
      break;
    case Detection::continuous:
      found.points = detect_within_reach(world, loads, substep);
      follow_fast_pairs(world, loads, substep, found);
      break;
  }
  // Impulses act in the middle of the motion: a bouncing point must have no impulse before it touches. A bounce is then
  // symmetric in time.
  if (world.model.hit_when_met)
    std::erase_if(found.points, [&](const detect::ContactPoint& c) {
      return c.gap > 0 && will_bounce_when_met(world, c, substep.h);
    });
  return found;
}

void add_module_contacts(World& world, const Substep& substep, std::vector<detect::ContactPoint>& points) {
  const std::size_t rigid = points.size();
  for (const auto& module : world.parts.modules) {
    if (!module->owns_pairs()) continue;
    bodies::BodyPairs near = world.detector.pairs_left();
    std::erase_if(near, [&](const auto& pair) {
      return world.parts.are_joined(pair.first, pair.second) || !module->owns_pair(pair.first, pair.second);
    });
    module->add_contacts(world.parts.bodies, near, {substep.h, world.model.theta * substep.h}, points);
  }
  if (points.size() > rigid) sort_as_detected(points);
}

detect::ContactPoint as_gap(const World& world, const detect::ContactPoint& met, double t,
                            const contact::Velocities& velocities, double h) {
  const bodies::Bodies& bodies = world.parts.bodies;
  const auto a = static_cast<std::size_t>(met.a), b = static_cast<std::size_t>(met.b);
  const auto path = [&](std::size_t k) -> Vec3 {
    return bodies.motion[k] == bodies::Motion::fixed ? Vec3(Vec3::Zero()) : Vec3(t * h * velocities.v[k]);
  };
  const auto turn = [&](std::size_t k) {
    return bodies.motion[k] == bodies::Motion::fixed ? 0 : velocities.w[k].norm();
  };
  double share_b = 0.5;  // one point serves both bodies: the arm is exact for the one that turns, or moves at all
  if (bodies.motion[a] == bodies::Motion::fixed || bodies.motion[b] == bodies::Motion::fixed)
    share_b = bodies.motion[a] == bodies::Motion::fixed ? 1 : 0;
  else if (turn(a) + turn(b) > 0)
    share_b = turn(b) / (turn(a) + turn(b));
  detect::ContactPoint point = met;
  const auto speed = [&] {
    const auto velocity = [&](std::size_t k) -> Vec3 {
      if (bodies.motion[k] == bodies::Motion::fixed) return Vec3::Zero();
      return velocities.v[k] + velocities.w[k].cross(point.p - bodies.p_GB[k]);
    };
    return met.n.dot(velocity(b) - velocity(a));
  };
  for (const double share : {share_b, 1.0, 0.0}) {
    point.p = met.p - (1 - share) * path(a) - share * path(b);
    if (speed() < 0) break;
  }
  point.gap = std::max(met.gap, 0.0) + t * h * std::max(-speed(), 0.0);
  return point;
}

}  // namespace nilas::sim
