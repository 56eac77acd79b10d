#pragma once
/// Contact problems for tests: rigid bodies, random heaps, columns, rafts of floes.
#include <cmath>
#include <cstdint>
#include <vector>

#include "contact/problem.h"
#include "core/base/random.h"

namespace nilas::test {

/// A free rigid body of a hand-built problem.
struct TestBody {
  double mass = 1;
  Mat3 inertia = Mat3::Identity();  ///< in G, about the centre of mass
  Vec3 p = Vec3::Zero();            ///< centre of mass
  Vec3 v = Vec3::Zero();            ///< free velocities, before contact
  Vec3 w = Vec3::Zero();
};

inline Mat6 mass_matrix(const TestBody& body) {
  Mat6 m = Mat6::Zero();
  m.diagonal().head<3>().setConstant(body.mass);
  m.bottomRightCorner<3, 3>() = body.inertia;
  return m;
}

/// Adds the block and its free momentum.
inline int add_body(ContactProblem& problem, const TestBody& body) {
  const int block = problem.add_block(mass_matrix(body));
  Vec6 twist;
  twist << body.v, body.w;
  problem.f.tail<6>() = mass_matrix(body) * twist;
  return block;
}

/// A frame with the given unit normal; `turn` rotates the tangents [rad].
inline Mat3 frame_of(const Vec3& n, double turn = 0) {
  const Vec3 axis = std::abs(n.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
  const Vec3 t1 = (axis - axis.dot(n) * n).normalized();
  const Vec3 t2 = n.cross(t1);
  Mat3 frame;
  frame << n, std::cos(turn) * t1 + std::sin(turn) * t2, std::cos(turn) * t2 - std::sin(turn) * t1;
  return frame;
}

/// Rows of u = +-C^T (v + w x (point - p)).
inline MatX body_rows(const Mat3& frame, const Vec3& point, const Vec3& p, double sign) {
  MatX rows(3, 6);
  rows << sign * frame.transpose(), -sign * frame.transpose() * skew(point - p);
  return rows;
}

/// A contact between bodies a and b (-1: fixed), both listed in `bodies` with their block equal to their index.
inline int add_contact(ContactProblem& problem, const std::vector<TestBody>& bodies, int a, int b, const Vec3& point,
                       const Mat3& frame, double mu) {
  const auto rows = [&](int body, double sign) -> MatX {
    if (body < 0) return MatX(3, 0);
    return body_rows(frame, point, bodies[static_cast<std::size_t>(body)].p, sign);
  };
  const int c =
      problem.add_contact(a, rows(a, -1), b, rows(b, 1), static_cast<std::uint64_t>(problem.pairs.size()) + 1);
  problem.mu.back() = mu;
  problem.mu_static.back() = mu;
  return c;
}

inline Vec3 random_vector(RandomStream& random) {
  const double x = random.normal(), y = random.normal(), z = random.normal();
  return {x, y, z};
}

/// Bodies of unlike mass and inertia thrown at each other and at the ground with random points and normals.
inline ContactProblem random_heap(std::uint64_t seed, int body_count, int contact_count, double mu) {
  RandomStream random(seed, "heap");
  ContactProblem problem;
  problem.h = 0.01;
  std::vector<TestBody> bodies;
  for (int k = 0; k < body_count; ++k) {
    TestBody body;
    body.mass = std::exp(random.normal());
    const Vec3 moments(random.uniform(0.5, 1.5), random.uniform(0.5, 1.5), random.uniform(0.5, 1.5));
    const Mat3 axes = Quat(random.normal(), random.normal(), random.normal(), random.normal()).normalized().matrix();
    body.inertia = body.mass * axes * moments.asDiagonal() * axes.transpose();
    body.inertia = 0.5 * (body.inertia + body.inertia.transpose().eval());
    body.p = 2 * random_vector(random);
    body.v = random_vector(random);
    body.w = random_vector(random);
    bodies.push_back(body);
    add_body(problem, body);
  }
  for (int c = 0; c < contact_count; ++c) {
    const int a = static_cast<int>(random.bits() % static_cast<std::uint64_t>(body_count + 1)) - 1;
    int b = static_cast<int>(random.bits() % static_cast<std::uint64_t>(body_count));
    if (b == a) b = (b + 1) % body_count;
    const Vec3 middle = bodies[static_cast<std::size_t>(b)].p + 0.7 * random_vector(random);
    add_contact(problem, bodies, a, b, middle, frame_of(random_vector(random).normalized(), random.uniform(0, k_pi)),
                mu);
  }
  return problem;
}

/// Masses from the ground up, one frictionless contact between neighbours, falling for one step under g.
inline ContactProblem column(const std::vector<double>& masses, double h, double g) {
  ContactProblem problem;
  problem.h = h;
  problem.law = Law::frictionless;
  std::vector<TestBody> bodies;
  for (std::size_t k = 0; k < masses.size(); ++k) {
    TestBody body{masses[k], masses[k] * Mat3::Identity(), Vec3(0, 0, static_cast<double>(k) + 0.5)};
    body.v.z() = -h * g;
    bodies.push_back(body);
    add_body(problem, body);
  }
  for (std::size_t k = 0; k < masses.size(); ++k)
    add_contact(problem, bodies, static_cast<int>(k) - 1, static_cast<int>(k), Vec3(0, 0, static_cast<double>(k)),
                frame_of(Vec3::UnitZ()), 0);
  return problem;
}

/// side x side square floes of 1 m with two contact points per shared edge, moving at random; every row of floes ends
/// at a fixed wall. `closed`: share of the pairs that touch, the others have a gap that the step cannot close.
inline ContactProblem raft(int side, double mu, double closed, std::uint64_t seed) {
  constexpr double thickness = 0.1, density = 900, reach = 0.35;
  RandomStream random(seed, "raft");
  ContactProblem problem;
  problem.h = 0.01;
  std::vector<TestBody> bodies;
  for (int k = 0; k < side * side; ++k) {
    TestBody body;
    body.mass = density * thickness;
    body.inertia = Vec3(body.mass / 12, body.mass / 12, body.mass / 6).asDiagonal();
    body.p = Vec3(k % side, k / side, 0);
    body.v = 0.3 * random_vector(random);
    body.w = 0.1 * random_vector(random);
    bodies.push_back(body);
    add_body(problem, body);
  }
  const auto touch = [&](int a, int b, const Vec3& middle, const Vec3& n) {
    const double gap_speed = random.uniform() < closed ? 0 : 100;
    const Vec3 along = reach * Vec3(-n.y(), n.x(), 0);
    for (const double s : {-1.0, 1.0}) {
      const int c = add_contact(problem, bodies, a, b, middle + s * along, frame_of(n), mu);
      problem.w[3 * c] = gap_speed;
    }
  };
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const int k = j * side + i;
      const Vec3 p = bodies[static_cast<std::size_t>(k)].p;
      touch(i == 0 ? -1 : k - 1, k, p - Vec3(0.5, 0, 0), Vec3::UnitX());
      if (j > 0) touch(k - side, k, p - Vec3(0, 0.5, 0), Vec3::UnitY());
    }
  return problem;
}

}  // namespace nilas::test
