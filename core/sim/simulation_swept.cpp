/// Detection in time: what fast pairs meet on their way through a step, and where a step is cut. docs/theory/contact.md
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "contact/detect/broad/contact_key.h"
#include "core/bodies/free_rotation.h"
#include "core/sim/simulation_world.h"
#include "core/sim/step/advance.h"

namespace nilas {

namespace {

/// Pairs that go less than this share of the thinner body's thickness against each other cannot get past its middle.
constexpr double k_fast_share = 0.5;
/// Overlaps that a solved step must not lead to, since what reaches half of the thickness can leave on the other side
/// [of the thickness]. What is left of a way into a body, the next step finds as a penetration.
constexpr SoughtOverlap k_passing{0.02, k_fast_share};
/// Solutions of one step in which a body may turn out to have missed a contact. A step that can be halved is halved
/// then.
constexpr int k_most_misses = 8, k_most_misses_whole = 40;
/// A step is not halved into shorter parts than this [of the step].
constexpr double k_shortest_half = 1.0 / 65536;
/// A step is not cut into shorter parts than this: impacts that early are contacts of the part [of the step].
constexpr double k_shortest_part = 1e-3;
/// Parts end at an impact up to this error [of the step].
constexpr double k_instant = 1e-9;

/// The rotation vector of `turned` against `start` that is nearest to `expected`, which may be more than half a turn.
Vec3 rotation_between(const Quat& start, const Quat& turned, const Vec3& expected) {
  const Eigen::AngleAxisd turn(turned * start.conjugate());
  const double whole = 2 * k_pi * std::round((expected.dot(turn.axis()) - turn.angle()) / (2 * k_pi));
  return (turn.angle() + whole) * turn.axis();
}

using PartNames = std::tuple<int, int, int, int>;
template <class OfParts>
PartNames names(const OfParts& x) {
  return {x.a, x.b, x.part_a, x.part_b};
}

}  // namespace

void sort_as_detected(std::vector<ContactPoint>& points) {
  std::sort(points.begin(), points.end(), [](const ContactPoint& p, const ContactPoint& q) {
    return std::tuple(names(p), p.key) < std::tuple(names(q), q.key);
  });
}

/// Even turns that lead where the bodies will be after `exact` [s], gone on with for `horizon` [s].
std::vector<BodyMotion> Simulation::World::ways(const Velocities& velocities, const std::vector<FastPair>& pairs,
                                                double exact, double horizon) const {
  const Bodies& bodies = parts.bodies;
  std::vector<BodyMotion> motions(size());
  std::vector<char> known(size(), 0);
  for (const FastPair& pair : pairs)
    for (const int k : {pair.a, pair.b}) {
      const auto b = static_cast<std::size_t>(k);
      if (known[b]) continue;
      known[b] = 1;
      motions[b].p = bodies.p_GB[b];
      motions[b].R = bodies.R_GB[b];
      if (bodies.motion[b] == Motion::fixed) continue;
      motions[b].way = horizon * velocities.v[b];
      motions[b].turn = horizon * velocities.w[b];
      if (!gyroscopic || !bodies.is_free(k)) continue;
      Quat q = bodies.q_GB[b];
      Vec3 w = velocities.w[b];
      turn_freely(q, w, bodies.inertia_B[b], bodies.inertia_inverse_B[b], exact);
      motions[b].turn = horizon / exact * rotation_between(bodies.q_GB[b], q, exact * velocities.w[b]);
    }
  return motions;
}

/// Pairs that crush may overlap, and are none.
std::vector<FastPair> Simulation::World::list_fast_pairs(const Velocities& velocities, double horizon) const {
  std::vector<FastPair> pairs = fast_pairs(parts.bodies, {velocities.v, velocities.w, horizon}, width, k_fast_share);
  if (const PairFilter left = left_pairs())
    std::erase_if(pairs, [&](const FastPair& pair) { return left(pair.a, pair.b); });
  return pairs;
}

/// Fast pairs, where they would touch with these velocities or, with `overlap`, reach it.
std::vector<SweptPair> Simulation::World::sweep(const Velocities& velocities, double exact, double horizon,
                                                const SoughtOverlap& overlap) {
  const std::vector<FastPair> pairs = list_fast_pairs(velocities, horizon);
  if (pairs.empty()) return {};
  return detector.sweep(parts.bodies, ways(velocities, pairs, exact, horizon), pairs, overlap);
}

/// The velocities that a part of the step as long as `h` would end with, its impacts still to come left out. The vessel
/// goes on as it does.
Velocities Simulation::World::velocities_until_impact() {
  Velocities velocities;
  free_velocities(parts.bodies, free_loads, h, velocities);
  if (fast_pairs(parts.bodies, {velocities.v, velocities.w, h}, width, k_fast_share).empty()) return velocities;
  std::vector<ContactPoint> points = find_contacts();
  add_crush_points(points);
  if (points.empty()) return velocities;
  std::vector<ArticulatedBlock> vessel;
  if (parts.vessel && !parts.vessel->fixed()) {
    ArticulatedBlock& block = vessel.emplace_back();
    for (int body = parts.vessel_index; parts.is_of_vessel(body); ++body) {
      const auto b = static_cast<std::size_t>(body);
      Vec6 twist;
      twist << velocities.v[b], velocities.w[b];
      block.bodies.push_back({body, MatX(6, 0), twist});
    }
  }
  AssembledContacts contacts = assemble(parts.bodies, free_loads, points, parts.friction, model.assembly, vessel);
  const std::optional<StaticFriction> slipped = model.static_friction;
  const ContactSolution solution = model.solve(contacts.problem, VecX());
  model.static_friction = slipped;
  return new_velocities(contacts, solution, free_loads);
}

/// The part of the step that ends with the first impact of a fast pair, at most `left` [s]. Loads and contacts change
/// velocities by the part's length, so that it is a fixed point.
double Simulation::World::until_first_impact(double left) {
  const double shortest = k_shortest_part * whole_step;
  h = left;
  cut = true;
  constexpr int k_most_passes = 20;
  for (int pass = 0; pass < k_most_passes; ++pass) {
    model.set_step(h);
    double first = left;
    for (const SweptPair& pair : sweep(velocities_until_impact(), h, left))
      if (pair.first.hit && pair.first.t * left >= shortest) first = std::min(first, pair.first.t * left);
    if (left - first < shortest) return left;
    if (std::abs(first - h) <= k_instant * whole_step) return first;
    h = first;
  }
  return h;
}

/// A contact on the way is given where each body has the arm it will have there, and a gap that these velocities close
/// just then, so that the step may go up to it and no further.
ContactPoint Simulation::World::as_gap(const ContactPoint& met, double t, const Velocities& velocities) const {
  const Bodies& bodies = parts.bodies;
  const auto a = static_cast<std::size_t>(met.a), b = static_cast<std::size_t>(met.b);
  const auto way = [&](std::size_t k) -> Vec3 {
    return bodies.motion[k] == Motion::fixed ? Vec3(Vec3::Zero()) : Vec3(t * h * velocities.v[k]);
  };
  const auto turn = [&](std::size_t k) { return bodies.motion[k] == Motion::fixed ? 0 : velocities.w[k].norm(); };
  double share_b = 0.5;  // one point serves both: the arm of what turns, or moves at all, is right
  if (bodies.motion[a] == Motion::fixed || bodies.motion[b] == Motion::fixed)
    share_b = bodies.motion[a] == Motion::fixed ? 1 : 0;
  else if (turn(a) + turn(b) > 0)
    share_b = turn(b) / (turn(a) + turn(b));
  ContactPoint point = met;
  const auto speed = [&] {
    const auto velocity = [&](std::size_t k) -> Vec3 {
      if (bodies.motion[k] == Motion::fixed) return Vec3::Zero();
      return velocities.v[k] + velocities.w[k].cross(point.p - bodies.p_GB[k]);
    };
    return met.n.dot(velocity(b) - velocity(a));
  };
  for (const double share : {share_b, 1.0, 0.0}) {
    point.p = met.p - (1 - share) * way(a) - share * way(b);
    if (speed() < 0) break;
  }
  point.gap = std::max(met.gap, 0.0) + t * h * std::max(-speed(), 0.0);
  return point;
}

/// Fast pairs that do not touch yet have the contacts of their way instead of those that the step's start shows; in a
/// part that ends with an impact none, but those too early to cut at.
void Simulation::World::follow_fast_pairs(std::vector<ContactPoint>& points) {
  on_the_way.clear();
  const auto thinner = [&](const ContactPoint& c) {
    return std::min(width[static_cast<std::size_t>(c.a)], width[static_cast<std::size_t>(c.b)]);
  };
  // what is farther away can only be closed by a fast pair, at the part's end
  if (cut) std::erase_if(points, [&](const ContactPoint& c) { return c.gap > k_fast_share * thinner(c); });
  Velocities velocities;
  free_velocities(parts.bodies, free_loads, h, velocities);
  const FastMotion motion{velocities.v, velocities.w, h};
  if (!any_fast(parts.bodies, motion, width, k_fast_share)) return;
  const std::vector<SweptPair> swept = sweep(velocities, h, h);
  std::vector<PartNames> touching;
  for (const SweptPair& pair : swept)
    if (pair.first.hit && pair.first.t == 0) touching.push_back(names(pair));
  std::erase_if(points, [&](const ContactPoint& c) {
    return c.gap > 0 && is_fast(parts.bodies, motion, width, k_fast_share, c.a, c.b) &&
           !std::binary_search(touching.begin(), touching.end(), names(c));
  });
  for (const SweptPair& pair : swept) {
    if (!pair.first.hit || pair.first.t == 0) continue;
    if (cut && pair.first.t * h >= k_shortest_part * whole_step) continue;
    for (const ContactPoint& met : pair.points) {
      points.push_back(as_gap(met, pair.first.t, velocities));
      on_the_way.push_back(met.key);
    }
  }
  sort_as_detected(points);
}

/// Where a position correction takes the contact points: at the step's end; those of fast pairs where they were found,
/// since a turn of their bodies leads elsewhere than what is carried with them.
std::vector<ContactPoint> Simulation::World::points_at_the_end(const StepMotion& motion) const {
  std::vector<ContactPoint> points = carried_points(motion, parts.bodies);
  const FastMotion after{motion.after.v, motion.after.w, h};
  if (model.detection != Detection::continuous) return points;
  if (on_the_way.empty() && !any_fast(parts.bodies, after, width, k_fast_share)) return points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ContactPoint& found = motion.points[i];
    const bool met = std::find(on_the_way.begin(), on_the_way.end(), found.key) != on_the_way.end();
    if (!met && !is_fast(parts.bodies, after, width, k_fast_share, found.a, found.b)) continue;
    points[i] = found;
    points[i].gap = std::min(found.gap, 0.0);
  }
  return points;
}

/// The velocities that were solved for, of all bodies.
Velocities Simulation::World::solved_velocities(const AssembledContacts& contacts, const ContactSolution& solution,
                                                const std::vector<ArticulatedBlock>& vessel) const {
  Velocities after = new_velocities(contacts, solution, free_loads);
  for (const ArticulatedBlock& block : vessel) {
    VecX without_contact;
    for (const ArticulatedBody& body : block.bodies) {
      Vec6 twist = body.prescribed;
      const auto b = static_cast<std::size_t>(body.body);
      if (const int k = contacts.block_of_body[b]; k >= 0) {
        twist += body.jacobian *
                 solution.v.segment(contacts.problem.block_offset[static_cast<std::size_t>(k)], body.jacobian.cols());
      } else if (block.f.size() > 0) {
        if (without_contact.size() == 0) without_contact = block.mass.ldlt().solve(block.f);
        twist += body.jacobian * without_contact;
      }
      after.v[b] = twist.head<3>();
      after.w[b] = twist.tail<3>();
    }
  }
  return after;
}

/// True when the velocities that were solved for still lead fast pairs into each other: their contacts there are added.
/// Each body has its own number of solutions in which it may miss some, so that strangers do not use them up.
bool Simulation::World::add_missed(const Velocities& after, std::vector<int>& misses,
                                   std::vector<ContactPoint>& points) {
  unheld.clear();
  if (model.detection != Detection::continuous) return false;
  misses.resize(size());
  const int most = can_be_halved() ? k_most_misses : k_most_misses_whole;
  std::vector<char> missed(size(), 0);
  bool added = false;
  for (const SweptPair& pair : sweep(after, h, h, k_passing)) {
    if (!pair.first.hit || pair.first.t == 0) continue;
    const auto a = static_cast<std::size_t>(pair.a), b = static_cast<std::size_t>(pair.b);
    const int before = std::max(misses[a], misses[b]);
    if (before >= most) {
      unheld.emplace_back(pair.a, pair.b);
      continue;
    }
    missed[a] = missed[b] = 1;
    for (const ContactPoint& met : pair.points) {
      points.push_back(as_gap(met, pair.first.t, after));
      points.back().key = mix(met.key, static_cast<std::uint64_t>(before) + 1);
      on_the_way.push_back(points.back().key);
      added = true;
    }
  }
  for (std::size_t b = 0; b < size(); ++b) misses[b] += missed[b];
  if (added) sort_as_detected(points);
  return added;
}

bool Simulation::World::can_be_halved() const { return h > k_shortest_half * whole_step; }

/// The width of a body's thickest part: what pierces a sliver of it is not through the body.
static double thickest_part(const Shape& shape, double smallest) {
  double thickest = smallest;
  for (const auto& part : shape.parts) thickest = std::max(thickest, part.smallest_width);
  return thickest;
}

/// Two bodies of which one would go deeper into the other by half the thinner one's thickness: it could leave on the
/// other side.
std::optional<std::pair<int, int>> Simulation::World::passing(const Velocities& velocities, double horizon) {
  std::vector<FastPair> pairs = list_fast_pairs(velocities, horizon);
  if (pairs.empty()) return std::nullopt;
  const auto thickness = [&](int body) {
    const auto b = static_cast<std::size_t>(body);
    return thickest_part(*parts.bodies.shape[b], width[b]);
  };
  for (FastPair& pair : pairs) pair.width = std::min(thickness(pair.a), thickness(pair.b));
  constexpr SoughtOverlap k_half{k_fast_share, 2 * k_fast_share};
  for (const SweptPair& pair : detector.sweep(parts.bodies, ways(velocities, pairs, horizon, horizon), pairs, k_half)) {
    if (!pair.first.hit || pair.first.t == 0) continue;
    return std::pair(pair.a, pair.b);
  }
  return std::nullopt;
}

void Simulation::World::refuse(const std::pair<int, int>& pair) const {
  const auto& name = parts.bodies.name;
  throw SimulationError(
      fmt::format("at {:g} s body '{}' would pass through body '{}' within one step; try a smaller <time step>", time(),
                  name[static_cast<std::size_t>(pair.second)], name[static_cast<std::size_t>(pair.first)]));
}

/// What the last solution could not hold stays as a penetration, or is refused.
void Simulation::World::judge_unheld(const Velocities& after) {
  if (const auto pair = passing(after, h)) refuse(*pair);
  warnings.warn("steps with impacts that were not resolved",
                fmt::format("at {:g} s bodies overlap on their way after all solutions of the step; try a smaller "
                            "<time step>",
                            time()));
}

}  // namespace nilas
