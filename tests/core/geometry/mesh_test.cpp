#include "core/geometry/mesh.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/geometry/shape.h"
#include "tests/core/bodies/solids.h"
#include "tests/support/tetrahedron.h"

namespace nilas::geometry {
namespace mesh_test {

TriangleMesh box_mesh() { return box_shape({2, 3, 4}).surface; }

TEST(MeshDefects, ASoundBoxHasNone) {
  const MeshDefects defects = find_defects(box_mesh());
  EXPECT_TRUE(defects.closed());
  EXPECT_TRUE(defects.sound());
  EXPECT_EQ(defects.text(), "closed and outward");
  EXPECT_DOUBLE_EQ(signed_volume(box_mesh()), 24);
}

TEST(MeshDefects, AMissingTriangleLeavesThreeOpenEdges) {
  TriangleMesh mesh = box_mesh();
  const auto gone = mesh.triangles.back();
  mesh.triangles.pop_back();
  const MeshDefects defects = find_defects(mesh);
  EXPECT_EQ(defects.open_edges, 3);
  EXPECT_EQ(defects.non_manifold_edges, 0);
  EXPECT_FALSE(defects.sound());
  EXPECT_EQ(defects.text().rfind("3 open edges; for example at (", 0), 0u) << defects.text();
  // the example is the middle of one of the three
  double nearest = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = mesh.vertices[gone[k]], &b = mesh.vertices[gone[(k + 1) % 3]];
    nearest = std::min(nearest, (0.5 * (a + b) - defects.example).norm());
  }
  EXPECT_EQ(nearest, 0);
}

TEST(MeshDefects, AnInvertedSolidIsClosedButInward) {
  TriangleMesh mesh = box_mesh();
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  const MeshDefects defects = find_defects(mesh);
  EXPECT_TRUE(defects.closed());
  EXPECT_TRUE(defects.inward);
  EXPECT_FALSE(defects.sound());
  EXPECT_NE(defects.text().find("inwards"), std::string::npos);
}

TEST(MeshDefects, OneTurnedTriangleSpoilsItsThreeEdges) {
  TriangleMesh mesh = box_mesh();
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  const MeshDefects defects = find_defects(mesh);
  EXPECT_EQ(defects.open_edges, 0);
  EXPECT_EQ(defects.non_manifold_edges, 3);
  EXPECT_FALSE(defects.closed());
}

/// Two tetrahedra that share one edge: four triangles meet there.
TEST(MeshDefects, AnEdgeOfFourTrianglesIsNotManifold) {
  TriangleMesh mesh = test::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  const TriangleMesh other = test::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1});
  mesh.vertices.push_back(other.vertices[2]);
  mesh.vertices.push_back(other.vertices[3]);
  const std::array<int, 4> renamed{0, 1, 4, 5};
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({renamed[a], renamed[b], renamed[c]});
  const MeshDefects defects = find_defects(mesh);
  EXPECT_EQ(defects.open_edges, 0);
  EXPECT_EQ(defects.non_manifold_edges, 1);
  EXPECT_EQ(defects.example, Vec3(0.5, 0, 0));
}

TEST(MeshDefects, TrianglesWithoutAreaAreCountedAndDoNotOpenTheSurface) {
  TriangleMesh repeated = box_mesh();
  repeated.triangles.push_back({0, 0, 1});
  EXPECT_EQ(find_defects(repeated).degenerate_triangles, 1);
  EXPECT_TRUE(find_defects(repeated).closed());

  // a vertex in the middle of an edge, closed by a flat triangle
  TriangleMesh flat = test::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  flat.vertices.emplace_back(0.5, 0, 0);
  for (std::size_t t = 0; t < flat.triangles.size(); ++t) {
    auto& triangle = flat.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      if (triangle[k] != 0 || triangle[(k + 1) % 3] != 1) continue;
      const int apex = triangle[(k + 2) % 3];
      triangle = {0, 4, apex};
      flat.triangles.push_back({4, 1, apex});
      flat.triangles.push_back({0, 1, 4});
      t = flat.triangles.size();
      break;
    }
  }
  const MeshDefects defects = find_defects(flat);
  EXPECT_TRUE(defects.closed()) << defects.text();
  EXPECT_EQ(defects.degenerate_triangles, 1);
  EXPECT_FALSE(defects.sound());
}

TEST(RoundedToFloat, RoundsEveryCoordinate) {
  const TriangleMesh rounded =
      rounded_to_float(bodies::moved(bodies::octahedron(), 0.1 * Mat3::Identity(), {0.2, 0.3, 0.7}));
  for (const auto& p : rounded.vertices)
    for (const double x : p) EXPECT_EQ(x, static_cast<double>(static_cast<float>(x)));
  EXPECT_EQ(rounded.vertices[2].z(), static_cast<double>(static_cast<float>(0.1 + 0.7)));
}

TEST(MeshDefects, NothingIsNotASolid) { EXPECT_FALSE(find_defects({}).sound()); }

TEST(MeshDefects, AVertexThatIsNotThereBreaksTheContract) {
  TriangleMesh mesh = box_mesh();
  mesh.triangles[3][1] = 8;
  EXPECT_THROW(find_defects(mesh), ContractError);
}

}  // namespace mesh_test
}  // namespace nilas::geometry
