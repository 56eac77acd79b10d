/// Tests of convex pieces with many small facets, as those of hulls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "contact/detect/detector.h"
#include "tests/contact/detect/bodies_of_tests.h"
#include "tests/support/collision/distance_oracle.h"
#include "tests/support/random_vectors.h"

namespace nilas::detect {
namespace hull_test {

/// A sphere of facets stretched to an ellipsoid. Each triangle of an icosahedron is split in four `levels` times.
geometry::TriangleMesh ellipsoid(int levels, const Vec3& half_axes) {
  const double g = 0.5 * (1 + std::sqrt(5.0));
  geometry::TriangleMesh mesh;
  for (double s : {-1.0, 1.0})
    for (double t : {-1.0, 1.0})
      for (int axis = 0; axis < 3; ++axis) {
        Vec3 v;
        v[axis] = 0;
        v[(axis + 1) % 3] = s;
        v[(axis + 2) % 3] = t * g;
        mesh.vertices.push_back(v.normalized());
      }
  const double side = 2 / std::sqrt(1 + g * g);
  const int count = static_cast<int>(mesh.vertices.size());
  const auto joined = [&](int i, int j) {
    return std::abs((mesh.vertices[i] - mesh.vertices[j]).norm() - side) < 1e-9;
  };
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j)
      for (int k = j + 1; k < count; ++k) {
        if (!joined(i, j) || !joined(j, k) || !joined(i, k)) continue;
        const bool outward = mesh.vertices[i].dot(mesh.vertices[j].cross(mesh.vertices[k])) > 0;
        mesh.triangles.push_back({i, outward ? j : k, outward ? k : j});
      }
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middle;
    const auto between = [&](int i, int j) {
      const auto key = std::minmax(i, j);
      if (!middle.count(key)) {
        middle[key] = static_cast<int>(mesh.vertices.size());
        mesh.vertices.push_back((mesh.vertices[i] + mesh.vertices[j]).normalized());
      }
      return middle[key];
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [i, j, k] : mesh.triangles) {
      const int a = between(i, j), b = between(j, k), c = between(k, i);
      for (const std::array<int, 3>& t :
           {std::array{i, a, c}, std::array{a, j, b}, std::array{c, b, k}, std::array{a, b, c}})
        finer.push_back(t);
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3& v : mesh.vertices) v = v.cwiseProduct(half_axes);
  return mesh;
}

geometry::Shape hull_shape(int levels, const Vec3& half_axes) {
  const geometry::TriangleMesh mesh = ellipsoid(levels, half_axes);
  return geometry::mesh_shape(mesh, {geometry::make_polytope(mesh, 1e-9)});
}

/// Moves body 1 along d until the best of all face and edge axes separates by `target`.
double slide_to(bodies::Bodies& bodies, const Vec3& d, double target) {
  const auto axes = oracle::all_axes(oracle::posed(bodies, 0), oracle::posed(bodies, 1));
  double way = std::numeric_limits<double>::infinity();
  for (const auto& axis : axes)
    if (axis.n.dot(d) > 1e-6) way = std::min(way, (target - axis.s) / axis.n.dot(d));
  bodies.set_pose(1, bodies.p_GB[1] + way * d, bodies.q_GB[1]);
  double best = -std::numeric_limits<double>::infinity();
  for (const auto& axis : axes) best = std::max(best, axis.s + way * axis.n.dot(d));
  return best > 0 ? oracle::distance(oracle::posed(bodies, 0), oracle::posed(bodies, 1)) : best;
}

TEST(HullContacts, MatchBruteForce) {
  const geometry::Shape hull = hull_shape(2, {6, 1, 0.8});
  ASSERT_GT(hull.parts[0].faces.size(), 300u);
  RandomStream random(2, "hull");
  double worst = 0;
  for (int k = 0; k < 120; ++k) {
    bodies::Bodies bodies;
    add_body(bodies, hull, {0, 0, 0}, random_tilt(random, 0.05), bodies::Motion::articulated);
    add_body(bodies, floe_shape(random_outline(random, 0.5), 0.1), {0, 0, 0}, random_tilt(random, 0.05));
    const Vec3 d = Vec3(random.normal(), random.normal(), 0.2 * random.normal()).normalized();
    const double truth = slide_to(bodies, d, random.uniform(-4e-3, 4e-3));
    const auto points = ContactDetector().detect(bodies, 0.05);
    ASSERT_FALSE(points.empty());
    double gap = 1;
    for (const ContactPoint& c : points) gap = std::min(gap, c.gap);
    worst = std::max(worst, std::abs(gap - truth));
  }
  EXPECT_LT(worst, 1e-9);
}

TEST(HullContacts, TwoHullsMatchBruteForce) {
  const geometry::Shape hull = hull_shape(2, {6, 1, 0.8});
  RandomStream random(3, "hulls");
  double worst = 0;
  for (int k = 0; k < 8; ++k) {
    bodies::Bodies bodies;
    add_body(bodies, hull, {0, 0, 0}, test::random_attitude(random), bodies::Motion::articulated);
    add_body(bodies, hull, {0, 0, 0}, test::random_attitude(random));
    const Vec3 d = Vec3(random.normal(), random.normal(), random.normal()).normalized();
    const double truth = slide_to(bodies, d, random.uniform(-4e-3, 4e-3));
    const auto points = ContactDetector().detect(bodies, 0.05);
    ASSERT_FALSE(points.empty());
    double gap = 1;
    for (const ContactPoint& c : points) gap = std::min(gap, c.gap);
    worst = std::max(worst, std::abs(gap - truth));
  }
  EXPECT_LT(worst, 1e-9);
}

TEST(HullContacts, AFloeThatSlidesOverSeamsKeepsItsContact) {
  // Neighbouring stations amidships differ by 0.8 degrees.
  const geometry::Shape hull = hull_shape(4, {60, 10, 8});
  bodies::Bodies bodies;
  add_body(bodies, hull, {0, 0, 0}, Quat::Identity(), bodies::Motion::articulated);
  add_body(bodies, geometry::box_shape({3, 3, 0.5}), {0, 0, 0});
  ContactDetector detector;
  double last_gap = 0;
  Vec3 last_n = Vec3::Zero();
  double worst_gap = 0, worst_turn = 0;
  const int steps = 400;
  for (int k = 0; k < steps; ++k) {
    const double x = -4 + 8.0 * k / steps;
    bodies.set_pose(1, {x, 1.49 + 10 * std::sqrt(1 - x * x / 3600), 0.1}, Quat::Identity());
    const auto points = detector.detect(bodies, 0.1);
    ASSERT_FALSE(points.empty()) << k;
    const ContactPoint& deepest = *std::min_element(
        points.begin(), points.end(), [](const ContactPoint& p, const ContactPoint& q) { return p.gap < q.gap; });
    if (k > 0) {
      worst_gap = std::max(worst_gap, std::abs(deepest.gap - last_gap));
      worst_turn = std::max(worst_turn, std::acos(std::min(1.0, deepest.n.dot(last_n))));
    }
    last_gap = deepest.gap;
    last_n = deepest.n;
  }
  // A step is 2 cm along facets that follow the curve: the gap changes by the sagitta, the normal by a facet's turn.
  EXPECT_LT(worst_gap, 2e-4);
  EXPECT_LT(worst_turn, 1 * k_deg);
}

TEST(HullContacts, APointsNormalIsTheGradientOfItsGapOnACurvedSide) {
  // Facets turn by 0.8 degrees; the side turns by 10 degrees along a floe of 1.5 m.
  const geometry::Shape hull = hull_shape(4, {60, 10, 8});
  RandomStream random(5, "gradient");
  double worst = 0, farthest_normals = 0;
  int compared = 0;
  for (int k = 0; k < 40; ++k) {
    bodies::Bodies bodies;
    add_body(bodies, hull, {0, 0, 0}, Quat::Identity(), bodies::Motion::articulated);
    const double z = random.uniform(-4, 4);
    const double x = random.uniform(-6, 6), y = 10 * std::sqrt(1 - x * x / 3600 - z * z / 64);
    const Vec3 out = Vec3(x / 3600, y / 100, z / 64).normalized();
    const Quat upright = Quat::FromTwoVectors(Vec3::UnitY(), out);
    const Quat tilted = upright * Quat(Eigen::AngleAxisd(random.uniform(-0.1, 0.1), Vec3::UnitX()));
    add_body(bodies, geometry::box_shape({3, 1, 0.4}), Vec3(x, y, z) + 0.505 * out, tilted);
    ContactDetector detector;
    const auto before = detector.detect(bodies, 0.03);
    const Vec3 way = 1e-3 * Vec3(random.normal(), random.normal(), random.normal()).normalized();
    bodies.set_pose(1, bodies.p_GB[1] + way, bodies.q_GB[1]);
    const auto after = detector.detect(bodies, 0.03);
    for (const ContactPoint& p : before)
      for (const ContactPoint& q : after) {
        farthest_normals = std::max(farthest_normals, (p.n - before[0].n).norm());
        if (p.key != q.key) continue;
        worst = std::max(worst, std::abs(q.gap - p.gap - p.n.dot(way)) / way.norm());
        ++compared;
      }
  }
  EXPECT_GT(compared, 50);
  EXPECT_GT(farthest_normals, 2 * k_deg);
  EXPECT_LT(worst, 1.5 * k_deg);
}

TEST(HullContacts, FlatPlatingOfManyTrianglesTouchesAsOneFace) {
  // A box whose sides are cut into many triangles that lie in one plane.
  geometry::TriangleMesh mesh;
  const int n = 6;
  const auto index = [&](const Vec3& v) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      if ((mesh.vertices[i] - v).norm() < 1e-9) return static_cast<int>(i);
    mesh.vertices.push_back(v);
    return static_cast<int>(mesh.vertices.size()) - 1;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (double sign : {-1.0, 1.0})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int di, int dj) {
            Vec3 v;
            v[axis] = sign;
            v[(axis + 1) % 3] = -1 + 2.0 * (i + di) / n;
            v[(axis + 2) % 3] = sign * (-1 + 2.0 * (j + dj) / n);
            return index(v.cwiseProduct(Vec3(5, 1, 1)));
          };
          mesh.triangles.push_back({corner(0, 0), corner(1, 0), corner(1, 1)});
          mesh.triangles.push_back({corner(0, 0), corner(1, 1), corner(0, 1)});
        }
  bodies::Bodies bodies;
  add_body(bodies, geometry::mesh_shape(mesh, {geometry::make_polytope(mesh, 1e-9)}), {0, 0, 0}, Quat::Identity(),
           bodies::Motion::articulated);
  ASSERT_EQ(bodies.shape[0]->parts[0].faces.size(), 6u);
  add_body(bodies, geometry::box_shape({3, 1, 0.4}), {0.3, 1.502, 0.1});
  const auto points = ContactDetector().detect(bodies, 0.01);
  ASSERT_EQ(points.size(), 4u);
  for (const ContactPoint& c : points) {
    EXPECT_NEAR(c.gap, 0.002, 1e-13);
    EXPECT_NEAR(std::abs(c.p.x() - 0.3), 1.5, 1e-12);
    EXPECT_NEAR(std::abs(c.p.z() - 0.1), 0.2, 1e-12);
  }
}

}  // namespace hull_test
}  // namespace nilas::detect
