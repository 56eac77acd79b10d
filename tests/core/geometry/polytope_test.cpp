#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/machine.h"
#include "core/geometry/shape.h"
#include "tests/core/bodies/solids.h"
#include "tests/support/about_centroid.h"
#include "tests/support/random_vectors.h"
#include "tests/support/refusal.h"

namespace nilas::geometry {
namespace polytope_test {

/// Sum over faces of offset times area / 3.
double volume(const ConvexPolytope& p) {
  double sum = 0;
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    Vec3 twice_area = Vec3::Zero();
    for (std::size_t i = 0; i < p.faces[f].size(); ++i)
      twice_area += p.vertices[p.faces[f][i]].cross(p.vertices[p.faces[f][(i + 1) % p.faces[f].size()]]);
    sum += p.offsets[f] * p.normals[f].dot(twice_area) / 6;
  }
  return sum;
}

/// Checks Euler's formula, planes, adjacency in both directions, and that no vertex is outside a face by more than
/// `tolerance`.
void expect_consistent(const ConvexPolytope& p, double tolerance) {
  std::size_t corners = 0, joined = 0;
  for (const auto& loop : p.faces) corners += loop.size();
  for (const auto& neighbours : p.vertex_neighbours) joined += neighbours.size();
  EXPECT_EQ(joined, corners);  // each edge twice
  EXPECT_EQ(p.vertices.size() + p.faces.size(), corners / 2 + 2);
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    EXPECT_NEAR(p.normals[f].norm(), 1, 1e-14);
    for (const int v : p.faces[f]) {
      EXPECT_NEAR(p.normals[f].dot(p.vertices[v]), p.offsets[f], tolerance);
      EXPECT_EQ(std::count(p.vertex_faces[v].begin(), p.vertex_faces[v].end(), static_cast<int>(f)), 1);
    }
    EXPECT_LT(p.normals[f].dot(p.centre), p.offsets[f]);
    double highest = -1e300;
    for (const auto& x : p.vertices) highest = std::max(highest, p.normals[f].dot(x) - p.offsets[f]);
    EXPECT_LE(highest, tolerance);
  }
}

TEST(Polytope, BoxHasKnownFaces) {
  const ConvexPolytope p = make_box({2, 3, 0.5});
  expect_consistent(p, 0);
  EXPECT_EQ(p.vertices.size(), 8u);
  EXPECT_EQ(p.faces.size(), 6u);
  EXPECT_EQ(p.normals[0], Vec3(0, 0, -1));
  EXPECT_EQ(p.normals[1], Vec3(0, 0, 1));
  EXPECT_EQ(p.normals[2], Vec3(0, -1, 0));
  EXPECT_EQ(p.offsets[3], 1);
  EXPECT_EQ(p.smallest_width, 0.5);
  EXPECT_DOUBLE_EQ(p.radius, 0.5 * Vec3(2, 3, 0.5).norm());
  EXPECT_EQ(p.centre, Vec3(0, 0, 0));
  for (const auto& neighbours : p.vertex_neighbours) EXPECT_EQ(neighbours.size(), 3u);
  EXPECT_DOUBLE_EQ(volume(p), 3);
}

TEST(Polytope, PrismFollowsTheStatedOrder) {
  const std::vector<Vec2> outline{{0, 0}, {2, 0}, {2, 1}, {0.5, 2}, {-0.5, 1}};
  const ConvexPolytope p = make_prism(outline, -0.2, 0.6);
  expect_consistent(p, 1e-15);
  ASSERT_EQ(p.faces.size(), 7u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(p.vertices[i], Vec3(outline[i].x(), outline[i].y(), -0.2));
    EXPECT_EQ(p.vertices[5 + i].z(), 0.6);
    const Vec2 edge = outline[(i + 1) % 5] - outline[i];
    EXPECT_NEAR((p.normals[2 + i] - Vec3(edge.y(), -edge.x(), 0).normalized()).norm(), 0, 1e-15);
  }
  EXPECT_NEAR(volume(p), 0.8 * polygon_moments(outline).area, 1e-14);
}

TEST(Polytope, DegeneratePrismsBreakTheContract) {
  EXPECT_THROW(make_prism({{0, 0}, {1, 0}, {0, 1}}, 1, 1), ContractError);
  EXPECT_THROW(make_prism({{0, 0}, {1, 0}}, 0, 1), ContractError);
}

/// A box cut into 3072 triangles, turned and rounded to float32 as a file stores it, is a box again: 6 faces, 8
/// corners.
TEST(MakePolytope, FineTrianglesOfABoxMergeToSixFaces) {
  TriangleMesh mesh = box_shape({4, 1.5, 0.7}).surface;
  for (int level = 0; level < 4; ++level) mesh = bodies::subdivided(mesh);
  ASSERT_EQ(mesh.triangles.size(), 3072u);
  RandomStream random(1, "attitudes");
  for (int i = 0; i < 20; ++i) {
    const Vec3 shift(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2));
    const TriangleMesh placed = bodies::moved(mesh, test::random_attitude(random).toRotationMatrix(), shift);
    const ConvexPolytope p = make_polytope(rounded_to_float(placed), 4e-5);
    EXPECT_EQ(p.faces.size(), 6u);
    EXPECT_EQ(p.vertices.size(), 8u);
    expect_consistent(p, 1e-6);
    EXPECT_NEAR(volume(p), 4 * 1.5 * 0.7, 2e-6);
    EXPECT_NEAR(p.smallest_width, 0.7, 1e-6);
  }
}

TEST(MakePolytope, ManySidedPrismsMergeToo) {
  RandomStream random(6, "attitudes");
  std::vector<Vec2> outline;
  for (int i = 0; i < 40; ++i) outline.emplace_back(1.2 * std::cos(k_pi * i / 20), 0.8 * std::sin(k_pi * i / 20));
  TriangleMesh mesh = prism_shape(outline, 0.5).surface;
  for (int level = 0; level < 2; ++level) mesh = bodies::subdivided(mesh);
  for (int i = 0; i < 10; ++i) {
    const TriangleMesh placed = bodies::moved(mesh, test::random_attitude(random).toRotationMatrix(), {0.3, -0.2, 0.5});
    const ConvexPolytope p = make_polytope(rounded_to_float(placed), 2e-5);
    EXPECT_EQ(p.faces.size(), 42u);
    EXPECT_EQ(p.vertices.size(), 80u);
    expect_consistent(p, 2e-5);
    EXPECT_NEAR(volume(p), 0.5 * polygon_moments(outline).area, 1e-6);
  }
}

/// Faces of a smooth hull stay triangles: 8192 of them, quick enough to build at the start of a run.
TEST(MakePolytope, SphereKeepsItsTriangles) {
  const TriangleMesh mesh = rounded_to_float(bodies::sphere_mesh(1.5, 5));
  ASSERT_EQ(mesh.triangles.size(), 8192u);
  const double start = processor_seconds();
  const ConvexPolytope p = make_polytope(mesh, 2e-5);
  EXPECT_LT(processor_seconds() - start, 3);
  EXPECT_EQ(p.faces.size(), 8192u);
  EXPECT_EQ(p.vertices.size(), mesh.vertices.size());
  expect_consistent(p, 2e-5);
  EXPECT_NEAR(volume(p), signed_volume(mesh), 1e-9);
}

/// Where the mesh is finer than the tolerance can tell from flat, whatever merges must stay convex and keep the volume.
TEST(MakePolytope, CoarseTolerancesKeepTheVolume) {
  for (const double tolerance : {1e-4, 1e-3, 1e-2}) {
    const TriangleMesh mesh = bodies::sphere_mesh(1, 4);
    const ConvexPolytope p = make_polytope(mesh, tolerance);
    expect_consistent(p, tolerance);
    EXPECT_NEAR(volume(p), signed_volume(mesh), 4 * k_pi * tolerance);
  }
}

/// A sliver next to a sharp edge has no reliable direction of its own; it joins a neighbour.
TEST(MakePolytope, SliversJoinTheirNeighbours) {
  TriangleMesh mesh = box_shape({2, 1, 1}).surface;
  // a vertex just beside the middle of each triangle's first edge, seen from that triangle only
  const std::size_t whole = mesh.triangles.size();
  for (std::size_t t = 0; t < whole; ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    const Vec3 middle = 0.5 * (mesh.vertices[a] + mesh.vertices[b]);
    const int fresh = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(middle + 1e-9 * (mesh.vertices[c] - middle));
    mesh.triangles[t] = {a, fresh, c};
    mesh.triangles.push_back({fresh, b, c});
    mesh.triangles.push_back({a, b, fresh});
  }
  RandomStream random(8, "attitudes");
  for (int i = 0; i < 10; ++i) {
    const ConvexPolytope p = make_polytope(
        rounded_to_float(bodies::moved(mesh, test::random_attitude(random).toRotationMatrix(), {1, 1, 1})), 2e-5);
    EXPECT_EQ(p.faces.size(), 6u);
    EXPECT_EQ(p.vertices.size(), 8u);
    EXPECT_NEAR(volume(p), 2, 1e-6);
  }
}

TEST(MakePolytope, ConcaveSurfacesAreRefused) {
  const TriangleMesh l = prism_shape(test::about_centroid(bodies::l_outline()), 0.5).surface;
  test::expect_refusal([&] { make_polytope(l, 1e-5); }, {"not convex"});
}

/// A hollow of 1 mm spread over many fine triangles bends by less than the tolerance at every single edge.
TEST(MakePolytope, AGentleHollowInAFineMeshIsRefused) {
  TriangleMesh mesh = box_shape({1, 1, 1}).surface;
  for (int level = 0; level < 5; ++level) mesh = bodies::subdivided(mesh);
  const TriangleMesh flat = mesh;
  for (auto& p : mesh.vertices)
    if (p.z() == 0.5) p.z() -= 1e-3 * std::pow(std::cos(k_pi * p.x()) * std::cos(k_pi * p.y()), 2);
  EXPECT_EQ(make_polytope(flat, 2e-4).faces.size(), 6u);
  EXPECT_THROW(make_polytope(mesh, 2e-4), InputError);
}

TEST(MakePolytope, UnsoundSurfacesAreRefused) {
  TriangleMesh open = bodies::octahedron(), inward = bodies::octahedron();
  open.triangles.pop_back();
  for (auto& t : inward.triangles) std::swap(t[0], t[1]);
  EXPECT_THROW(make_polytope(open, 1e-6), InputError);
  EXPECT_THROW(make_polytope(inward, 1e-6), InputError);
  EXPECT_THROW(make_polytope({}, 1e-6), InputError);
}

TEST(MakePolytope, AWeldedTriangleWithoutEdgesIsLeftOut) {
  TriangleMesh mesh = bodies::octahedron();
  mesh.triangles.push_back({1, 1, 2});
  EXPECT_EQ(make_polytope(mesh, 1e-6).faces.size(), 8u);
}

}  // namespace polytope_test
}  // namespace nilas::geometry
