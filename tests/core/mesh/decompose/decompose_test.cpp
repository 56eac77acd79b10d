/// Convex parts: their count, how far they stand off, their symmetry.
#include "core/mesh/decompose/decompose.h"

#include <gtest/gtest.h>

#include <set>

#include "core/hull/hull.h"
#include "core/mesh/decompose/surface_distance.h"
#include "core/mesh/mend/mend.h"
#include "tests/core/mesh/hull_shapes.h"
#include "tests/support/scratch_folder.h"

namespace nilas::mesh {
namespace decompose_test {

/// A hull folder accepts the pieces: each is convex within the tolerance of read_hull().
void expect_readable(const geometry::TriangleMesh& mesh, const ConvexParts& parts) {
  const test::ScratchFolder folder;
  hull::write_hull({mesh, parts.parts}, folder.path(), "{}");
  EXPECT_EQ(hull::read_hull(folder.path()).parts.size(), parts.parts.size());
}

std::set<std::array<double, 3>> points_of(const geometry::TriangleMesh& mesh, double side) {
  std::set<std::array<double, 3>> points;
  for (const auto& p : mesh.vertices) points.insert({p.x(), side * p.y() + 0.0, p.z()});
  return points;
}

TEST(Decompose, ConvexSolidsStayOnePart) {
  const geometry::TriangleMesh wedge = hull::generate_hull(hull::hull_form("wedge", {{"triangles", 400}})).fluid;
  for (const auto& mesh : {cone_mesh(1, 1.5, 24), geometry::rounded_to_float(wedge)}) {
    const ConvexParts parts = decompose(mesh, {0.005, 64, true});
    ASSERT_EQ(parts.parts.size(), 1u);
    EXPECT_LT(parts.deviation.largest, 1e-6);
    EXPECT_NEAR(geometry::signed_volume(parts.parts[0]), geometry::signed_volume(mesh), 1e-6);
  }
}

TEST(Decompose, AMoonPoolLeavesFourPartsWithoutDeviation) {
  const geometry::TriangleMesh mesh = geometry::rounded_to_float(moonpool_mesh());
  const ConvexParts parts = decompose(mesh, {0.005, 64, true});
  EXPECT_EQ(parts.parts.size(), 4u);
  EXPECT_LT(parts.deviation.largest, 3 * 1e-6 * 4);        // The tolerance of coverage is three millionths of the size.
  EXPECT_NEAR(parts.table.front().deviation, 0.25, 0.03);  // one hull bridges the well: half its width
  expect_readable(mesh, parts);
}

TEST(Decompose, TheDeviationIsThatOfPlacedFaults) {
  const geometry::TriangleMesh box = box_mesh({0, 0, 0}, {2, 1, 1});
  EXPECT_LT(deviation_of({box}, box, 1e-4).largest, 1e-9);
  EXPECT_NEAR(deviation_of({box_mesh({0, 0, 0}, {2, 1, 1.03})}, box, 1e-4).largest, 0.03, 1e-4);
  // a part too short, and one missing: seen from the mesh
  EXPECT_NEAR(deviation_of({box_mesh({0, 0, 0}, {1.96, 1, 1})}, box, 1e-4).largest, 0.04, 1e-4);
  const std::vector<geometry::TriangleMesh> halves{box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({1, 0, 0}, {2, 1, 1})};
  EXPECT_LT(deviation_of(halves, box, 1e-4).largest, 1e-9);
  EXPECT_NEAR(deviation_of({halves[0]}, box, 1e-4).largest, 1, 1e-3);
}

TEST(Decompose, AShipWithHollowFlareHoldsItsToleranceSymmetrically) {
  const geometry::TriangleMesh ship = geometry::rounded_to_float(ship_mesh(24, 6));
  const ConvexParts parts = decompose(ship, {0.02, 64, true});
  EXPECT_LE(parts.deviation.largest, 0.02 * 1.2);
  EXPECT_GT(parts.parts.size(), 1u);
  expect_readable(ship, parts);
  std::multiset<std::set<std::array<double, 3>>> port, starboard;
  for (const auto& part : parts.parts) {
    port.insert(points_of(part, 1));
    starboard.insert(points_of(part, -1));
  }
  EXPECT_EQ(port, starboard);
  for (std::size_t k = 1; k < parts.table.size(); ++k)
    EXPECT_LT(parts.table[k].deviation, parts.table.front().deviation);
}

TEST(Decompose, ShellsThatLieApartAreJoinedWhereFewerPartsAreAllowed) {
  const auto apart = [](const std::vector<geometry::TriangleMesh>& shells) {
    SolidBuilder b;
    for (const auto& shell : shells)
      for (const auto& c : corners_of(shell)) b.triangle(c[0], c[1], c[2]);
    return b.take();
  };
  const geometry::TriangleMesh port = box_mesh({0, 1, 0}, {4, 2, 1}), starboard = box_mesh({0, -2, 0}, {4, -1, 1}),
                               wide = box_mesh({0, -2.5, 0}, {4, -1, 1}), middle = box_mesh({0, -0.5, 0}, {4, 0.5, 1});
  for (const auto& [mesh, symmetric, most] :
       {std::tuple{apart({port, starboard}), true, 1u}, std::tuple{apart({port, wide}), false, 1u},
        std::tuple{apart({port, starboard, middle}), true, 2u}}) {
    const ConvexParts parts = decompose(mesh, {0.004, most, symmetric});
    EXPECT_LE(parts.parts.size(), most);
    EXPECT_GT(parts.deviation.largest, 0.2);  // The pieces bridge the water between the hulls.
  }
}

TEST(Decompose, TheMirroredSurfaceDecidesOnSymmetry) {
  // sides that twist, cut along diagonals that are no images of each other: all corners have theirs on the surface
  const std::array<Vec3, 4> port{Vec3(0, 0.5, 0), Vec3(4, 0.8, 0), Vec3(4, 0.5, 1), Vec3(0, 0.8, 1)};
  std::array<Vec3, 4> starboard = port;
  for (auto& p : starboard) p.y() = -p.y();
  const auto twisted = [&](std::size_t first) {
    SolidBuilder b;
    const auto &p = port, &s = starboard;
    b.quad(p[first], p[(first + 3) % 4], p[(first + 2) % 4], p[(first + 1) % 4]);
    b.quad(s[1], s[2], s[3], s[0]);
    b.quad(p[0], p[1], s[1], s[0]);
    b.quad(p[3], s[3], s[2], p[2]);
    b.quad(p[0], s[0], s[3], p[3]);
    b.quad(p[1], p[2], s[2], s[1]);
    return b.take();
  };
  ASSERT_TRUE(geometry::find_defects(twisted(0)).sound());
  // middles of the diagonals: 0.5 and 0.8 off the centre plane, on faces that lean
  EXPECT_GT(asymmetry(twisted(0)), 0.25);
  EXPECT_LT(asymmetry(twisted(0)), 0.31);
  EXPECT_LT(asymmetry(twisted(1)), 1e-12);
  EXPECT_LT(asymmetry(ship_mesh(30, 6)), 1e-12);
  // flat sides cut along other diagonals are the same surface
  EXPECT_LT(asymmetry(box_mesh({0, -1, 0}, {4, 1, 1})), 1e-5);
  EXPECT_NEAR(asymmetry(box_mesh({0, -1, 0}, {4, 1.1, 1})), 0.1, 0.003);
}

TEST(Decompose, FewerPartsDeviateMore) {
  const geometry::TriangleMesh ship = geometry::rounded_to_float(ship_mesh(24, 6));
  const ConvexParts few = decompose(ship, {0.005, 2, true}), more = decompose(ship, {0.005, 6, true});
  EXPECT_LE(few.parts.size(), 2u);
  EXPECT_LE(more.parts.size(), 6u);
  EXPECT_LT(more.deviation.largest, few.deviation.largest);
}

}  // namespace decompose_test
}  // namespace nilas::mesh
