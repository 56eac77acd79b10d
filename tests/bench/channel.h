#pragma once
/// A contact problem of any size for the benches: a heavy vessel driven into a channel of floes.
///
/// Floes of 1e2 to 1e6 kg stand in rows across the channel, with two contact points to each neighbour and to the walls.
/// Three pairs of ten touch. The others have a gap of up to 0.2 m, twice the distance that the hull closes in the step.
/// A hull of 1e7 kg at 2 m/s leans on the whole first row.
#include <cmath>
#include <vector>

#include "tests/support/problems/problem_factory.h"

namespace nilas::bench {

constexpr double k_step = 0.05, k_friction = 0.3, k_hull_mass = 1e7, k_hull_speed = 2, k_touching = 0.3;
constexpr double k_largest_gap = 0.2;  // [m]
constexpr int k_length_over_width = 2;
constexpr double k_reach = 0.35;  ///< Distance of a pair's points from the middle of their side [floe sizes].

/// Rows and columns of square floes of 1 m, from the hull on. Block 0 is the hull.
inline contact::ContactProblem channel(int size) {
  const int columns = std::max(2, static_cast<int>(std::sqrt(size / 4.0 / k_length_over_width)));
  const int rows = std::max(2, size / (4 * columns));
  RandomStream random(7, "channel");
  contact::ContactProblem problem;
  problem.h = k_step;
  std::vector<test::TestBody> bodies;
  const auto add = [&](double mass, const Vec3& p, const Vec3& v, double radius) {
    test::TestBody body;
    body.mass = mass;
    body.inertia = mass * radius * radius / 6 * Vec3(1, 1, 2).asDiagonal();
    body.p = p;
    body.v = v;
    bodies.push_back(body);
    test::add_body(problem, body);
  };
  add(k_hull_mass, Vec3(-1, 0.5 * columns, 0), Vec3(k_hull_speed, 0, 0), columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      add(std::pow(10.0, random.uniform(2, 6)), Vec3(i, j, 0), 0.05 * test::random_vector(random), 1);
  const auto touch = [&](int a, int b, const Vec3& middle, const Vec3& n) {
    const double gap = random.uniform() < k_touching ? 0 : random.uniform(0, k_largest_gap);
    const Vec3 along(-k_reach * n.y(), k_reach * n.x(), 0);
    for (const double side : {-1.0, 1.0}) {
      const int c = test::add_contact(problem, bodies, a, b, middle + side * along, test::frame_of(n), k_friction);
      problem.w[3 * c] = gap / k_step;
    }
  };
  const auto floe = [&](int i, int j) { return 1 + i * columns + j; };
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const Vec3 p(i, j, 0);
      touch(i == 0 ? 0 : floe(i - 1, j), floe(i, j), p - Vec3(0.5, 0, 0), Vec3::UnitX());
      touch(j == 0 ? -1 : floe(i, j - 1), floe(i, j), p - Vec3(0, 0.5, 0), Vec3::UnitY());
      if (j + 1 == columns) touch(floe(i, j), -1, p + Vec3(0, 0.5, 0), Vec3::UnitY());
    }
  return problem;
}

}  // namespace nilas::bench
