#pragma once
/// Pairs of plates on random paths through a step, and their true first contact by marching and bisection on brute
/// force. Shares no code with contact/detect.
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/random.h"
#include "core/bodies/bodies.h"
#include "tests/support/collision/sat_oracle.h"
#include "tests/support/random_vectors.h"

namespace nilas::oracle {

/// The path of a body over a step: a straight displacement and an even turn about one axis, from its initial pose.
struct Way {
  Vec3 p = Vec3::Zero();
  Quat q = Quat::Identity();
  Vec3 way = Vec3::Zero();   ///< Displacement over the step [m].
  Vec3 turn = Vec3::Zero();  ///< Rotation vector of the step [rad].

  Solid at(const geometry::ConvexPolytope& polytope, double t) const {
    const double angle = t * turn.norm();
    const Quat turned = angle > 0 ? Quat(Eigen::AngleAxisd(angle, turn.normalized())) : Quat::Identity();
    return posed(polytope, (turned * q).toRotationMatrix(), p + t * way);
  }
};

/// Largest separation over all faces and pairs of edges. When positive, it is the distance or a lower bound of it.
inline double separation(const Solid& a, const Solid& b) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec3& n : a.normals) most = std::max(most, separation(a, b, n));
  for (const Vec3& n : b.normals) most = std::max(most, separation(a, b, -n));
  for (const auto& [i, j] : a.edges)
    for (const auto& [k, l] : b.edges) {
      const Vec3 n = (a.vertices[j] - a.vertices[i]).cross(b.vertices[l] - b.vertices[k]);
      constexpr double k_parallel = 1e-9;
      if (n.norm() < k_parallel) continue;
      const Vec3 unit = n.normalized();
      most = std::max({most, separation(a, b, unit), separation(a, b, -unit)});
    }
  return most;
}

struct PairOnItsWay {
  geometry::ConvexPolytope a, b;
  Way way_a, way_b;

  double separation_at(double t) const { return separation(way_a.at(a, t), way_b.at(b, t)); }
  double size() const { return std::min(a.radius, b.radius); }
  double thickness() const { return std::min(a.smallest_width, b.smallest_width); }
  double largest_speed() const {
    return (way_b.way - way_a.way).norm() + way_a.turn.norm() * a.radius + way_b.turn.norm() * b.radius;
  }
};

struct FirstContact {
  double t = 1;  ///< Time of the contact as a share of the step, when there is one.
  double least_separation = std::numeric_limits<double>::infinity();  ///< Least separation met, when there is none [m].
  bool hit = false;
  bool certain_miss = false;  ///< Every separation met is larger than the distance that the shortest march can close.
};

/// Marches by the time that the separation allows, at least by a share of the thickness over the speed, then bisects.
inline FirstContact first_contact(const PairOnItsWay& pair) {
  const double speed = pair.largest_speed();
  const double blind = 0.01 * pair.thickness(), least = blind / speed;
  FirstContact out;
  double before = 0;
  for (double t = 0;;) {
    const double s = pair.separation_at(t);
    out.least_separation = std::min(out.least_separation, s);
    if (s <= 0) {
      double apart = before, together = t;
      constexpr double k_exact = 1e-11;
      while (together - apart > k_exact) {
        const double middle = 0.5 * (apart + together);
        (pair.separation_at(middle) > 0 ? apart : together) = middle;
      }
      out.hit = true;
      out.t = together;
      return out;
    }
    if (t >= 1) {
      out.certain_miss = out.least_separation > blind;
      return out;
    }
    before = t;
    t = std::min(1.0, t + std::max(s / speed, least));
  }
}

/// Plates of 4 to 8 corners. The width of the first is `slenderness` times its thickness; the second has a slenderness
/// between a third of that and that.
struct PairClass {
  const char* name;
  double slenderness;
  double way;   ///< Relative displacement over the thickness of the thinner plate.
  double turn;  ///< Largest turn of each plate [rad].
};

inline geometry::ConvexPolytope random_plate(RandomStream& random, double slenderness) {
  const int corners = 4 + static_cast<int>(random.uniform(0, 5));
  const double size = 0.5 * std::exp(random.uniform(0, 1));
  std::vector<Vec2> outline;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * k_pi * (k + random.uniform(-0.3, 0.3)) / corners;
    outline.emplace_back(size * std::cos(angle), size * std::sin(angle));
  }
  const double half = size / slenderness;
  return geometry::make_prism(outline, -half, half);
}

inline Vec3 random_direction(RandomStream& random) {
  return Vec3(random.normal(), random.normal(), random.normal()).normalized();
}

/// Two plates that overlap at a random instant of the step: a point of both coincides then. They need not be apart at
/// the start.
inline PairOnItsWay crossing_pair(const PairClass& c, RandomStream& random) {
  PairOnItsWay pair{
      random_plate(random, c.slenderness), random_plate(random, random.uniform(1, 3) * c.slenderness / 3), {}, {}};
  const double when = random.uniform(0.05, 0.95);
  Vec3 meet[2];
  int k = 0;
  for (auto [polytope, way] : {std::pair{&pair.a, &pair.way_a}, {&pair.b, &pair.way_b}}) {
    const Quat there = test::random_attitude(random);
    way->turn = random.uniform(0, c.turn) * random_direction(random);
    const double angle = when * way->turn.norm();
    const Quat turned = angle > 0 ? Quat(Eigen::AngleAxisd(angle, way->turn.normalized())) : Quat::Identity();
    way->q = turned.conjugate() * there;
    // The common point lies well inside each plate; its position in G at that instant is relative to the body's origin.
    const Vec3& corner =
        polytope->vertices[static_cast<std::size_t>(random.uniform(0, static_cast<double>(polytope->vertices.size())))];
    const Vec3 inside(0.6 * random.uniform() * corner.x(), 0.6 * random.uniform() * corner.y(), 0);
    meet[k++] = there * inside;
  }
  const double length = c.way * pair.thickness();
  pair.way_b.way = length * random_direction(random);
  if (random.uniform() < 0.5) {  // In half of the pairs both bodies move.
    pair.way_a.way = random.uniform() * length * random_direction(random);
    pair.way_b.way += pair.way_a.way;
  }
  pair.way_a.p = -when * pair.way_a.way - meet[0];
  pair.way_b.p = -when * pair.way_b.way - meet[1];
  return pair;
}

/// A crossing pair, displaced so that most such pairs pass each other.
inline PairOnItsWay passing_pair(const PairClass& c, RandomStream& random) {
  PairOnItsWay pair = crossing_pair(c, random);
  pair.way_b.p += random.uniform(0.2, 1.5) * (pair.a.radius + pair.b.radius) * random_direction(random);
  return pair;
}

/// The cases of the tests and of the bench. Straight and turning plates move by 100 thicknesses of the thinner plate
/// per step.
inline std::vector<PairClass> pair_classes() {
  return {{"plates 1:100, straight", 100, 100, 0},
          {"plates 1:100, turning to 1 rad", 100, 100, 1},
          {"plates 1:100, turning to 3 rad", 100, 100, 3},
          {"plates 1:100, turning in place", 100, 1, 3},
          {"blocks 1:3, turning to 1 rad", 3, 3, 1}};
}

}  // namespace nilas::oracle
