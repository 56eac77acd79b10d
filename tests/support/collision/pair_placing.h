#pragma once
/// Draws pairs of a class at random and places them at a known depth or distance.
#include "tests/support/collision/distance_oracle.h"
#include "tests/support/collision/pair_classes.h"
#include "tests/support/random_vectors.h"

namespace nilas::pairs {

/// A point of a body's surface and a direction that is an outward normal there, in the body's frame.
struct Side {
  Vec3 point = Vec3::Zero(), n = Vec3::UnitX();
};

inline Side of_face(const oracle::Solid& solid, RandomStream& random) {
  const auto f = static_cast<std::size_t>(random.uniform(0, static_cast<double>(solid.faces.size())));
  Side side;
  double sum = 0;
  for (const int v : solid.faces[f]) {
    const double weight = -std::log(1 - random.uniform());
    side.point += weight * solid.vertices[v];
    sum += weight;
  }
  side.point /= sum;
  side.n = solid.normals[f];
  return side;
}

/// A random direction between the normals of the faces that hold all of `vertices`.
inline Vec3 direction_at(const oracle::Solid& solid, const std::vector<int>& vertices, RandomStream& random) {
  Vec3 n = Vec3::Zero();
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    const auto has = [&](int v) {
      return std::find(solid.faces[f].begin(), solid.faces[f].end(), v) != solid.faces[f].end();
    };
    if (std::all_of(vertices.begin(), vertices.end(), has)) n += random.uniform(0.02, 1) * solid.normals[f];
  }
  return n.normalized();
}

inline Side of_edge(const oracle::Solid& solid, RandomStream& random) {
  const auto [i, j] = solid.edges[static_cast<std::size_t>(random.uniform(0, static_cast<double>(solid.edges.size())))];
  const double t = random.uniform(0.02, 0.98);
  return {(1 - t) * solid.vertices[i] + t * solid.vertices[j], direction_at(solid, {i, j}, random)};
}

inline Side of_vertex(const oracle::Solid& solid, RandomStream& random) {
  const int v = static_cast<int>(random.uniform(0, static_cast<double>(solid.vertices.size())));
  return {solid.vertices[v], direction_at(solid, {v}, random)};
}

/// Lays side `b` of body 1 against side `a` of body 0, turned about their common normal at random.
inline void lay_against(bodies::Bodies& bodies, const Side& a, const Side& b, double gap, RandomStream& random) {
  const Quat spin(Eigen::AngleAxisd(random.uniform(0, 2 * k_pi), b.n));
  const Quat q = bodies.q_GB[0] * Quat::FromTwoVectors(b.n, -a.n) * spin;
  bodies.set_pose(1, bodies.p_GB[0], q);
  const Vec3 touch = bodies.R_GB[0] * (a.point + gap * a.n) - bodies.R_GB[1] * b.point;
  bodies.set_pose(1, bodies.p_GB[0] + touch, q);
}

inline Quat attitude_of(Meeting meeting, RandomStream& random) {
  constexpr double k_tilt = 0.02;
  if (meeting == Meeting::flat || meeting == Meeting::mirrored)
    return Quat(Eigen::AngleAxisd(random.uniform(0, 2 * k_pi), Vec3::UnitZ()));
  return meeting == Meeting::afloat ? detect::random_tilt(random, k_tilt) : test::random_attitude(random);
}

/// Direction in which B lies from A: horizontal for half of the afloat and flat pairs, above or below for the others.
inline Vec3 direction_of(Meeting meeting, RandomStream& random) {
  Vec3 d(random.normal(), random.normal(), random.normal());
  if (meeting != Meeting::any_attitude) {
    if (random.uniform() < 0.5)
      d.z() = 0;
    else
      d = Vec3(0, 0, d.z());
  }
  return d.normalized();
}

/// All convex pieces of a body, in coordinates relative to body 0's position.
inline std::vector<oracle::Solid> solids_of(const bodies::Bodies& bodies, int b) {
  const std::size_t count = std::max<std::size_t>(bodies.shape[b]->parts.size(), 1);
  std::vector<oracle::Solid> solids;
  for (std::size_t part = 0; part < count; ++part)
    solids.push_back(oracle::posed(bodies, b, static_cast<int>(part), bodies.p_GB[0]));
  return solids;
}

/// Moves body 1 along d until no axis of any two polytopes separates them by more than `target`, and one separates them
/// by `target`.
inline void slide_along(bodies::Bodies& bodies, const Vec3& d, double target) {
  double way = -oracle::k_infinite;
  for (const auto& a : solids_of(bodies, 0))
    for (const auto& b : solids_of(bodies, 1)) {
      double of_pair = oracle::k_infinite;
      constexpr double k_along = 1e-6;
      const auto floor = [&](const Vec3& n) {
        const double along = n.dot(d);
        return along > k_along ? target - of_pair * along : oracle::k_infinite;
      };
      oracle::visit_flat_axes(a, b, floor,
                              [&](const Vec3& n, double s) { of_pair = std::min(of_pair, (target - s) / n.dot(d)); });
      way = std::max(way, of_pair);
    }
  bodies.set_pose(1, bodies.p_GB[1] + way * d, bodies.q_GB[1]);
}

/// Brings two bodies, of which one is round, from afar to a gap of about `target` [m]. Each move is along the axis that
/// separates them most.
inline void bring_together(bodies::Bodies& bodies, double target) {
  constexpr int k_moves = 3;
  for (int move = 0; move < k_moves; ++move) {
    const auto gap = oracle::true_gap(solids_of(bodies, 0)[0], solids_of(bodies, 1)[0]);
    bodies.set_pose(1, bodies.p_GB[1] + (target - gap.s) * gap.n, bodies.q_GB[1]);
  }
}

inline double reach(const geometry::Shape& shape) {
  double reach = std::hypot(shape.radius, shape.half_height);
  for (const auto& part : shape.parts) reach = std::max(reach, part.centre.norm() + part.radius);
  return reach;
}

inline void come_from_a_side(const PairClass& c, bodies::Bodies& bodies, double target, RandomStream& random) {
  const Vec3 d = direction_of(c.meeting, random);
  const bool round = bodies.shape[0]->parts.empty() || bodies.shape[1]->parts.empty();
  const double afar = round ? reach(*bodies.shape[0]) + reach(*bodies.shape[1]) : 0;
  const double aside = 0.3 * reach(*bodies.shape[0]);
  bodies.set_pose(1, bodies.p_GB[0] + afar * d + aside * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 0),
                  bodies.q_GB[1]);
  if (round)
    bring_together(bodies, target);
  else
    slide_along(bodies, d, target);
}

/// Gives B the outline of A mirrored in one of A's sides, so that they share that side.
inline void stand_mirrored(bodies::Bodies& bodies, double gap, RandomStream& random) {
  const auto& outline = bodies.shape[0]->outline;
  const auto k = static_cast<std::size_t>(random.uniform(0, static_cast<double>(outline.size())));
  const Vec2 p = outline[k], along = (outline[(k + 1) % outline.size()] - p).normalized();
  const Vec2 out(along.y(), -along.x());
  std::vector<Vec2> image;
  for (const Vec2& x : outline) image.push_back(x - 2 * out.dot(x - p) * out);
  std::reverse(image.begin(), image.end());
  const Vec2 centre = geometry::polygon_moments(image).centroid;
  bodies.shape[1] = std::make_shared<const geometry::Shape>(detect::floe_shape(image, bodies.shape[0]->thickness));
  const Vec2 place = centre + gap * out;
  bodies.set_pose(1, bodies.p_GB[0] + bodies.R_GB[0] * Vec3(place.x(), place.y(), 0), bodies.q_GB[0]);
}

/// The gap to aim for [m]: overlaps and gaps are equally frequent. A third of the mirrored pairs get coincident sides.
inline double draw_gap(const PairClass& c, RandomStream& random) {
  constexpr double k_least = 5e-5;
  if (c.meeting == Meeting::mirrored && random.uniform() < 1.0 / 3) return 0;
  const double extent = c.size * log_uniform(random, k_least, c.deepest);
  return random.uniform() < 0.5 ? -extent : extent;
}

/// Returns two bodies of the class at their poses.
inline bodies::Bodies draw_pair(const PairClass& c, RandomStream& random) {
  using oracle::Solid;
  const Vec3 origin = c.offset * Vec3(1, -1, 0.5);
  bodies::Bodies bodies;
  for (const MakeShape& make : {c.a, c.b})
    detect::add_body(bodies, make(random), origin, attitude_of(c.meeting, random));
  const double gap = draw_gap(c, random);
  const auto own = [&](int b) { return oracle::posed(bodies.shape[b]->parts[0], Mat3::Identity(), Vec3::Zero()); };
  switch (c.meeting) {
    case Meeting::faces:
      lay_against(bodies, of_face(own(0), random), of_face(own(1), random), gap, random);
      break;
    case Meeting::edges:
      lay_against(bodies, of_edge(own(0), random), of_edge(own(1), random), gap, random);
      break;
    case Meeting::vertex_on_face:
      if (random.uniform() < 0.5)
        lay_against(bodies, of_face(own(0), random), of_vertex(own(1), random), gap, random);
      else
        lay_against(bodies, of_vertex(own(0), random), of_face(own(1), random), gap, random);
      break;
    case Meeting::mirrored:
      stand_mirrored(bodies, gap, random);
      break;
    case Meeting::same_place:
      bodies.shape[1] = bodies.shape[0];
      bodies.set_pose(1, bodies.p_GB[0], bodies.q_GB[0]);
      break;
    default:
      come_from_a_side(c, bodies, gap, random);
  }
  return bodies;
}

}  // namespace nilas::pairs
