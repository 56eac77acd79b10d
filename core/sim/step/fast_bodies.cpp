#include "core/sim/step/fast_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/bodies/free_rotation.h"

namespace nilas::sim {

namespace {

/// The rotation vector from `start` to `turned` that is nearest to `expected`, which may exceed half a turn.
Vec3 rotation_between(const Quat& start, const Quat& turned, const Vec3& expected) {
  const Eigen::AngleAxisd turn(turned * start.conjugate());
  const double whole = 2 * k_pi * std::round((expected.dot(turn.axis()) - turn.angle()) / (2 * k_pi));
  return (turn.angle() + whole) * turn.axis();
}

/// Uniform rotations that lead to the attitudes of these pairs' bodies after `exact` [s], continued for `horizon` [s].
std::vector<detect::BodyMotion> paths(const World& world, const contact::Velocities& velocities,
                                      const std::vector<detect::FastPair>& pairs, double exact, double horizon) {
  const bodies::Bodies& bodies = world.parts.bodies;
  std::vector<detect::BodyMotion> motions(world.size());
  std::vector<char> known(world.size(), 0);
  for (const detect::FastPair& pair : pairs)
    for (const int k : {pair.a, pair.b}) {
      const auto b = static_cast<std::size_t>(k);
      if (known[b]) continue;
      known[b] = 1;
      motions[b].p = bodies.p_GB[b];
      motions[b].R = bodies.R_GB[b];
      if (bodies.motion[b] == bodies::Motion::fixed) continue;
      motions[b].way = horizon * velocities.v[b];
      motions[b].turn = horizon * velocities.w[b];
      if (!world.gyroscopic || !bodies.is_free(k)) continue;
      Quat q = bodies.q_GB[b];
      Vec3 w = velocities.w[b];
      if (bodies.has_added_mass()) {
        Vec3 p = bodies.p_GB[b], v = velocities.v[b];
        const Mat6 mass = bodies.whole_mass_B(k);
        bodies::move_freely(p, q, v, w, mass, mass.llt().solve(Mat6::Identity()), bodies.flow, exact);
        motions[b].way = horizon / exact * (p - bodies.p_GB[b]);
      } else {
        bodies::turn_freely(q, w, bodies.inertia_B[b], bodies.inertia_inverse_B[b], exact);
      }
      motions[b].turn = horizon / exact * rotation_between(bodies.q_GB[b], q, exact * velocities.w[b]);
    }
  return motions;
}

/// The fast pairs, without those of pairs_left_out(), which may overlap.
std::vector<detect::FastPair> list_fast_pairs(const World& world, const contact::Velocities& velocities,
                                              double horizon) {
  std::vector<detect::FastPair> pairs =
      detect::fast_pairs(world.parts.bodies, {velocities.v, velocities.w, horizon}, world.width, k_fast_share);
  if (const detect::PairFilter left = pairs_left_out(world))
    std::erase_if(pairs, [&](const detect::FastPair& pair) { return left(pair.a, pair.b); });
  return pairs;
}

/// Smallest width of a body's thickest convex piece: a body that pierces only a sliver is not through it.
double thickest_part(const geometry::Shape& shape, double smallest) {
  double thickest = smallest;
  for (const auto& part : shape.parts) thickest = std::max(thickest, part.smallest_width);
  return thickest;
}

}  // namespace

detect::PairFilter pairs_left_out(const World& world) {
  std::vector<const bodies::Module*> owners;
  for (const auto& module : world.parts.modules)
    if (module->owns_pairs()) owners.push_back(module.get());
  if (owners.empty() && world.parts.joined.empty()) return {};
  return [&parts = world.parts, owners](int a, int b) {
    return std::any_of(owners.begin(), owners.end(),
                       [&](const bodies::Module* owner) { return owner->owns_pair(a, b); }) ||
           parts.are_joined(a, b);
  };
}

std::vector<detect::SweptPair> sweep(World& world, const contact::Velocities& velocities, double exact, double horizon,
                                     const detect::SoughtOverlap& overlap) {
  const std::vector<detect::FastPair> pairs = list_fast_pairs(world, velocities, horizon);
  if (pairs.empty()) return {};
  return world.detector.sweep(world.parts.bodies, paths(world, velocities, pairs, exact, horizon), pairs, overlap);
}

std::optional<std::pair<int, int>> passing_bodies(World& world, const contact::Velocities& velocities, double horizon) {
  const bodies::Bodies& bodies = world.parts.bodies;
  std::vector<detect::FastPair> pairs = list_fast_pairs(world, velocities, horizon);
  if (pairs.empty()) return std::nullopt;
  const auto thickness = [&](int body) {
    const auto b = static_cast<std::size_t>(body);
    return thickest_part(*bodies.shape[b], world.width[b]);
  };
  for (detect::FastPair& pair : pairs) pair.width = std::min(thickness(pair.a), thickness(pair.b));
  constexpr detect::SoughtOverlap k_half{k_fast_share, 2 * k_fast_share};
  const auto motions = paths(world, velocities, pairs, horizon, horizon);
  for (const detect::SweptPair& pair : world.detector.sweep(bodies, motions, pairs, k_half)) {
    if (!pair.first.hit || pair.first.t == 0) continue;
    return std::pair(pair.a, pair.b);
  }
  return std::nullopt;
}

void refuse_passing(const World& world, const std::pair<int, int>& pair, double t) {
  const auto& name = world.parts.bodies.name;
  throw SimulationError(
      fmt::format("at {:g} s body '{}' would pass through body '{}' within one step; try a smaller <time step>", t,
                  name[pair.second], name[pair.first]));
}

}  // namespace nilas::sim
